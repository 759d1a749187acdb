// SPDX-License-Identifier: Apache-2.0
#include "files/crc32.h"

#include <array>

namespace ghost {

namespace {

constexpr std::size_t kStride = 8; // bytes per turn

using Tables = std::array<std::array<std::uint32_t, 256>, kStride>;

constexpr Tables make_tables() {
    Tables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) ? 0xEDB88320u : 0u);
        tables[0][i] = value;
    }
    for (std::size_t table = 1; table < kStride; ++table)
        for (std::size_t i = 0; i < 256; ++i) {
            const std::uint32_t before = tables[table - 1][i];
            tables[table][i] = (before >> 8) ^ tables[0][before & 0xFF];
        }
    return tables;
}

constexpr Tables kTables = make_tables();

} // namespace

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
    std::uint32_t value = ~before;
    while (bytes.size() >= kStride) {
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < kStride; ++i) {
            const auto mixed = static_cast<std::uint8_t>(bytes[i] ^ (i < 4 ? value >> (8 * i) : 0));
            next ^= kTables[kStride - 1 - i][mixed];
        }
        value = next;
        bytes = bytes.subspan(kStride);
    }
    for (const std::uint8_t byte : bytes) value = (value >> 8) ^ kTables[0][(value ^ byte) & 0xFF];
    return ~value;
}

} // namespace ghost
