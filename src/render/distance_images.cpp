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

// The nearest of each cell and its eight neighbours. Half floats above zero are in the order of their bits.
std::vector<std::uint16_t> nearest_around(const std::vector<std::uint16_t>& texels, int side, int cells) {
    std::vector<std::uint16_t> inside(static_cast<std::size_t>(cells * cells), scene::kNoSurface);
    const int step = side / cells;
    for (int y = 0; y < cells * step; ++y)
        for (int x = 0; x < cells * step; ++x) {
            std::uint16_t& cell = inside[static_cast<std::size_t>(y / step * cells + x / step)];
            cell = std::min(cell, texels[static_cast<std::size_t>(y * side + x)]);
        }
    std::vector<std::uint16_t> around(inside.size());
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            std::uint16_t nearest = scene::kNoSurface;
            for (int k = 0; k < 9; ++k) {
                // Beyond an edge the octahedron goes on at the same edge, mirrored.
                const int row = k / 3;
                int to_x = x + k % 3 - 1, to_y = y + row - 1;
                const bool beyond_x = to_x < 0 || to_x >= cells, beyond_y = to_y < 0 || to_y >= cells;
                to_x = std::clamp(to_x, 0, cells - 1);
                to_y = std::clamp(to_y, 0, cells - 1);
                if (beyond_y) to_x = cells - 1 - to_x;
                if (beyond_x) to_y = cells - 1 - to_y;
                nearest = std::min(nearest, inside[static_cast<std::size_t>(to_y * cells + to_x)]);
            }
            around[static_cast<std::size_t>(y * cells + x)] = nearest;
        }
    return around;
}

} // namespace

DistanceImages::DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps)
    : wanted_side_(static_cast<std::uint32_t>(std::max(maps.size, 1))),
      texture_(device, shape_of(device, maps, side_that_fits(device, maps))),
      nearest_(device, shape_of(device, maps, std::max(side() / kNearestCell, 1u))) {
    for (std::size_t index = 0; index < maps.maps.size(); ++index) set(index, maps.maps[index]);
}

void DistanceImages::set(std::size_t index, const scene::DistanceMap& map) {
    if (index >= count()) return;
    const auto layer = static_cast<std::uint32_t>(index);
    const std::size_t wanted = wanted_side_;
    CHECK_EQ(map.distance.size(), wanted * wanted);
    const std::size_t step = wanted / side();
    std::vector<std::uint16_t> kept;
    kept.reserve(std::size_t{side()} * side());
    for (std::size_t y = step / 2; y < wanted; y += step)
        for (std::size_t x = step / 2; x < wanted; x += step) kept.push_back(map.distance[y * wanted + x]);
    texture_.write_layer(layer, kept.data(), kept.size() * sizeof kept[0]);
    const auto nearest =
        nearest_around(kept, static_cast<int>(side()), static_cast<int>(nearest_.shape().width));
    nearest_.write_layer(layer, nearest.data(), nearest.size() * sizeof nearest[0]);
}

} // namespace ghost::render
