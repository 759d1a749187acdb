#pragma once
// SPDX-License-Identifier: Apache-2.0
// Numbers as bytes for others, the counterpart of base/byte_reader.h.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ghost {

// Its low 16 bits, in network byte order.
inline void put_u16_be(std::vector<std::uint8_t>& out, std::size_t value) {
    out.push_back(static_cast<std::uint8_t>(value >> 8));
    out.push_back(static_cast<std::uint8_t>(value));
}

} // namespace ghost
