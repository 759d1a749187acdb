// SPDX-License-Identifier: Apache-2.0
#include "bake/private/distance_trace.h"

#include "passes/distance_maps.h"
#include "passes/passes_file.h"

#include <algorithm>
#include <cstddef>

namespace ghost::bake {
namespace {

constexpr int kPacketWidth = 4;
constexpr int kPacketHeight = 2;

} // namespace

void trace_distances(const DistanceSight& sight, const TexelPart& part, const glm::vec3& position_m,
                     const Tracer& tracer, std::vector<std::uint16_t>& distance,
                     std::vector<std::atomic<bool>>* seen) {
    const DenormalsOff mode;
    const auto size = static_cast<std::size_t>(sight.size());
    int last = -1; // neighbours mostly see the same
    for (int y = part.y0; y < part.y1; y += kPacketHeight)
        for (int x = part.x0; x < part.x1; x += kPacketWidth) {
            glm::vec3 ways[kPacketWidth * kPacketHeight];
            std::size_t texel[kPacketWidth * kPacketHeight];
            float distances_m[kPacketWidth * kPacketHeight];
            int instances[kPacketWidth * kPacketHeight];
            int count = 0;
            for (int v = y; v < std::min(y + kPacketHeight, part.y1); ++v)
                for (int u = x; u < std::min(x + kPacketWidth, part.x1); ++u) {
                    texel[count] = static_cast<std::size_t>(v) * size + static_cast<std::size_t>(u);
                    ways[count] = sight.directions()[texel[count]];
                    ++count;
                }
            tracer.distances(position_m, ways, count, scene::kNoSurface_m, distances_m, instances);
            for (int k = 0; k < count; ++k) {
                distance[texel[k]] = instances[k] < 0
                                         ? scene::kNoSurface
                                         : scene::to_half(std::min(distances_m[k], scene::kNoSurface_m));
                if (!seen || instances[k] < 0 || instances[k] == last) continue;
                last = instances[k];
                (*seen)[static_cast<std::size_t>(last)].store(true, std::memory_order_relaxed);
            }
        }
}

} // namespace ghost::bake
