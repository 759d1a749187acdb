#pragma once
// SPDX-License-Identifier: Apache-2.0
// DistanceMaps: how far it is from each hanging position of lights to the first surface, in all directions
// (shaders/shared/octahedral.h). The baker makes them (bake/distance_maps.h) and keeps them in
// .ghost/distances/SIZE/; they tell which parts of a beam are in shadow, in haze and for any camera. Metres;
// half floats, so within 0.05 %. Fixture bodies stop nothing. Plain values. Files:
// docs/design/distance-maps.md.

#include "base/report.h"
#include "base/result.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

// Where nothing is hit: finite, so that it can be filtered and compared like any distance.
inline constexpr float kNoSurface_m = 60000.0f;
inline constexpr std::uint16_t kNoSurface = 0x7b53;

// Texels a side of the blocks in which maps of lights that travel are made and reach the device.
inline constexpr int kDistanceBlock = 32;

struct DistanceMap {
    std::string fixture;
    int stop = 0;  // of its track
    int place = 0; // BeamGroups::places_m
    glm::vec3 position_m{0};
    std::vector<std::uint16_t> distance; // half floats, size x size, row by row; kNoSurface
    float nearest_m = kNoSurface_m;      // of what is hit; both kNoSurface_m where nothing is
    float farthest_m = kNoSurface_m;
};

struct DistanceMaps {
    int size = 0; // texels a side, of all maps
    std::vector<DistanceMap> maps;

    int find(const std::string& fixture, int stop, int place = 0) const; // or -1
};

// Sets nearest_m and farthest_m.
void measure(DistanceMap& map);

// What lies in the cache, belongs to where the lights hang now, and was right for the stage when the maps
// were last brought up to date. A file that is damaged or of another size is named in the report and left
// out. Error: a size beyond the limits.
Result<DistanceMaps> load_distance_maps(const Show& show, int size, Report& report);

} // namespace ghost::scene
