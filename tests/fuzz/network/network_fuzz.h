#pragma once
// SPDX-License-Identifier: Apache-2.0
// For the fuzzers of both protocols: an intake that lives as long as the run, so that odd sequences of
// packets meet, and the bounds that hold whatever comes. Input: packets, each behind two bytes of size and
// two that say how it came (time passed in tens of milliseconds; sender, and whether other universes are
// asked for from then on).

#include "base/byte_reader.h"
#include "dmx/receive/intake.h"

#include <cstdlib>

namespace ghost::dmx {

inline void check(bool holds) {
    if (!holds) std::abort();
}

inline void check_packet(const Parsed& parsed, std::size_t size, std::size_t header) {
    if (const Packet* packet = std::get_if<Packet>(&parsed)) {
        check(packet->universe >= 1 && packet->universe <= kMaxUniverse && packet->slot_count <= kSlots);
        check(packet->priority <= 200 && packet->slot_count + header <= size);
    }
    if (const auto* list = std::get_if<DiscoveryPacket>(&parsed)) check(list->universes.size() <= 512);
}

inline void check_bounds(Intake& intake, std::chrono::nanoseconds now) {
    const Universes& universes = intake.merge().universes();
    check(universes.list.size() <= kMaxUniverses);
    for (std::size_t i = 1; i < universes.list.size(); ++i)
        check(universes.list[i - 1].number < universes.list[i].number);
    Statistics statistics;
    intake.report(statistics, now);
    // Three universes are asked for at most, the first source of any other one has a place.
    check(statistics.sources.size() <= kMaxOtherSources + kMaxUniverses + 3 * kMaxSourcesPerUniverse);
    check(statistics.ignored.size() <= kMaxIgnored);
    for (const SourceStatus& source : statistics.sources) check(source.slots_held <= source.slot_count);
    check(statistics.sync.size() <= kMaxSyncStreams && statistics.discovered.size() <= kMaxDiscovered);
    check(statistics.triggers.size() <= kMaxRemembered);
}

inline IntakeOptions all_rules(int artnet_offset) {
    IntakeOptions options;
    options.artnet_offset = artnet_offset;
    options.merge.priority_wait = kPriorityWait;
    options.merge.show_preview = options.merge.artnet_ltp = true;
    options.merge.preview_universes = {1, 2, 256};
    options.merge.loss.black_after = std::chrono::seconds(1);
    return options;
}

// Feeds the packets of an input.
inline void feed_all(Intake& intake, Protocol protocol, Bytes input, std::size_t header, int artnet_offset) {
    static std::chrono::nanoseconds now{0};
    for (ByteReader reader(input); reader.left() >= 4;) {
        const std::size_t size = reader.u16_be() % 1400;
        now += std::chrono::milliseconds(10 * reader.u8());
        const std::uint8_t how = reader.u8();
        const std::uint32_t from = 0x0A000000u | (how & 3u);
        if (how >= 0xF8)
            intake.listen_to(how & 4 ? std::vector<std::uint16_t>{} : std::vector<std::uint16_t>{1, 2, 3});
        const Bytes bytes = reader.take(std::min(size, reader.left()));
        check_packet(protocol == Protocol::sacn ? parse_sacn(bytes, from)
                                                : parse_artnet(bytes, from, artnet_offset),
                     bytes.size(), header);
        (void)intake.take(bytes, {.protocol = protocol, .from = from, .to = 0x0A000005, .from_port = 0,
                                  .interface_index = from & 1u, .own = false, .time = now});
        intake.tick(now);
    }
    check_bounds(intake, now);
}

} // namespace ghost::dmx
