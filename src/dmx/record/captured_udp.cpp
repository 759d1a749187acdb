// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/private/captured_udp.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

using Found = std::variant<CapturedUdp, NoUdp>;

// tcpdump.org/linktypes.html
enum LinkType : std::uint32_t {
    kNull = 0,
    kEthernet = 1,
    kRawBsd = 12,
    kRawOpenBsd = 14,
    kRaw = 101,
    kLoop = 108,
    kLinuxCooked = 113,
    kIpv4Only = 228,
    kIpv6Only = 229,
    kLinuxCooked2 = 276,
};

constexpr std::uint8_t kUdp = 17;
constexpr int kMaxTags = 8, kMaxExtensions = 8;

bool is_vlan(std::uint16_t type) {
    return type == 0x8100 || type == 0x88A8 || type == 0x9100;
}

Found udp(ByteReader& reader, std::uint32_t from_ipv4) {
    CapturedUdp result;
    result.from_ipv4 = from_ipv4;
    reader.skip(2);
    result.to_port = reader.u16_be();
    const std::size_t length = reader.u16_be();
    reader.skip(2);
    if (reader.ok() && length < 8) return NoUdp::other;
    result.payload = reader.take(length - 8);
    if (!reader.ok()) return NoUdp::cut;
    return result;
}

Found ipv4(Bytes bytes) {
    ByteReader reader(bytes);
    const std::size_t header = (reader.u8() & 15u) * 4u;
    reader.skip(1);
    const std::size_t length = reader.u16_be();
    reader.skip(2);
    const std::uint16_t fragment = reader.u16_be();
    reader.skip(1);
    const std::uint8_t protocol = reader.u8();
    reader.skip(2);
    const std::uint32_t from = reader.u32_be();
    if (!reader.ok()) return NoUdp::cut;
    if (protocol != kUdp || header < 20) return NoUdp::other;
    if (fragment & 0x3FFF) return NoUdp::fragment; // more follow, or an offset
    if (length > bytes.size()) return NoUdp::cut;
    // Behind the packet Ethernet may have put padding. 0: the network card was to fill the length in.
    ByteReader rest(length >= header ? bytes.first(length) : bytes);
    rest.skip(header);
    return udp(rest, from);
}

Found ipv6(Bytes bytes) {
    ByteReader reader(bytes);
    reader.skip(4);
    const std::size_t length = reader.u16_be();
    std::uint8_t next = reader.u8();
    reader.skip(1 + 16 + 16);
    if (!reader.ok()) return NoUdp::cut;
    for (int i = 0; i < kMaxExtensions && (next == 0 || next == 43 || next == 60); ++i) {
        next = reader.u8();
        const std::size_t more = reader.u8();
        reader.skip(6 + more * 8);
    }
    if (next == 44) return NoUdp::fragment;
    if (next != kUdp) return reader.ok() ? NoUdp::other : NoUdp::cut;
    if (length > bytes.size() - 40) return NoUdp::cut;
    return udp(reader, 0);
}

Found ip(Bytes bytes) {
    if (bytes.empty()) return NoUdp::cut;
    switch (bytes[0] >> 4) {
    case 4:
        return ipv4(bytes);
    case 6:
        return ipv6(bytes);
    default:
        return NoUdp::other;
    }
}

Found by_type(std::uint16_t type, ByteReader& reader) {
    for (int i = 0; i < kMaxTags && is_vlan(type); ++i) {
        reader.skip(2);
        type = reader.u16_be();
    }
    if (!reader.ok()) return NoUdp::cut;
    return type == 0x0800 || type == 0x86DD ? ip(reader.take(reader.left())) : Found(NoUdp::other);
}

} // namespace

Found find_udp(const CapturedFrame& frame) {
    ByteReader reader(frame.bytes);
    switch (frame.link_type) {
    case kEthernet:
        reader.skip(12);
        return by_type(reader.u16_be(), reader);
    case kLinuxCooked:
        reader.skip(14);
        return by_type(reader.u16_be(), reader);
    case kLinuxCooked2: {
        const std::uint16_t type = reader.u16_be();
        reader.skip(18);
        return by_type(type, reader);
    }
    case kNull:
    case kLoop:
        reader.skip(4);
        return ip(reader.take(reader.left()));
    case kRaw:
    case kRawBsd:
    case kRawOpenBsd:
    case kIpv4Only:
    case kIpv6Only:
        return ip(frame.bytes);
    default:
        return NoUdp::unknown_link;
    }
}

} // namespace ghost::dmx
