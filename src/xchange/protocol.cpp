// SPDX-License-Identifier: Apache-2.0
#include "xchange/protocol.h"

#include <algorithm>

namespace ghost::scene {

namespace {

constexpr std::uint32_t kMagic = 778682, kVersion = 1;

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

} // namespace

std::vector<std::uint8_t> build_xchange_header(XchangePayload payload, std::uint64_t bytes,
                                               std::uint32_t number, std::uint32_t count) {
    std::vector<std::uint8_t> out;
    for (const std::uint32_t value :
         {kMagic, kVersion, number, count, static_cast<std::uint32_t>(payload),
          static_cast<std::uint32_t>(bytes >> 32), static_cast<std::uint32_t>(bytes)})
        put_u32(out, value);
    return out;
}

Result<void> XchangeReader::begin_package() {
    ByteReader reader{Bytes(head_)};
    if (reader.u32_be() != kMagic) return Error{"is no MVR-xchange: a package begins with other bytes", ""};
    if (reader.u32_be() == 0) return Error{"a package of version 0", ""};
    std::uint32_t number = reader.u32_be(), count = reader.u32_be();
    // One table of the standard has the count first.
    if (number > count) std::swap(number, count);
    count = std::max(count, 1u);
    const std::uint32_t payload = reader.u32_be();
    const std::uint64_t high = reader.u32_be();
    const std::uint64_t length = high << 32 | reader.u32_be();
    head_.clear();
    if (payload > static_cast<std::uint32_t>(XchangePayload::file))
        return Error{"a package of kind " + std::to_string(payload) + ", expected 0 (message) or 1 (file)",
                     ""};
    if (number == count && count == 1) number = 0; // counted from 1
    if (number != next_number_ || number >= count || count > kMaxXchangePackages ||
        (number > 0 && (count != count_ || payload != static_cast<std::uint32_t>(payload_))))
        return Error{"package " + std::to_string(number) + " of " + std::to_string(count) + ", expected " +
                         std::to_string(next_number_),
                     ""};
    if (number == 0) {
        total_ = 0;
        json_.clear();
    }
    payload_ = static_cast<XchangePayload>(payload);
    count_ = count;
    last_ = number + 1 == count;
    next_number_ = last_ ? 0 : number + 1;
    const std::uint64_t limit =
        payload_ == XchangePayload::file ? kMaxXchangeFileBytes : kMaxXchangeMessageBytes;
    if (length > limit - total_)
        return Error{"a " + std::string(payload_ == XchangePayload::file ? "file" : "message") + " of " +
                         std::to_string(length) + " bytes, more than the limit of " + std::to_string(limit),
                     ""};
    left_ = length;
    total_ += length;
    return {};
}

Result<void> XchangeReader::take_content(Bytes content, const Sink& sink) {
    left_ -= content.size();
    const bool complete = left_ == 0 && last_;
    if (payload_ == XchangePayload::file) return sink.file(content, complete);
    json_.append(content.begin(), content.end());
    if (!complete) return {};
    const std::string json = std::move(json_);
    json_.clear();
    return sink.message(json);
}

Result<void> XchangeReader::take(Bytes bytes, const Sink& sink) {
    while (!bytes.empty()) {
        if (left_ == 0) {
            const std::size_t count = std::min(kXchangeHeaderBytes - head_.size(), bytes.size());
            head_.insert(head_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
            bytes = bytes.subspan(count);
            if (head_.size() < kXchangeHeaderBytes) return {};
            TRY_VOID(begin_package());
            if (left_ == 0) TRY_VOID(take_content({}, sink));
            continue;
        }
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
        TRY_VOID(take_content(bytes.first(count), sink));
        bytes = bytes.subspan(count);
    }
    return {};
}

std::string uuid_of(std::span<const std::string_view> parts) {
    // FNV-1a, twice; not against somebody who wants two things to look the same.
    constexpr std::uint64_t kPrime = 0x100000001B3ull;
    std::uint64_t hash[2] = {0xCBF29CE484222325ull, 0x9E3779B97F4A7C15ull};
    for (std::uint64_t& one : hash)
        for (const std::string_view part : parts) {
            for (const char letter : part) one = (one ^ static_cast<std::uint8_t>(letter)) * kPrime;
            one = (one ^ part.size()) * kPrime; // "a", "bc" is not "ab", "c"
        }
    std::string text;
    for (std::size_t i = 0; i < 32; ++i) {
        if (i == 8 || i == 12 || i == 16 || i == 20) text += '-';
        unsigned digit = static_cast<unsigned>(hash[i / 16] >> (4 * (i % 16))) & 0xF;
        if (i == 12) digit = 8;               // RFC 9562: version 8, our own way
        if (i == 16) digit = 8 | (digit & 3); // its variant
        text += "0123456789abcdef"[digit];
    }
    return text;
}

std::string plot_file_name(const std::string& wanted) {
    constexpr std::size_t kMostBytes = 120;
    std::string name;
    for (const char letter : wanted) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool plain =
            byte >= 0x80 || std::string_view("<>:\"/\\|?*").find(letter) == std::string_view::npos;
        name += byte >= 0x20 && byte != 0x7F && plain ? letter : '_';
    }
    const auto ends_in_mvr = [](const std::string& text) {
        std::string end = text.substr(text.size() < 4 ? 0 : text.size() - 4);
        for (char& letter : end) letter = static_cast<char>(letter | 0x20); // small letters, and a dot is one
        return end == ".mvr";
    };
    while (ends_in_mvr(name)) name.resize(name.size() - 4);
    if (name.size() > kMostBytes) {
        std::size_t end = kMostBytes; // not inside of a letter of UTF-8
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
        name.resize(end);
    }
    const std::size_t first = name.find_first_not_of(". ");
    const std::size_t last = name.find_last_not_of(". ");
    name = first == std::string::npos ? std::string() : name.substr(first, last - first + 1);
    return (name.empty() ? "plot" : name) + ".mvr";
}

} // namespace ghost::scene
