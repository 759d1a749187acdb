// SPDX-License-Identifier: Apache-2.0
#include "live/session/map_size.h"

#include "base/memory.h"
#include "passes/distance_maps_file.h"
#include "show/show.h"

#include <cstdint>
#include <string>

namespace ghost::app {

// 2 MB a light, and from kManyLights on half a megabyte: shadows get coarser, not fewer. The same where the
// machine's memory does not hold what the show asks for.
int map_size(const scene::Show& show, Report& report) {
    constexpr std::size_t kManyLights = 256;
    const std::uint64_t count = scene::distance_places(show, scene::kDistanceMapSize).size();
    const bool few = count < kManyLights;
    const int wanted = show.distance_map_size > 0 ? show.distance_map_size
                       : few                      ? 2 * scene::kDistanceMapSize
                                                  : scene::kDistanceMapSize;
    const std::uint64_t room = free_memory_bytes() / 2; // drawing needs some, too
    const auto bytes = [&](int size) {
        return count * sizeof(std::uint16_t) * static_cast<std::uint64_t>(size) *
               static_cast<std::uint64_t>(size);
    };
    int size = wanted;
    while (room > 0 && size > scene::kMinDistanceMapSize && bytes(size) > room) size /= 2;
    if (size < wanted)
        report.add(Severity::warning, show.file.string(),
                   "memory is short for " + std::to_string(count) + " distance maps of " +
                       std::to_string(wanted) + " texels a side (" + std::to_string(bytes(wanted) >> 20) +
                       " MB): they are made with " + std::to_string(size));
    return size;
}

void leave_out_maps(scene::DistanceMaps& maps, std::size_t held, Report& report) {
    if (held >= maps.maps.size()) return;
    report.add(Severity::warning, "distance maps",
               "the device holds " + std::to_string(held) + " of " + std::to_string(maps.maps.size()) +
                   "; lights beyond throw no shadows");
    maps.maps.resize(held);
}

} // namespace ghost::app
