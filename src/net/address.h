#pragma once
// SPDX-License-Identifier: Apache-2.0
// IpAddress: an IPv4 or IPv6 address as 16 bytes, IPv4 as ::ffff:a.b.c.d (RFC 4291 2.5.5.2), so that one type
// names every sender. All zero: none. Values only, safe on every thread.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <string>

namespace ghost::dmx {

struct IpAddress {
    std::array<std::uint8_t, 16> bytes{};

    constexpr IpAddress() = default;
    // Not explicit: an IPv4 address in host byte order is an address.
    constexpr IpAddress(std::uint32_t ipv4) {
        bytes[10] = bytes[11] = 0xFF;
        for (std::size_t i = 0; i < 4; ++i) bytes[12 + i] = static_cast<std::uint8_t>(ipv4 >> (24 - 8 * i));
    }
    constexpr explicit IpAddress(const std::array<std::uint8_t, 16>& all) : bytes(all) {}

    constexpr bool is_ipv4() const {
        return bytes[10] == 0xFF && bytes[11] == 0xFF &&
               std::all_of(bytes.begin(), bytes.begin() + 10, [](std::uint8_t b) { return b == 0; });
    }
    // Host byte order; 0 for IPv6.
    constexpr std::uint32_t ipv4() const {
        if (!is_ipv4()) return 0;
        return static_cast<std::uint32_t>(bytes[12]) << 24 | static_cast<std::uint32_t>(bytes[13]) << 16 |
               static_cast<std::uint32_t>(bytes[14]) << 8 | bytes[15];
    }
    constexpr bool is_multicast() const { return is_ipv4() ? bytes[12] >> 4 == 0xE : bytes[0] == 0xFF; }

    constexpr bool is_loopback() const {
        if (is_ipv4()) return bytes[12] == 127;
        return bytes[15] == 1 &&
               std::all_of(bytes.begin(), bytes.end() - 1, [](std::uint8_t b) { return b == 0; });
    }

    auto operator<=>(const IpAddress&) const = default;
};

// "10.0.0.2" or, as RFC 5952 writes it, "fe80::1"; "-" for none.
std::string address_text(const IpAddress& address);

} // namespace ghost::dmx
