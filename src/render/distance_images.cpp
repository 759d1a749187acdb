// SPDX-License-Identifier: Apache-2.0
#include "render/distance_images.h"

#include "base/check.h"

#include <algorithm>
#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kLeastSide = 32;

gpu::TextureShape shape_of(const gpu::Device& device, const scene::DistanceMaps& maps, std::uint32_t side) {
    const auto layers =
        static_cast<std::uint32_t>(std::clamp<std::size_t>(maps.maps.size(), 1, device.most_layers()));
    return {side, side, layers, 1, VK_FORMAT_R16_SFLOAT};
}

std::uint32_t side_that_fits(const gpu::Device& device, const scene::DistanceMaps& maps) {
    auto side = static_cast<std::uint32_t>(std::max(maps.size, 1));
    const std::uint64_t room = device.memory_left_bytes() / 2;
    while (side % 2 == 0 && side > kLeastSide &&
           gpu::texture_bytes(device, shape_of(device, maps, side)) > room)
        side /= 2;
    return side;
}

} // namespace

DistanceImages::DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps)
    : wanted_side_(static_cast<std::uint32_t>(std::max(maps.size, 1))),
      texture_(device, shape_of(device, maps, side_that_fits(device, maps))) {
    for (std::size_t index = 0; index < maps.maps.size(); ++index) set(index, maps.maps[index]);
}

void DistanceImages::set(std::size_t index, const scene::DistanceMap& map) {
    if (index >= count()) return;
    const auto layer = static_cast<std::uint32_t>(index);
    const std::size_t wanted = wanted_side_;
    CHECK_EQ(map.distance.size(), wanted * wanted);
    const std::size_t step = wanted / side();
    if (step == 1) {
        texture_.write_layer(layer, map.distance.data(), map.distance.size() * sizeof map.distance[0]);
        return;
    }
    std::vector<std::uint16_t> kept;
    kept.reserve(std::size_t{side()} * side());
    for (std::size_t y = step / 2; y < wanted; y += step)
        for (std::size_t x = step / 2; x < wanted; x += step) kept.push_back(map.distance[y * wanted + x]);
    texture_.write_layer(layer, kept.data(), kept.size() * sizeof kept[0]);
}

} // namespace ghost::render
