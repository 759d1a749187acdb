#pragma once
// SPDX-License-Identifier: Apache-2.0
// UDP payloads of a little-endian pcap file with Ethernet or raw IPv4 frames, for tests.

#include "base/byte_reader.h"
#include "disk/files.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ghost::dmx {

struct Captured {
    int frame; // from 1, as tshark counts
    std::chrono::nanoseconds time;
    std::uint16_t port;
    std::uint32_t from;
    std::vector<std::uint8_t> payload;
};

inline std::vector<Captured> read_pcap(const std::filesystem::path& path) {
    std::vector<Captured> result;
    const auto file = read_file(path, 64 << 20);
    if (!file.ok()) return result;
    ByteReader reader{Bytes(*file)};
    reader.skip(20);
    const std::size_t link_bytes = reader.u32_le() == 1 ? 14 : 0;
    for (int number = 1; reader.left() >= 16; ++number) {
        const auto seconds = std::chrono::seconds(reader.u32_le());
        const auto micros = std::chrono::microseconds(reader.u32_le());
        const std::uint32_t stored = reader.u32_le();
        reader.skip(4);
        const Bytes frame = reader.take(stored);
        if (frame.size() < link_bytes + 28) continue;
        ByteReader ip{frame.subspan(link_bytes)};
        const std::size_t header = (ip.u8() & 15u) * 4u;
        ip.skip(8);
        if (ip.u8() != 17) continue;
        ip.skip(2);
        const std::uint32_t from = ip.u32_be();
        ip.skip(header - 16 + 2);
        const std::uint16_t port = ip.u16_be();
        const std::size_t length = ip.u16_be();
        ip.skip(2);
        const Bytes payload = ip.take(std::min(ip.left(), length - 8));
        result.push_back({number, seconds + micros, port, from, {payload.begin(), payload.end()}});
    }
    return result;
}

} // namespace ghost::dmx
