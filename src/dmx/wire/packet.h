#pragma once
// SPDX-License-Identifier: Apache-2.0
// Packets from the network, parsed. Pure functions of the bytes; nothing that can be sent raises an error, a
// packet we do not use is a reason to count. sACN: ANSI E1.31-2018 sections 4 to 8 (data, synchronisation,
// universe discovery; of the draft too); Art-Net 4: ArtDmx, ArtSync, ArtPoll, ArtTimeCode, ArtTrigger.
// Universe numbers are ours (universes.h).

#include "base/byte_reader.h"
#include "dmx/wire/universes.h"
#include "net/address.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uint16_t kSacnPort = 5568;   // UDP
inline constexpr std::uint16_t kArtnetPort = 6454; // UDP

enum class Protocol : std::uint8_t { sacn, artnet, usb };
const char* protocol_name(Protocol protocol); // "sACN", "Art-Net", "USB"

// Who sends: the CID of an sACN source; of Art-Net the IPv4 address (4 bytes) and the Physical field (1
// byte); of USB the last 16 letters of the port. What a source sends for preview is another source.
struct SourceKey {
    Protocol protocol = Protocol::sacn;
    bool preview = false;
    std::array<std::uint8_t, 16> id{};

    auto operator<=>(const SourceKey&) const = default;
};

// Levels, or priorities per address.
struct Packet {
    Protocol protocol = Protocol::sacn;
    SourceKey source;
    std::string source_name;         // sACN: UTF-8 as sent, at most 63 bytes; USB: widget and port
    IpAddress from;                  // of the sender; none of USB
    std::uint16_t from_port = 0;     // of the sender; 0 = not told
    unsigned interface_index = 0;    // where it came in; 0 = not told
    bool wrong_group = false;        // it came by the multicast group of another universe
    bool wrong_length = false;       // it declares more levels than came, or than 512
    std::uint16_t universe = 0;      // 1..63999
    std::uint8_t priority = 100;     // 0..200; Art-Net has none and counts as 100
    std::uint8_t sequence = 0;       // Art-Net: 0 = the sender does not number its packets
    std::uint8_t start_code = 0;     // 0 = levels, 0xDD = priority per address (sACN)
    bool terminated = false;         // the source says it is leaving; its slots must not be used
    bool force_sync = false;         // sACN: go on without synchronisation where that was lost
    std::uint16_t sync_universe = 0; // sACN, not 0: hold until the source's sync packet of this universe
    std::uint16_t slot_count = 0;    // 0..512
    Levels slots{};                  // 0 beyond slot_count
};

// Of an sACN source, with a start code that we do not use.
struct Passing {
    SourceKey source;
    std::uint16_t universe = 0;
    std::uint8_t sequence = 0;
};

// "Show what you hold": of an sACN source and universe, or of an Art-Net sender (universe 0, Physical 0).
struct SyncPacket {
    SourceKey source;
    std::uint16_t universe = 0;
    std::uint8_t sequence = 0; // sACN
};

// A page of the list of universes that an sACN source sends, or those that somebody says in an ArtPollReply
// to bring into Art-Net: its ports of input that are not switched off (universe_offset as in parse_artnet).
struct DiscoveryPacket {
    SourceKey source;
    std::string source_name;
    IpAddress from;
    std::uint8_t page = 0, last_page = 0;
    std::vector<std::uint16_t> universes; // as sent, at most 512
};

// An Art-Net controller asks who is there. Only Port-Addresses first..last are meant where it says so.
struct PollPacket {
    std::uint16_t first = 0, last = 0x7FFF;
};

struct TimeCode {
    enum class Rate : std::uint8_t { film_24, ebu_25, drop_29_97, smpte_30 };
    std::uint8_t hours = 0, minutes = 0, seconds = 0, frames = 0;
    Rate rate = Rate::film_24;
    std::uint8_t stream = 0; // 0 = the master

    auto operator<=>(const TimeCode&) const = default;
};
std::string timecode_text(const TimeCode& time); // "01:02:03:04 EBU 25"

// Art-Net 4 ArtTrigger: key 0 ASCII, 1 macro, 2 soft key, 3 show; others are the manufacturer's (oem).
struct Trigger {
    std::uint16_t oem = 0xFFFF;
    std::uint8_t key = 0, sub_key = 0;

    auto operator<=>(const Trigger&) const = default;
};
std::string trigger_text(const Trigger& trigger); // "macro 5"

// Packets that are fine but carry no levels, by kind.
enum class Notice : std::uint8_t {
    sync,
    discovery,
    poll,
    poll_reply,
    timecode,
    trigger,
    other_start_code, // (told of by Passing) neither levels nor per-address priority
    other,
    kCount
};
// Packets we drop.
enum class Drop : std::uint8_t {
    too_short,    // ends before its header does, or with none of the levels that it declares
    not_ours,     // identifier of the protocol is missing
    bad_version,  // Art-Net protocol version below 14
    bad_vector,   // sACN layer vector or address type that is no level data
    bad_priority, // above 200
    bad_universe, // outside 1..63999 after numbering
    bad_value,    // a field outside its range: page, time
    kCount
};
const char* notice_name(Notice notice);
const char* drop_name(Drop drop);

using Parsed =
    std::variant<Packet, Passing, SyncPacket, DiscoveryPacket, PollPacket, TimeCode, Trigger, Notice, Drop>;
// What kind of packet without levels this is.
std::optional<Notice> notice_of(const Parsed& parsed);

Parsed parse_sacn(Bytes bytes, const IpAddress& from = {});
// Ghostlight universe = Port-Address + universe_offset.
Parsed parse_artnet(Bytes bytes, const IpAddress& from = {}, int universe_offset = 1);

} // namespace ghost::dmx
