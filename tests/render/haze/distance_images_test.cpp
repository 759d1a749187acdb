// SPDX-License-Identifier: Apache-2.0
#include "render/haze/distance_images.h"

#include <gtest/gtest.h>

namespace ghost::render {
namespace {

TEST(DistanceImages, more_maps_than_an_image_has_layers_are_left_out) {
    const auto device = gpu::Device::create({.validation = true});
    ASSERT_TRUE(device.ok()) << device.error().text();
    constexpr int kMapSide = 8;
    scene::DistanceMap map;
    map.distance.assign(kMapSide * kMapSide, scene::kNoSurface);
    const std::size_t most = (*device)->limits().image_layers;
    scene::DistanceMaps maps{kMapSide, std::vector<scene::DistanceMap>(most + 2, map)};
    DistanceImages images(**device, maps);
    EXPECT_EQ(images.count(), most);
    images.set(most + 1, map.distance); // nothing happens
    maps.maps.resize(3);
    EXPECT_EQ(DistanceImages(**device, maps).count(), 3u);
    EXPECT_EQ((*device)->validation_errors(), 0u);
}

} // namespace
} // namespace ghost::render
