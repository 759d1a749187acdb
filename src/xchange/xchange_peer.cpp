// SPDX-License-Identifier: Apache-2.0
#include "xchange/private/xchange_peer.h"

#include <algorithm>
#include <vector>

namespace ghost::app {

namespace {

constexpr std::size_t kMostUnread = 4u << 20;  // bytes that the other end leaves unread, files apart
constexpr std::size_t kMostWaitingFiles = 8;   // that wait to be sent
constexpr std::size_t kFileBytes = 256u << 10; // of a file in memory at a time
constexpr double kNoProgress_s = 30;
constexpr double kLongestMessage_s = 30;
constexpr int kReadsPerTurn = 64;                // of 64 KiB: others have their turn, too
constexpr std::size_t kSentPerTurn = 512u << 10; // twice, however fast it is read

} // namespace

void XchangePeer::say(const scene::XchangeMessage& message) {
    overfull_ = overfull_ || waiting_bytes() > kMostUnread;
    if (overfull_) return;
    const std::string text = scene::xchange_message_text(message);
    const auto header = scene::build_xchange_header(scene::XchangePayload::message, text.size());
    out_.append(header.begin(), header.end());
    out_ += text;
}

Result<void> XchangePeer::send_file(const std::filesystem::path& path) {
    if (files_.size() >= kMostWaitingFiles) return Error{"too many files were asked for at once", ""};
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) return Error{"is not there any more", path.string()};
    files_.push_back(path);
    return {};
}

// The next bytes of the file that is sent.
Result<void> XchangePeer::refill() {
    if (!file_.is_open()) {
        std::error_code code;
        const auto size = std::filesystem::file_size(files_.front(), code);
        file_.open(files_.front(), std::ios::binary);
        if (code || !file_) return Error{"cannot be read any more", files_.front().string()};
        file_left_ = size;
        const auto header = scene::build_xchange_header(scene::XchangePayload::file, size);
        out_.append(header.begin(), header.end());
    }
    std::vector<char> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(file_left_, kFileBytes)));
    file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<std::size_t>(file_.gcount()) != bytes.size())
        return Error{"got shorter while it was sent", files_.front().string()};
    out_.append(bytes.data(), bytes.size());
    file_left_ -= bytes.size();
    if (file_left_ > 0) return {};
    file_.close();
    files_.pop_front();
    return {};
}

// Who reads slowly but always something leaves out_ never empty. Half of it at a time, so that each byte is
// moved about once.
void XchangePeer::drop_sent() {
    if (out_sent_ <= out_.size() / 2) return;
    out_.erase(0, out_sent_);
    out_sent_ = 0;
}

Result<void> XchangePeer::send_what_goes(double now_s) {
    if (!has_to_send()) sent_s_ = now_s;
    if (overfull_ || waiting_bytes() > kMostUnread) return Error{"does not read what it is sent", ""};
    for (std::size_t left = kSentPerTurn; left > 0;) {
        if (out_sent_ == out_.size()) {
            out_.clear();
            out_sent_ = 0;
            if (files_.empty()) return {};
            TRY_VOID(refill());
        }
        const auto sent = stream_->send({reinterpret_cast<const std::uint8_t*>(out_.data()) + out_sent_,
                                         std::min(out_.size() - out_sent_, left)});
        if (!sent) return Error{};
        if (*sent > 0) sent_s_ = now_s;
        out_sent_ += *sent;
        left -= *sent;
        drop_sent();
        if (*sent == 0) break;
    }
    if (now_s - sent_s_ > kNoProgress_s) return Error{"does not read what it is sent", ""};
    return {};
}

Result<void> XchangePeer::turn(double now_s, const Sink& sink) {
    TRY_VOID(send_what_goes(now_s));
    const scene::XchangeReader::Sink inner{[&](std::string_view json) -> Result<void> {
                                               inside_since_s_ = -1;
                                               TRY(const auto message, scene::parse_xchange_message(json));
                                               sink.message(message);
                                               if (overfull_)
                                                   return Error{"does not read what it is sent", ""};
                                               return {};
                                           },
                                           [&](Bytes piece, bool last) -> Result<void> {
                                               inside_since_s_ = -1; // a file takes as long as it takes
                                               return sink.file(piece, last);
                                           }};
    for (int reads = 0; reads < kReadsPerTurn; ++reads) {
        const auto bytes = stream_->read();
        if (!bytes) return Error{};
        if (bytes->empty()) break;
        heard_s_ = now_s;
        TRY_VOID(reader_.take(*bytes, inner));
        if (reader_.inside() && inside_since_s_ < 0) inside_since_s_ = now_s;
        if (!reader_.inside()) inside_since_s_ = -1;
    }
    if (inside_since_s_ >= 0 && now_s - inside_since_s_ > kLongestMessage_s)
        return Error{"began a message and did not end it", ""};
    return send_what_goes(now_s);
}

} // namespace ghost::app
