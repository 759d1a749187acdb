#pragma once
// SPDX-License-Identifier: Apache-2.0
// The UDP datagram inside of a captured frame: Ethernet with VLAN tags, Linux cooked (v1, v2), loopback, raw
// IP; IPv4 and IPv6. Pure function.

#include "dmx/record/private/capture_file.h"

#include <variant>

namespace ghost::dmx {

struct CapturedUdp {
    std::uint32_t from_ipv4 = 0; // host byte order; 0 of IPv6
    std::uint16_t to_port = 0;
    Bytes payload;
};

// Why there is none.
enum class NoUdp : std::uint8_t {
    other,        // another protocol
    fragment,     // a part of an IP packet; they are not put together
    cut,          // the capture, or the file, kept less than there was
    unknown_link, // link type that is not read
};

std::variant<CapturedUdp, NoUdp> find_udp(const CapturedFrame& frame);

} // namespace ghost::dmx
