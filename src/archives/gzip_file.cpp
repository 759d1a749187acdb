// SPDX-License-Identifier: Apache-2.0
#include "archives/gzip_file.h"

#include "base/check.h"

#include <zlib.h>

namespace ghost::dmx {

namespace {

constexpr std::size_t kPackedBytes = 64u << 10, kWindowBytes = 256u << 10;
constexpr int kGzip = 16 + MAX_WBITS;
constexpr std::uint64_t kLeastBytes = 18; // of a gzip file

} // namespace

bool GzipFile::recognises(Bytes first_bytes) {
    return first_bytes.size() >= 3 && first_bytes[0] == 0x1F && first_bytes[1] == 0x8B && first_bytes[2] == 8;
}

GzipFile::GzipFile(std::ifstream file, std::uint64_t packed_bytes, std::uint64_t most_bytes)
    : file_(std::move(file)), most_bytes_(most_bytes), stream_(std::make_unique<z_stream_s>()) {
    CHECK(inflateInit2(stream_.get(), kGzip) == Z_OK); // memory alone could fail
    packed_.resize(kPackedBytes);
    if (packed_bytes >= kLeastBytes) {
        std::uint8_t last[4] = {};
        file_.seekg(-4, std::ios::end);
        file_.read(reinterpret_cast<char*>(last), sizeof last);
        told_size_ = ByteReader(Bytes(last)).u32_le();
    }
    restart();
}

GzipFile::~GzipFile() {
    inflateEnd(stream_.get());
}

void GzipFile::restart() {
    file_.clear();
    file_.seekg(0);
    inflateReset(stream_.get());
    stream_->avail_in = 0;
    window_.clear();
    offset_ = 0;
    ended_ = false;
}

// Replaces the window by what comes next. False: nothing does.
bool GzipFile::unpack_more() {
    if (ended_) return false;
    window_.resize(kWindowBytes);
    stream_->next_out = window_.data();
    stream_->avail_out = static_cast<uInt>(window_.size());
    const auto stop = [&](const char* why) {
        ended_ = true;
        if (why && !problem_)
            problem_ = std::string(why) + " after " +
                       std::to_string(offset_ + window_.size() - stream_->avail_out) + " unpacked bytes";
    };
    while (!ended_ && stream_->avail_out > 0) {
        if (stream_->avail_in == 0) {
            file_.read(reinterpret_cast<char*>(packed_.data()), static_cast<std::streamsize>(packed_.size()));
            stream_->next_in = packed_.data();
            stream_->avail_in = static_cast<uInt>(std::max<std::streamsize>(file_.gcount(), 0));
            if (stream_->avail_in == 0) {
                stop("the gzip file ends early");
                break;
            }
        }
        const int state = inflate(stream_.get(), Z_NO_FLUSH);
        if (state == Z_STREAM_END) {
            // Several in a row are one (RFC 1952, 2.2).
            if (stream_->avail_in == 0 && file_.peek() == std::ifstream::traits_type::eof())
                stop(nullptr);
            else
                inflateReset(stream_.get());
        } else if (state != Z_OK) {
            stop("the gzip file is damaged");
        }
    }
    window_.resize(window_.size() - stream_->avail_out);
    offset_ += window_.size();
    if (offset_ > most_bytes_) {
        window_.resize(window_.size() - static_cast<std::size_t>(offset_ - most_bytes_));
        offset_ = most_bytes_;
        ended_ = true;
        if (!problem_)
            problem_ = "the gzip file unpacks to more than the " + std::to_string(most_bytes_) +
                       " bytes that are read";
    }
    return !window_.empty();
}

std::size_t GzipFile::read(std::uint64_t offset, std::span<std::uint8_t> target) {
    if (offset < offset_ - window_.size()) restart();
    std::size_t done = 0;
    while (done < target.size()) {
        if (offset >= offset_) {
            if (!unpack_more()) break;
            continue;
        }
        const std::uint64_t skip = offset - (offset_ - window_.size());
        const auto count =
            static_cast<std::size_t>(std::min<std::uint64_t>(target.size() - done, window_.size() - skip));
        std::copy_n(window_.begin() + static_cast<std::ptrdiff_t>(skip), count,
                    target.begin() + static_cast<std::ptrdiff_t>(done));
        done += count;
        offset += count;
    }
    return done;
}

} // namespace ghost::dmx
