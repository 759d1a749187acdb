// SPDX-License-Identifier: Apache-2.0
// Art-Net 4: packet header and ArtDmx.
#include "dmx/packet.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kIdentifier[8] = {'A', 'r', 't', '-', 'N', 'e', 't', 0};
constexpr std::uint16_t kPoll = 0x2000, kPollReply = 0x2100, kDmx = 0x5000, kSync = 0x5200,
                        kTimeCode = 0x9700;

} // namespace

Parsed parse_artnet(Bytes bytes, std::uint32_t from_ipv4, int universe_offset) {
    ByteReader reader(bytes);
    const Bytes identifier = reader.take(sizeof kIdentifier);
    const std::uint16_t opcode = reader.u16_le();
    if (!reader.ok()) return Drop::too_short;
    if (!std::equal(identifier.begin(), identifier.end(), kIdentifier)) return Drop::not_ours;
    if (opcode == kPollReply) return Notice::poll_reply; // carries no protocol version
    const std::uint16_t version = reader.u16_be();
    if (!reader.ok()) return Drop::too_short;
    if (version < 14) return Drop::bad_version;
    if (opcode == kPoll) return Notice::poll;
    if (opcode == kSync) return Notice::sync;
    if (opcode == kTimeCode) return Notice::timecode;
    if (opcode != kDmx) return Notice::other;

    Packet packet;
    packet.protocol = Protocol::artnet;
    packet.from_ipv4 = from_ipv4;
    packet.sequence = reader.u8();
    const std::uint8_t physical = reader.u8();
    const std::uint8_t sub_uni = reader.u8();
    const std::uint8_t net = reader.u8();
    const std::uint16_t length = reader.u16_be();
    if (!reader.ok()) return Drop::too_short;
    if (net > 0x7F) return Drop::bad_universe;
    const int universe = ((net << 8) | sub_uni) + universe_offset;
    if (universe < 1 || universe > kMaxUniverse) return Drop::bad_universe;
    packet.universe = static_cast<std::uint16_t>(universe);
    packet.source.protocol = Protocol::artnet;
    for (std::size_t i = 0; i < 4; ++i)
        packet.source.id[i] = static_cast<std::uint8_t>(from_ipv4 >> (24 - 8 * i));
    packet.source.id[4] = physical;

    // Odd lengths, 12 slots and payloads longer than said all exist in the field; shorter ones were cut.
    const std::size_t slots = std::min(static_cast<std::size_t>(length), kSlots);
    const Bytes levels = reader.take(slots);
    if (!reader.ok()) return Drop::too_short;
    std::copy(levels.begin(), levels.end(), packet.slots.begin());
    packet.slot_count = static_cast<std::uint16_t>(slots);
    return packet;
}

} // namespace ghost::dmx
