// SPDX-License-Identifier: Apache-2.0
// ANSI E1.31-2018 sections 4 to 8: root layer, and behind it data, synchronisation or universe discovery.
#include "dmx/wire/packet.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kAcnIdentifier[16] = {0x00, 0x10, 0x00, 0x00, 'A', 'S', 'C', '-',
                                             'E',  '1',  '.',  '1',  '7', 0,   0,   0};
constexpr std::uint32_t kRootData = 4, kRootExtended = 8;
constexpr std::uint32_t kFramingData = 2, kFramingSync = 1, kFramingDiscovery = 2;
constexpr std::uint32_t kFramingDraftDiscovery =
    4; // the 2014 draft, still sent by OLA 0.10.9, with the root of data

constexpr std::uint32_t kDiscoveryList = 1;
constexpr std::size_t kMaxListed = 512;

std::string name_of(Bytes name) {
    if (name.empty()) return {};
    return {name.begin(), std::find(name.begin(), std::prev(name.end()), std::uint8_t{0})};
}

Parsed parse_sync(ByteReader reader, const SourceKey& source) {
    SyncPacket packet;
    packet.source = source;
    packet.sequence = reader.u8();
    packet.universe = reader.u16_be();
    reader.skip(2); // reserved
    if (!reader.ok()) return Drop::too_short;
    if (packet.universe < 1 || packet.universe > kMaxUniverse) return Drop::bad_universe;
    return packet;
}

// draft: after the name comes the rest of a data packet's framing layer, then page, last page and list,
// without a layer of their own.
Parsed parse_discovery(ByteReader reader, const SourceKey& source, const IpAddress& from, bool draft) {
    DiscoveryPacket packet;
    packet.source = source;
    packet.from = from;
    packet.source_name = name_of(reader.take(64));
    if (draft) {
        reader.skip(7);
    } else {
        reader.skip(4 + 2); // reserved; flags and length
        if (reader.u32_be() != kDiscoveryList) return reader.ok() ? Drop::bad_vector : Drop::too_short;
    }
    packet.page = reader.u8();
    packet.last_page = reader.u8();
    if (!reader.ok() || reader.left() % 2 != 0) return Drop::too_short;
    if (packet.page > packet.last_page) return Drop::bad_value;
    while (reader.left() > 0 && packet.universes.size() < kMaxListed)
        packet.universes.push_back(reader.u16_be());
    return packet;
}

Parsed parse_data(ByteReader reader, const SourceKey& source, const IpAddress& from) {
    Packet packet;
    packet.protocol = Protocol::sacn;
    packet.source = source;
    packet.from = from;
    const Bytes name = reader.take(64);
    packet.priority = reader.u8();
    packet.sync_universe = reader.u16_be();
    packet.sequence = reader.u8();
    const std::uint8_t options = reader.u8();
    packet.universe = reader.u16_be();
    reader.skip(2);
    const std::uint8_t dmp_vector = reader.u8();
    const std::uint8_t address_type = reader.u8();
    const std::uint16_t first = reader.u16_be();
    const std::uint16_t increment = reader.u16_be();
    const std::uint16_t count = reader.u16_be();
    packet.start_code = reader.u8();
    if (!reader.ok() || count == 0) return Drop::too_short;
    if (dmp_vector != 2 || address_type != 0xA1 || first != 0 || increment != 1) return Drop::bad_vector;
    if (packet.priority > 200) return Drop::bad_priority;
    if (packet.universe < 1 || packet.universe > kMaxUniverse) return Drop::bad_universe;
    if (packet.start_code != 0x00 && packet.start_code != 0xDD)
        return Passing{source, packet.universe, packet.sequence};

    packet.source_name = name_of(name);
    packet.source.preview = (options & 0x80) != 0;
    packet.terminated = (options & 0x40) != 0;
    packet.force_sync = (options & 0x20) != 0;
    const std::size_t declared = static_cast<std::size_t>(count) - 1;
    const std::size_t slots = std::min({declared, reader.left(), kSlots});
    if (slots == 0 && declared > 0) return Drop::too_short;
    packet.wrong_length = slots < declared;
    const Bytes levels = reader.take(slots);
    std::copy(levels.begin(), levels.end(), packet.slots.begin());
    packet.slot_count = static_cast<std::uint16_t>(slots);
    return packet;
}

} // namespace

Parsed parse_sacn(Bytes bytes, const IpAddress& from) {
    ByteReader reader(bytes);
    const Bytes identifier = reader.take(sizeof kAcnIdentifier);
    if (!reader.ok()) return Drop::too_short;
    if (!std::equal(identifier.begin(), identifier.end(), kAcnIdentifier)) return Drop::not_ours;

    SourceKey source;
    source.protocol = Protocol::sacn;
    reader.skip(2); // flags and length: real senders get it wrong, so the size of the datagram decides
    const std::uint32_t root = reader.u32_be();
    const Bytes cid = reader.take(source.id.size());
    reader.skip(2);
    const std::uint32_t framing = reader.u32_be();
    if (!reader.ok()) return Drop::too_short;
    std::copy(cid.begin(), cid.end(), source.id.begin());
    if (root == kRootExtended && framing == kFramingSync) return parse_sync(reader, source);
    if (root == kRootExtended && framing == kFramingDiscovery)
        return parse_discovery(reader, source, from, false);
    if (root == kRootData && framing == kFramingDraftDiscovery)
        return parse_discovery(reader, source, from, true);
    if (root == kRootData && framing == kFramingData) return parse_data(reader, source, from);
    return Drop::bad_vector;
}

} // namespace ghost::dmx
