// SPDX-License-Identifier: Apache-2.0
#include "render/haze/distance_images.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"

#include <cstring>
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

// Of the first map: its texels, or the finest level of what is made of them.
std::vector<std::uint8_t> first_map(const gpu::Device& device, const gpu::Texture& texture,
                                    std::uint32_t texel_bytes) {
    const std::uint64_t bytes = std::uint64_t{texture.shape().width} * texture.shape().height * texel_bytes;
    const gpu::Buffer buffer(device, bytes, gpu::Access::readback);
    gpu::Commands commands(device);
    commands.begin();
    commands.copy(texture, buffer);
    commands.submit_and_wait();
    const auto* from = static_cast<const std::uint8_t*>(buffer.mapped());
    return {from, from + bytes};
}

// A few blocks go one by one, many with all of their map, and a map that was never set is set as a whole.
TEST(DistanceImages, blocks_that_changed_are_as_in_a_map_that_was_set) {
    const auto device = gpu::Device::create({.validation = true});
    ASSERT_TRUE(device.ok()) << device.error().text();
    constexpr std::uint32_t kAcrossMap = 256, kBlock = scene::kDistanceBlock, kAcross = kAcrossMap / kBlock;
    scene::DistanceMap map;
    for (std::uint32_t k = 0; k < kAcrossMap * kAcrossMap; ++k)
        map.distance.push_back(static_cast<std::uint16_t>(0x4000 + (k * 2654435761u >> 24)));
    const scene::DistanceMaps maps{kAcrossMap, {map, map}};
    DistanceImages whole(**device, maps), parts(**device, maps);
    std::vector<std::uint16_t> distance = map.distance;
    const std::vector<int> first{0};
    parts.set_blocks({{0, distance, first}, {1, distance, first}}); // from here on it knows their parts
    for (const std::size_t count : {3u, 40u}) {
        std::vector<int> blocks;
        for (std::size_t k = 0; k < count; ++k) {
            const auto block = static_cast<std::uint32_t>((7 + 5 * k) % (kAcross * kAcross));
            blocks.push_back(static_cast<int>(block));
            const std::size_t corner = block / kAcross * kBlock * kAcrossMap + block % kAcross * kBlock;
            for (std::uint32_t t = 0; t < kBlock * kBlock; ++t)
                distance[corner + t / kBlock * kAcrossMap + t % kBlock] =
                    static_cast<std::uint16_t>(0x3c00 + count + t);
        }
        parts.set_blocks({{0, distance, blocks}});
        parts.finish();
        whole.set(0, distance);
        whole.finish();
        EXPECT_EQ(first_map(**device, parts.texture(), 2), first_map(**device, whole.texture(), 2)) << count;
        EXPECT_EQ(first_map(**device, parts.blockers(), 8), first_map(**device, whole.blockers(), 8))
            << count;
    }
    EXPECT_EQ((*device)->validation_errors(), 0u);
}

} // namespace
} // namespace ghost::render
