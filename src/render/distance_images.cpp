// SPDX-License-Identifier: Apache-2.0
#include "render/distance_images.h"

#include "base/check.h"

#include <algorithm>

namespace ghost::render {

DistanceImages::DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps)
    : texture_(device, {static_cast<std::uint32_t>(std::max(maps.size, 1)),
                        static_cast<std::uint32_t>(std::max(maps.size, 1)),
                        static_cast<std::uint32_t>(std::max<std::size_t>(maps.maps.size(), 1)), 1,
                        VK_FORMAT_R16_SFLOAT}) {
    for (std::size_t index = 0; index < maps.maps.size(); ++index) set(index, maps.maps[index]);
}

void DistanceImages::set(std::size_t index, const scene::DistanceMap& map) {
    const std::size_t side = texture_.shape().width;
    CHECK_EQ(map.distance.size(), side * side);
    texture_.write_layer(static_cast<std::uint32_t>(index), map.distance.data(),
                         map.distance.size() * sizeof map.distance[0]);
}

} // namespace ghost::render
