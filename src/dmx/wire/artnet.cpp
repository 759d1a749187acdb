// SPDX-License-Identifier: Apache-2.0
// Art-Net 4: packet header, ArtDmx, ArtPoll, ArtSync, ArtTimeCode, ArtTrigger.
#include "dmx/wire/packet.h"
#include "dmx/wire/timecode.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kArtnetIdentifier[8] = {'A', 'r', 't', '-', 'N', 'e', 't', 0};
constexpr std::uint16_t kPoll = 0x2000, kPollReply = 0x2100, kDmx = 0x5000, kSync = 0x5200,
                        kTimeCode = 0x9700, kTrigger = 0x9900;

SourceKey key_of(const IpAddress& from, std::uint8_t physical) {
    SourceKey key;
    key.protocol = Protocol::artnet;
    std::copy(from.bytes.begin() + 12, from.bytes.end(), key.id.begin());
    key.id[4] = physical;
    return key;
}

// Older senders end before the range, the oldest before the flags.
Parsed parse_poll(ByteReader reader) {
    PollPacket poll;
    if (reader.left() == 0 || (reader.u8() & 0x20) == 0) return poll;
    reader.skip(1);
    poll.last = reader.u16_be();
    poll.first = reader.u16_be();
    if (!reader.ok()) return Drop::too_short;
    return poll.first <= poll.last ? Parsed(poll) : Parsed(Drop::bad_value);
}

std::string text_of(Bytes bytes) {
    return {bytes.begin(), std::find(bytes.begin(), bytes.end(), std::uint8_t{0})};
}

// Carries no protocol version. Of interest is who brings levels into Art-Net: nodes that only give them out,
// and replies that end before they say it, are counted alone.
Parsed parse_poll_reply(ByteReader reader, const IpAddress& from, int universe_offset) {
    constexpr std::size_t kPorts = 4;
    constexpr std::uint8_t kBringsIn = 0x40, kSwitchedOff = 0x08;
    reader.skip(4 + 2 + 2); // address, port, version
    const int net = reader.u8() & 0x7F;
    const int sub_net = reader.u8() & 0x0F;
    reader.skip(2 + 1 + 1 + 2); // OEM, UBEA, Status1, ESTA
    const std::string short_name = text_of(reader.take(18)), long_name = text_of(reader.take(64));
    reader.skip(64); // report
    const std::size_t ports = std::min<std::size_t>(reader.u16_be(), kPorts);
    const Bytes types = reader.take(kPorts), inputs = reader.take(kPorts);
    reader.skip(kPorts); // GoodOutputA
    const Bytes addresses = reader.take(kPorts);
    if (!reader.ok()) return Notice::poll_reply;
    DiscoveryPacket packet;
    for (std::size_t i = 0; i < ports; ++i) {
        const int universe = (net << 8 | sub_net << 4 | (addresses[i] & 15)) + universe_offset;
        const bool brings_in = (types[i] & kBringsIn) != 0 && (inputs[i] & kSwitchedOff) == 0;
        if (brings_in && universe >= 1 && universe <= kMaxUniverse)
            packet.universes.push_back(static_cast<std::uint16_t>(universe));
    }
    if (packet.universes.empty()) return Notice::poll_reply;
    reader.skip(kPorts + 3 + 3 + 1 + 6 + 4); // SwOut; to Style; MAC, BindIp
    packet.source = key_of(from, reader.u8());
    packet.source_name = long_name.empty() ? short_name : long_name;
    packet.from = from;
    return packet;
}

Parsed parse_timecode(ByteReader reader) {
    TimeCode time;
    reader.skip(1);
    time.stream = reader.u8();
    time.frames = reader.u8();
    time.seconds = reader.u8();
    time.minutes = reader.u8();
    time.hours = reader.u8();
    const std::uint8_t rate = reader.u8();
    if (!reader.ok()) return Drop::too_short;
    time.rate = static_cast<TimeCode::Rate>(rate);
    return is_timecode(time) ? Parsed(time) : Parsed(Drop::bad_value);
}

Parsed parse_trigger(ByteReader reader) {
    Trigger trigger;
    reader.skip(2);
    trigger.oem = reader.u16_be();
    trigger.key = reader.u8();
    trigger.sub_key = reader.u8();
    return reader.ok() ? Parsed(trigger) : Parsed(Drop::too_short);
}

Parsed parse_dmx(ByteReader reader, const IpAddress& from, int universe_offset) {
    Packet packet;
    packet.protocol = Protocol::artnet;
    packet.from = from;
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
    packet.source = key_of(from, physical);

    // Odd lengths, 12 slots, payloads longer and shorter than said all exist in the field.
    const std::size_t slots = std::min({std::size_t{length}, reader.left(), kSlots});
    if (slots == 0 && length > 0) return Drop::too_short;
    packet.wrong_length = slots < length;
    const Bytes levels = reader.take(slots);
    std::copy(levels.begin(), levels.end(), packet.slots.begin());
    packet.slot_count = static_cast<std::uint16_t>(slots);
    return packet;
}

} // namespace

Parsed parse_artnet(Bytes bytes, const IpAddress& from, int universe_offset) {
    ByteReader reader(bytes);
    const Bytes identifier = reader.take(sizeof kArtnetIdentifier);
    const std::uint16_t opcode = reader.u16_le();
    if (!reader.ok()) return Drop::too_short;
    if (!std::equal(identifier.begin(), identifier.end(), kArtnetIdentifier)) return Drop::not_ours;
    if (opcode == kPollReply) return parse_poll_reply(reader, from, universe_offset);
    const std::uint16_t version = reader.u16_be();
    if (!reader.ok()) return Drop::too_short;
    if (version < 14) return Drop::bad_version;
    switch (opcode) {
    case kDmx:
        return parse_dmx(reader, from, universe_offset);
    case kPoll:
        return parse_poll(reader);
    case kSync:
        return SyncPacket{key_of(from, 0), 0, 0};
    case kTimeCode:
        return parse_timecode(reader);
    case kTrigger:
        return parse_trigger(reader);
    default:
        return Notice::other;
    }
}

} // namespace ghost::dmx
