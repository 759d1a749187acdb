// SPDX-License-Identifier: Apache-2.0
#include "passes/distance_maps.h"

#include "passes/distance_maps_file.h"
#include "show/show.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {

int DistanceMaps::find(const std::string& fixture, int stop, int place) const {
    for (std::size_t k = 0; k < maps.size(); ++k)
        if (maps[k].fixture == fixture && maps[k].stop == stop && maps[k].place == place)
            return static_cast<int>(k);
    return -1;
}

void measure(DistanceMap& map) {
    // Positive half floats are ordered as their bits.
    std::uint16_t nearest = kNoSurface;
    std::uint16_t farthest = 0;
    for (const std::uint16_t distance : map.distance) {
        nearest = std::min(nearest, distance);
        if (distance < kNoSurface) farthest = std::max(farthest, distance);
    }
    map.nearest_m = glm::unpackHalf1x16(nearest);
    map.farthest_m = nearest == kNoSurface ? kNoSurface_m : glm::unpackHalf1x16(farthest);
}

Result<DistanceMaps> load_distance_maps(const Show& show, int size, Report& report) {
    if (size < kMinDistanceMapSize || size > kMaxDistanceMapSize)
        return Error{"the size of distance maps must be " + std::to_string(kMinDistanceMapSize) + " to " +
                         std::to_string(kMaxDistanceMapSize),
                     ""};
    DistanceMaps result;
    result.size = size;
    const auto stage = read_distance_stage(distance_folder(show, size));
    if (!stage.ok()) report.add(Severity::warning, stage.error().where, stage.error().what);
    if (!stage.ok() || !stage->has_value()) return result;
    for (const DistancePlace& place : distance_places(show, size)) {
        auto stored = read_distance_map(place.file, size);
        if (!stored.ok()) {
            report.add(Severity::warning, stored.error().where, stored.error().what);
            continue;
        }
        if (!stored->has_value() || (*stored)->place != place_key(place, size) ||
            !(*stage)->holds_for(**stored))
            continue;
        DistanceMap map{place.fixture, place.stop, place.place, place.position_m,
                        std::move((*stored)->distance)};
        measure(map);
        result.maps.push_back(std::move(map));
    }
    return result;
}

} // namespace ghost::scene
