#pragma once
// SPDX-License-Identifier: Apache-2.0
// Desks for tests of the merge: packets that count themselves.

#include "dmx/merge/merge.h"

#include <initializer_list>
#include <vector>

namespace ghost::dmx {

// One sACN source.
struct Desk {
    std::uint8_t id = 1;
    std::uint8_t priority = 100;
    std::uint16_t universe = 1;
    std::uint8_t sequence = 0;

    Packet packet(std::initializer_list<int> levels) {
        Packet result;
        result.source.id[0] = id;
        result.universe = universe;
        result.priority = priority;
        result.sequence = ++sequence;
        for (const int level : levels) result.slots[result.slot_count++] = static_cast<std::uint8_t>(level);
        return result;
    }
    Packet priorities(std::initializer_list<int> values) {
        Packet result = packet(values);
        result.start_code = 0xDD;
        return result;
    }
    Packet goodbye(std::initializer_list<int> levels = {}) {
        Packet result = packet(levels);
        result.terminated = true;
        return result;
    }
    Packet synchronised(std::uint16_t by, std::initializer_list<int> levels, bool force = false) {
        Packet result = packet(levels);
        result.sync_universe = by;
        result.force_sync = force;
        return result;
    }
    SyncPacket sync(std::uint16_t by) {
        SyncPacket result;
        result.source.id[0] = id;
        result.universe = by;
        result.sequence = ++sync_sequence;
        return result;
    }
    std::uint8_t sync_sequence = 0;
};

inline Packet art(std::uint8_t ip, std::uint8_t sequence, std::initializer_list<int> levels) {
    Desk desk{ip, 100, 1, static_cast<std::uint8_t>(sequence - 1)};
    Packet packet = desk.packet(levels);
    packet.protocol = packet.source.protocol = Protocol::artnet;
    return packet;
}

inline SyncPacket art_sync(std::uint8_t ip) {
    SyncPacket result;
    result.source.protocol = Protocol::artnet;
    result.source.id[0] = ip;
    return result;
}

using Ints = std::vector<int>;

inline Ints levels(Merge& merge, int count, std::uint16_t universe = 1) {
    Ints result;
    for (int address = 1; address <= count; ++address)
        result.push_back(merge.universes().level(universe, address));
    return result;
}

} // namespace ghost::dmx
