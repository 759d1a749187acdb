// SPDX-License-Identifier: Apache-2.0
// The first two bytes choose the universe offset, the rest is an Art-Net packet; then into a merge as in
// sacn_fuzz.
#include "dmx/merge.h"

#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    static Merge merge;
    static std::chrono::nanoseconds now{0};
    if (size < 2) return 0;
    const int offset = static_cast<std::int16_t>(data[0] << 8 | data[1]);
    const Parsed parsed = parse_artnet({data + 2, size - 2}, 0x7F000001, offset);
    if (const Packet* packet = std::get_if<Packet>(&parsed)) {
        if (packet->universe < 1 || packet->universe > kMaxUniverse || packet->slot_count > kSlots)
            std::abort();
        if (packet->slot_count + 18u > size - 2) std::abort();
        now += std::chrono::milliseconds(packet->slots[0] * 80);
        merge.feed(*packet, now);
        merge.tick(now);
        if (merge.universes().list.size() > kMaxUniverses) std::abort();
        if (merge.sources(now).size() > kMaxUniverses * kMaxSourcesPerUniverse) std::abort();
    }
    return 0;
}
