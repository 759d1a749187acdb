// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/private/capture_file.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::dmx {

namespace {

using std::chrono::nanoseconds;

constexpr std::size_t kMaxFrameBytes = 16u << 20;
constexpr std::size_t kMaxInterfaces = 4096;
constexpr std::size_t kMaxListed = 20; // problems
constexpr std::size_t kReadBytes = 1u << 20;
constexpr std::int64_t kLastSecond = 1ll << 32; // in the year 2106, where pcap ends as well

constexpr std::uint32_t kMicroseconds = 0xA1B2C3D4, kNanoseconds = 0xA1B23C4D;
constexpr std::uint32_t kSection = 0x0A0D0D0A, kByteOrder = 0x1A2B3C4D;
constexpr std::uint32_t kInterface = 1, kOldPacket = 2, kSimplePacket = 3, kPacket = 6;
constexpr std::uint16_t kOptionResolution = 9, kOptionOffset = 14;

std::size_t padded(std::size_t size) {
    return (size + 3) & ~std::size_t{3};
}

nanoseconds time_of(std::uint64_t ticks, std::uint8_t resolution, std::int64_t offset_s) {
    const int digits = resolution & 0x7F;
    const double per_second = resolution & 0x80 ? std::ldexp(1.0, digits) : std::pow(10.0, digits);
    std::int64_t seconds = 0, nanos = 0;
    if (!(resolution & 0x80) && digits <= 18) {
        std::uint64_t exact = 1;
        for (int i = 0; i < digits; ++i) exact *= 10;
        seconds = static_cast<std::int64_t>(std::min<std::uint64_t>(ticks / exact, 1ull << 40));
        const std::uint64_t rest = ticks % exact;
        nanos = static_cast<std::int64_t>(digits <= 9 ? rest * (1'000'000'000 / exact)
                                                      : rest / (exact / 1'000'000'000));
    } else {
        const double t_s = std::min(static_cast<double>(ticks) / per_second, 1e12);
        seconds = static_cast<std::int64_t>(t_s);
        nanos = static_cast<std::int64_t>((t_s - static_cast<double>(seconds)) * 1e9);
    }
    const std::int64_t offset = std::clamp<std::int64_t>(offset_s, -kLastSecond, kLastSecond);
    return std::chrono::seconds(std::clamp<std::int64_t>(seconds + offset, 0, kLastSecond)) +
           nanoseconds(nanos);
}

} // namespace

bool CaptureFile::recognises(Bytes first_bytes) {
    ByteReader little(first_bytes), big(first_bytes);
    const std::uint32_t one = little.u32_le(), other = big.u32_be();
    const auto is = [&](std::uint32_t magic) { return one == magic || other == magic; };
    return little.ok() && (is(kMicroseconds) || is(kNanoseconds) || is(kSection));
}

CaptureFile::CaptureFile(ByteSource& source, std::string name) : source_(source), name_(std::move(name)) {
    std::array<std::uint8_t, 4> magic{};
    source_.read(0, magic);
    ByteReader big{Bytes(magic)}, little{Bytes(magic)};
    const std::uint32_t value = big.u32_be();
    next_generation_ = value == kSection;
    big_endian_ = value == kMicroseconds || value == kNanoseconds;
    nanoseconds_ = value == kNanoseconds || little.u32_le() == kNanoseconds;
    if (!next_generation_) read_pcap_header();
}

double CaptureFile::share() const {
    const std::uint64_t done = offset_ - (buffer_.size() - used_);
    return source_.size() ? std::min(1.0, static_cast<double>(done) / static_cast<double>(source_.size()))
                          : 1.0;
}

void CaptureFile::stop(const std::string& what) {
    stopped_ = true;
    const std::uint64_t here = offset_ - (buffer_.size() - used_);
    const std::uint64_t rest = source_.size() - std::min(here, source_.size());
    const std::string size = source_.is_gzip() ? "" : ", about " + std::to_string(rest) + " bytes,";
    problems_.push_back(
        {what + "; what follows" + size + " is left out", name_ + ", byte " + std::to_string(here)});
}

Bytes CaptureFile::take(std::size_t count) {
    while (buffer_.size() - used_ < count) {
        buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ = 0;
        // Never more than there is: files declare sizes that they do not have.
        const std::uint64_t left =
            source_.is_gzip() ? kReadBytes : source_.size() - std::min(offset_, source_.size());
        const std::size_t held = buffer_.size();
        buffer_.resize(held + static_cast<std::size_t>(std::min<std::uint64_t>(left, kReadBytes)));
        const std::size_t got = source_.read(offset_, std::span(buffer_).subspan(held));
        offset_ += got;
        buffer_.resize(held + got);
        if (got == 0) return {};
    }
    used_ += count;
    return Bytes(buffer_).subspan(used_ - count, count);
}

void CaptureFile::read_pcap_header() {
    const Bytes bytes = take(24);
    if (bytes.empty()) return stop("ends inside of its header");
    ByteReader reader(bytes);
    reader.skip(20);
    interfaces_.push_back({u32(reader) & 0xFFFF}); // above it the length of checksums
}

std::optional<CapturedFrame> CaptureFile::next() {
    if (stopped_) return std::nullopt;
    return next_generation_ ? next_pcapng() : next_pcap();
}

std::optional<CapturedFrame> CaptureFile::next_pcap() {
    const bool any = used_ < buffer_.size() || offset_ < source_.size();
    const Bytes head = take(16);
    if (head.empty()) {
        if (any) stop("ends inside of a packet");
        stopped_ = true;
        return std::nullopt;
    }
    ByteReader reader(head);
    const std::uint32_t seconds = u32(reader), fraction = u32(reader), kept = u32(reader),
                        whole = u32(reader);
    if (kept > kMaxFrameBytes) {
        stop("has a packet of " + std::to_string(kept) + " bytes, expected 16 MiB at most");
        return std::nullopt;
    }
    time_ = std::chrono::seconds(seconds) + nanoseconds(std::int64_t{fraction} * (nanoseconds_ ? 1 : 1000));
    const Bytes bytes = take(kept);
    if (bytes.size() < kept) {
        stop("ends inside of a packet");
        return std::nullopt;
    }
    return CapturedFrame{time_, interfaces_.front().link_type, bytes, kept < whole};
}

bool CaptureFile::begin_section(Bytes head) {
    ByteReader reader(head.subspan(8));
    const std::uint32_t order = reader.u32_be();
    big_endian_ = order == kByteOrder;
    interfaces_.clear();
    ByteReader little(head.subspan(8));
    return big_endian_ || little.u32_le() == kByteOrder;
}

std::optional<CapturedFrame> CaptureFile::next_pcapng() {
    for (;;) {
        const bool any = used_ < buffer_.size() || offset_ < source_.size();
        const Bytes head =
            take(12); // of a section with its byte order, of the others with 4 bytes of the body
        if (head.empty()) {
            if (any) stop("ends inside of a block");
            stopped_ = true;
            return std::nullopt;
        }
        ByteReader reader(head);
        const std::uint32_t type = u32(reader);
        if (type == kSection && !begin_section(head)) {
            stop("has a section of no byte order");
            return std::nullopt;
        }
        const std::uint32_t size = u32(reader);
        if (size < 12 || size % 4 != 0 || size > kMaxFrameBytes || (type == kSection && size < 28)) {
            stop("has a block of " + std::to_string(size) + " bytes, expected 12 to 16 MiB");
            return std::nullopt;
        }
        std::array<std::uint8_t, 4> first{};
        std::copy_n(head.begin() + 8, 4, first.begin());
        if (size == 12) continue; // no body: those 4 bytes were the length again
        const Bytes rest = take(size - 12);
        if (rest.empty()) {
            stop("ends inside of a block");
            return std::nullopt;
        }
        // The first four bytes may have left the buffer meanwhile.
        body_.assign(first.begin(), first.end());
        body_.insert(body_.end(), rest.begin(), rest.end() - 4);
        if (type == kInterface) read_interface(body_);
        if (type != kPacket && type != kSimplePacket && type != kOldPacket) continue;
        if (auto frame = read_packet(type, body_)) return frame;
    }
}

void CaptureFile::read_interface(Bytes body) {
    if (interfaces_.size() == kMaxInterfaces) return;
    ByteReader reader(body);
    Interface interface;
    interface.link_type = u16(reader);
    reader.skip(6);
    while (reader.ok() && reader.left() >= 4) {
        const std::uint16_t code = u16(reader), length = u16(reader);
        const Bytes value = reader.take(padded(length));
        if (code == 0 || !reader.ok()) break;
        ByteReader number(value);
        if (code == kOptionResolution && length == 1) interface.resolution = number.u8();
        if (code == kOptionOffset && length == 8) {
            const std::uint64_t one = u32(number), two = u32(number);
            interface.offset_s = static_cast<std::int64_t>(big_endian_ ? one << 32 | two : two << 32 | one);
        }
    }
    interfaces_.push_back(interface);
}

// Nothing where the block is no whole packet of a known interface; the next one may be.
std::optional<CapturedFrame> CaptureFile::read_packet(std::uint32_t type, Bytes body) {
    ByteReader reader(body);
    std::uint32_t number = 0, kept = 0, whole = 0;
    std::uint64_t ticks = 0;
    if (type == kSimplePacket) {
        whole = u32(reader);
        kept = static_cast<std::uint32_t>(std::min<std::size_t>(whole, reader.left()));
    } else {
        number = type == kPacket ? u32(reader) : u16(reader);
        if (type == kOldPacket) reader.skip(2);
        ticks = u32(reader);
        ticks = ticks << 32 | u32(reader);
        kept = u32(reader);
        whole = u32(reader);
    }
    const Bytes bytes = reader.take(kept);
    if (!reader.ok() || number >= interfaces_.size()) {
        if (problems_.size() < kMaxListed)
            problems_.push_back(
                {"has a packet block that is too short, or of an interface that is not declared",
                 name_ + ", before byte " + std::to_string(offset_ - (buffer_.size() - used_))});
        return std::nullopt;
    }
    const Interface& interface = interfaces_[number];
    if (type != kSimplePacket) time_ = time_of(ticks, interface.resolution, interface.offset_s);
    return CapturedFrame{time_, interface.link_type, bytes, kept < whole};
}

} // namespace ghost::dmx
