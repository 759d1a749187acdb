#pragma once
// SPDX-License-Identifier: Apache-2.0
// Traces a part of a distance map (passes/distance_maps.h): half floats of metres from a place in the
// directions of the part's texels. Any thread, parts apart.

#include "bake/distance_sight.h"
#include "rays/tracer.h"

#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::bake {

struct TexelPart {
    int x0, y0, x1, y1; // x1, y1 excluded
};

// seen: of each instance, whether a ray met it; or null.
void trace_distances(const DistanceSight& sight, const TexelPart& part, const glm::vec3& position_m,
                     const Tracer& tracer, std::vector<std::uint16_t>& distance,
                     std::vector<std::atomic<bool>>* seen);

} // namespace ghost::bake
