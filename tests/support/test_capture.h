#pragma once
// SPDX-License-Identifier: Apache-2.0
// Captures made byte by byte: pcap and pcapng of either byte order around frames of every link type that is
// read.
#include "dmx/wire/build.h"
#include "support/test_recording.h"

namespace ghost::dmx {

using ByteList = std::vector<std::uint8_t>;

inline void add_number(ByteList& out, std::uint64_t value, int bytes, bool big_endian) {
    for (int i = 0; i < bytes; ++i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * (big_endian ? bytes - 1 - i : i))));
}

inline void add_bytes(ByteList& out, const ByteList& more) {
    out.insert(out.end(), more.begin(), more.end());
}

inline ByteList udp_of(const ByteList& payload, std::uint16_t port) {
    ByteList out;
    add_number(out, 40000, 2, true);
    add_number(out, port, 2, true);
    add_number(out, payload.size() + 8, 2, true);
    add_number(out, 0, 2, true);
    add_bytes(out, payload);
    return out;
}

// fragment: the field with flags and offset.
inline ByteList ipv4_of(const ByteList& udp, std::uint16_t fragment = 0, std::uint8_t protocol = 17) {
    ByteList out = {0x46, 0}; // with 4 bytes of options
    add_number(out, udp.size() + 24, 2, true);
    add_number(out, 7, 2, true);
    add_number(out, fragment, 2, true);
    add_bytes(out, {64, protocol, 0, 0, 10, 0, 0, 9, 239, 255, 0, 1, 1, 1, 1, 1});
    add_bytes(out, udp);
    return out;
}

inline ByteList ipv6_of(const ByteList& udp) {
    ByteList out = {0x60, 0, 0, 0};
    add_number(out, udp.size() + 8, 2, true);
    add_bytes(out, {0, 64}); // hop-by-hop options follow
    out.resize(out.size() + 32, 1);
    add_bytes(out, {17, 0, 1, 4, 0, 0, 0, 0});
    add_bytes(out, udp);
    return out;
}

inline ByteList ethernet_of(const ByteList& ip, int tags = 0) {
    ByteList out(12, 2);
    for (int i = 0; i < tags; ++i) {
        add_number(out, i == 0 ? 0x88A8 : 0x8100, 2, true);
        add_number(out, 5, 2, true);
    }
    add_number(out, ip.at(0) >> 4 == 6 ? 0x86DD : 0x0800, 2, true);
    add_bytes(out, ip);
    return out;
}

struct TestPacket {
    std::chrono::nanoseconds time{0};
    ByteList bytes;
    std::size_t kept = SIZE_MAX; // of bytes, by the capture
};

inline ByteList pcap_of(const std::vector<TestPacket>& packets, std::uint32_t link_type = 1,
                        bool big_endian = false, bool nanoseconds = false) {
    ByteList out;
    add_number(out, nanoseconds ? 0xA1B23C4D : 0xA1B2C3D4, 4, big_endian);
    add_number(out, 2, 2, big_endian);
    add_number(out, 4, 2, big_endian);
    add_number(out, 0, 8, big_endian);
    add_number(out, 65535, 4, big_endian);
    add_number(out, link_type, 4, big_endian);
    for (const TestPacket& packet : packets) {
        const auto ns = static_cast<std::uint64_t>(packet.time.count());
        const std::size_t kept = std::min(packet.kept, packet.bytes.size());
        add_number(out, ns / 1'000'000'000, 4, big_endian);
        add_number(out, ns % 1'000'000'000 / (nanoseconds ? 1 : 1000), 4, big_endian);
        add_number(out, kept, 4, big_endian);
        add_number(out, packet.bytes.size(), 4, big_endian);
        out.insert(out.end(), packet.bytes.begin(), packet.bytes.begin() + static_cast<std::ptrdiff_t>(kept));
    }
    return out;
}

inline void add_block(ByteList& out, std::uint32_t type, ByteList body, bool big_endian) {
    body.resize((body.size() + 3) / 4 * 4);
    add_number(out, type, 4, big_endian);
    add_number(out, body.size() + 12, 4, big_endian);
    add_bytes(out, body);
    add_number(out, body.size() + 12, 4, big_endian);
}

// Two interfaces: 0 with microseconds, 1 with 2^-20 s and an offset of 1000 s; packets in turn. With a name
// block and a block of no known type between.
inline ByteList pcapng_of(const std::vector<TestPacket>& packets, std::uint32_t link_type = 1,
                          bool big_endian = false) {
    ByteList out, body;
    add_number(body, 0x1A2B3C4D, 4, big_endian);
    add_number(body, 1, 2, big_endian);
    add_number(body, 0, 2, big_endian);
    add_number(body, UINT64_MAX, 8, big_endian);
    add_block(out, 0x0A0D0D0A, body, big_endian);
    for (const bool second : {false, true}) {
        body.clear();
        add_number(body, link_type, 2, big_endian);
        add_number(body, 0, 6, big_endian);
        add_number(body, 2, 2, big_endian); // a name
        add_number(body, 5, 2, big_endian);
        add_bytes(body, {'e', 't', 'h', '0', 0, 0, 0, 0});
        if (second) {
            add_number(body, 9, 2, big_endian);
            add_number(body, 1, 2, big_endian);
            add_bytes(body, {0x80 | 20, 0, 0, 0});
            add_number(body, 14, 2, big_endian);
            add_number(body, 8, 2, big_endian);
            add_number(body, 1000, 8, big_endian);
        }
        add_number(body, 0, 4, big_endian);
        add_block(out, 1, body, big_endian);
    }
    add_block(out, 4, {0, 0, 0, 0}, big_endian);
    add_block(out, 0x0BAD, {}, big_endian);
    std::uint32_t interface = 0;
    for (const TestPacket& packet : packets) {
        const auto ns = static_cast<std::uint64_t>(packet.time.count());
        const std::uint64_t ticks = interface == 0
                                        ? ns / 1000
                                        : ((ns - 1000'000'000'000) / 1'000'000'000 << 20) +
                                              (ns % 1'000'000'000 * (1 << 20) + 500'000'000) / 1'000'000'000;
        body.clear();
        add_number(body, interface, 4, big_endian);
        add_number(body, ticks >> 32, 4, big_endian);
        add_number(body, ticks & 0xFFFFFFFF, 4, big_endian);
        add_number(body, packet.bytes.size(), 4, big_endian);
        add_number(body, packet.bytes.size(), 4, big_endian);
        add_bytes(body, packet.bytes);
        add_block(out, 6, body, big_endian);
        interface ^= 1;
    }
    return out;
}

} // namespace ghost::dmx
