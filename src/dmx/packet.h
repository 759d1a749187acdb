#pragma once
// SPDX-License-Identifier: Apache-2.0
// Level packets from the network, parsed. Pure functions of the bytes; nothing that can be sent raises an
// error, a packet we do not use is a reason to count. sACN: ANSI E1.31-2018 (sections 4 to 7); Art-Net:
// Art-Net 4 (ArtDmx). Universe numbers are ours (universes.h).

#include "base/byte_reader.h"
#include "dmx/universes.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace ghost::dmx {

enum class Protocol : std::uint8_t { sacn, artnet };
const char* protocol_name(Protocol protocol); // "sACN", "Art-Net"

// Who sends: the CID of an sACN source; of Art-Net the IPv4 address (4 bytes) and the Physical field (1
// byte).
struct SourceKey {
    Protocol protocol = Protocol::sacn;
    std::array<std::uint8_t, 16> id{};

    auto operator<=>(const SourceKey&) const = default;
};

struct Packet {
    Protocol protocol = Protocol::sacn;
    SourceKey source;
    std::string source_name;         // sACN only; UTF-8 as sent, at most 63 bytes
    std::uint32_t from_ipv4 = 0;     // sender's address, host byte order
    std::uint16_t universe = 0;      // 1..63999
    std::uint8_t priority = 100;     // 0..200; Art-Net has none and counts as 100
    std::uint8_t sequence = 0;       // Art-Net: 0 = the sender does not number its packets
    std::uint8_t start_code = 0;     // 0 = levels, 0xDD = priority per address (sACN)
    bool preview = false;            // not for live output
    bool terminated = false;         // the source says it is leaving; its slots must not be used
    std::uint16_t sync_universe = 0; // not 0: the source also sends sync packets
    std::uint16_t slot_count = 0;    // 0..512
    Levels slots{};                  // 0 beyond slot_count
};

// Packets that are fine but carry no levels.
enum class Notice : std::uint8_t { sync, discovery, poll, poll_reply, timecode, other, kCount };
// Packets we drop.
enum class Drop : std::uint8_t {
    too_short,      // ends before its header or the levels that it declares do
    not_ours,       // identifier of the protocol is missing
    bad_version,    // Art-Net protocol version below 14
    bad_vector,     // sACN layer vector or address type that is no level data
    bad_priority,   // above 200
    bad_universe,   // outside 1..63999 after numbering
    bad_start_code, // neither levels nor per-address priority
    kCount
};
const char* notice_name(Notice notice);
const char* drop_name(Drop drop);

using Parsed = std::variant<Packet, Notice, Drop>;

Parsed parse_sacn(Bytes bytes, std::uint32_t from_ipv4 = 0);
// Ghostlight universe = Port-Address + universe_offset.
Parsed parse_artnet(Bytes bytes, std::uint32_t from_ipv4 = 0, int universe_offset = 1);

} // namespace ghost::dmx
