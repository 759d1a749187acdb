// SPDX-License-Identifier: Apache-2.0
// Any bytes as an sACN packet, then into a merge that lives as long as the run, so that odd sequences of
// packets meet too.
#include "dmx/merge.h"

#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    static Merge merge;
    static std::chrono::nanoseconds now{0};
    const Parsed parsed = parse_sacn({data, size}, 0x7F000001);
    if (const Packet* packet = std::get_if<Packet>(&parsed)) {
        if (packet->universe < 1 || packet->universe > kMaxUniverse || packet->slot_count > kSlots)
            std::abort();
        if (packet->priority > 200 || packet->slot_count + 126u > size) std::abort();
        now += std::chrono::milliseconds(packet->slots[0] * 20);
        merge.feed(*packet, now);
        merge.tick(now);
        const Universes& universes = merge.universes();
        if (universes.list.size() > kMaxUniverses) std::abort();
        for (std::size_t i = 1; i < universes.list.size(); ++i)
            if (universes.list[i - 1].number >= universes.list[i].number) std::abort();
    }
    return 0;
}
