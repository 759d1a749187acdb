#pragma once
// SPDX-License-Identifier: Apache-2.0
// Packets we send: levels as sACN (ANSI E1.31-2018) or ArtDmx, and ArtPollReply (Art-Net 4, 239 bytes, one
// port each); for tests also synchronisation and discovery. Pure; bytes as they go on the wire.

#include "dmx/wire/packet.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ghost::dmx {

// Who sends, of all its packets (ANSI E1.31-2018 5.6, 6.2.2, 6.2.3).
struct SacnSource {
    std::uint8_t priority = 100;
    std::array<std::uint8_t, 16> cid{};
    std::string name;
};

struct SacnExtras {
    std::uint8_t options = 0; // 0x80 preview, 0x40 stream terminated, 0x20 force synchronisation
    std::uint8_t start_code = 0;
    std::uint16_t sync_universe = 0; // 0: not synchronised
};

// slots: at most 512, sent as they are.
std::vector<std::uint8_t> build_sacn(std::uint16_t universe, Bytes slots, std::uint8_t sequence,
                                     const SacnSource& source, const SacnExtras& extras = {});
std::vector<std::uint8_t> build_sacn_sync(std::uint16_t universe, std::uint8_t sequence,
                                          const std::array<std::uint8_t, 16>& cid);
// One page: at most 512 universes.
std::vector<std::uint8_t> build_sacn_discovery(std::span<const std::uint16_t> universes, std::uint8_t page,
                                               std::uint8_t last_page,
                                               const std::array<std::uint8_t, 16>& cid,
                                               const std::string& source_name);

// port_address: 15 bits. An odd number of slots gets one more, of level 0 (Art-Net lengths are even).
std::vector<std::uint8_t> build_artdmx(std::uint16_t port_address, Bytes slots, std::uint8_t sequence);

inline constexpr std::size_t kMaxPortsPerReply = 4;

struct PollReply {
    struct Port {
        std::uint16_t address = 0; // all of a reply share all but the last four bits
        bool receiving = false;    // levels arrive for it right now
        bool merging = false;      // of two Art-Net sources
    };
    std::uint32_t ipv4 = 0;      // ours, host byte order
    bool rdm = false;            // devices behind the ports answer RDM
    std::vector<Port> ports;     // 1 to 4
    std::uint8_t bind_index = 1; // 1-based
    bool ltp = false;            // two sources merge latest-takes-precedence
    std::string short_name;      // at most 17 bytes are sent
    std::string long_name;       // at most 63
    std::string report;          // at most 63
};
std::array<std::uint8_t, 239> build_poll_reply(const PollReply& reply);

// The multicast group of a universe, 239.255.hi.lo, host byte order.
constexpr std::uint32_t sacn_group(std::uint16_t universe) {
    return 0xEFFF0000u | universe;
}
// IPv6: ff18::8300:hilo (bytes ff 18, ten of 0, 83 00, universe), as ETC's sACN reads E1.31-2018 9.3.2.
constexpr IpAddress sacn_group_address(std::uint16_t universe, bool ipv6) {
    if (!ipv6) return sacn_group(universe);
    std::array<std::uint8_t, 16> bytes{0xFF, 0x18};
    bytes[12] = 0x83;
    bytes[14] = static_cast<std::uint8_t>(universe >> 8);
    bytes[15] = static_cast<std::uint8_t>(universe);
    return IpAddress(bytes);
}

} // namespace ghost::dmx
