#pragma once
// SPDX-License-Identifier: Apache-2.0
// ByteReader: reads numbers from bytes that somebody else sent. Reading past the end gives 0 and makes ok()
// false; it never touches memory outside the span.

#include <cstdint>
#include <span>

namespace ghost {

using Bytes = std::span<const std::uint8_t>;

class ByteReader {
public:
    explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

    bool ok() const { return ok_; }
    std::size_t position() const { return position_; }
    std::size_t left() const { return bytes_.size() - position_; }

    std::uint8_t u8() {
        const Bytes one = take(1);
        return one.empty() ? std::uint8_t{0} : one[0];
    }
    std::uint16_t u16_be() {
        const Bytes two = take(2);
        return two.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>((two[0] << 8) | two[1]);
    }
    std::uint16_t u16_le() {
        const Bytes two = take(2);
        return two.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>((two[1] << 8) | two[0]);
    }
    std::uint32_t u32_be() {
        const std::uint32_t high = u16_be();
        return (high << 16) | u16_be();
    }
    std::uint32_t u32_le() {
        const std::uint32_t low = u16_le();
        return low | (static_cast<std::uint32_t>(u16_le()) << 16);
    }
    // The next count bytes, or an empty span (and ok() false) where fewer are left.
    Bytes take(std::size_t count) {
        if (!ok_ || count > left()) {
            ok_ = false;
            return {};
        }
        const Bytes result = bytes_.subspan(position_, count);
        position_ += count;
        return result;
    }
    void skip(std::size_t count) { (void)take(count); }

private:
    Bytes bytes_;
    std::size_t position_ = 0;
    bool ok_ = true;
};

} // namespace ghost
