// SPDX-License-Identifier: Apache-2.0
#include "render/haze/distance_images.h"

#include "base/check.h"
#include "gpu/device_memory.h"
#include "render/haze/private/blockers.h"

#include <algorithm>
#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kLeastSide = 32;

std::uint32_t layers_of(const gpu::Device& device, const scene::DistanceMaps& maps) {
    return static_cast<std::uint32_t>(
        std::clamp<std::size_t>(maps.maps.size(), 1, device.limits().image_layers));
}

gpu::TextureShape texels_shape(std::uint32_t side, std::uint32_t layers) {
    return {side, side, layers, 1, VK_FORMAT_R16_SFLOAT};
}

gpu::TextureShape blockers_shape(std::uint32_t side, std::uint32_t layers) {
    const std::uint32_t cells = std::max(side / kLeastBlockerCell, 1u);
    return {cells, cells, layers, blocker_levels(side), VK_FORMAT_R16G16B16A16_SFLOAT};
}

std::uint32_t side_that_fits(const gpu::Device& device, const scene::DistanceMaps& maps) {
    auto side = static_cast<std::uint32_t>(std::max(maps.size, 1));
    const std::uint32_t layers = layers_of(device, maps);
    const std::uint64_t room = device.memory().left_bytes() / 2;
    while (side % 2 == 0 && side > kLeastSide &&
           gpu::texture_bytes(device, texels_shape(side, layers)) +
                   gpu::texture_bytes(device, blockers_shape(side, layers)) >
               room)
        side /= 2;
    return side;
}

VkRect2D square(std::uint32_t x, std::uint32_t y, std::uint32_t width) {
    return {{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, {width, width}};
}

} // namespace

DistanceImages::DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps)
    : wanted_side_(static_cast<std::uint32_t>(std::max(maps.size, 1))),
      texture_(device, texels_shape(side_that_fits(device, maps), layers_of(device, maps))),
      blockers_(device, blockers_shape(side(), layers_of(device, maps))), uploads_(device), far_(count()),
      kept_(count()) {
    for (FarParts& parts : far_) parts.fill(scene::kNoSurface_m);
    for (std::size_t index = 0; index < maps.maps.size(); ++index) set(index, maps.maps[index].distance);
    finish();
}

void DistanceImages::set(std::size_t index, const std::vector<std::uint16_t>& distance) {
    if (index >= count()) return;
    kept_[index].clear();
    const auto layer = static_cast<std::uint32_t>(index);
    const std::size_t wanted = wanted_side_;
    CHECK_EQ(distance.size(), wanted * wanted);
    const std::size_t step = wanted / side();
    std::vector<std::uint16_t> kept;
    kept.reserve(std::size_t{side()} * side());
    for (std::size_t y = step / 2; y < wanted; y += step)
        for (std::size_t x = step / 2; x < wanted; x += step) kept.push_back(distance[y * wanted + x]);
    far_[index] = far_parts(kept, side());
    add_whole(layer, kept, blockers_of(kept, side()));
}

void DistanceImages::set_blocks(std::size_t index, const std::vector<std::uint16_t>& distance,
                                const std::vector<int>& blocks) {
    constexpr std::uint32_t kBlock = scene::kDistanceBlock;
    if (index >= count()) return;
    if (side() != wanted_side_ || side() % blocker_unit(kBlock, side()) != 0) return set(index, distance);
    CHECK_EQ(distance.size(), std::size_t{side()} * side());
    const auto layer = static_cast<std::uint32_t>(index);
    std::vector<std::vector<Blockers>>& levels = kept_[index];
    if (levels.empty()) {
        levels = blockers_of(distance, side());
        far_[index] = far_parts(distance, side());
        add_whole(layer, distance, levels);
        return;
    }
    const std::uint32_t across = side() / kBlock;
    for (const int block : blocks) {
        const std::uint32_t k = static_cast<std::uint32_t>(block);
        const std::uint32_t x = k % across * kBlock, y = k / across * kBlock;
        update_far_parts(distance, side(), x, y, kBlock, far_[index]);
        uploads_.add(texture_, layer, 0, square(x, y, kBlock), &distance[std::size_t{y} * side() + x],
                     side() * sizeof distance[0], sizeof distance[0]);
    }
    for (const BlockerSquare& part : squares_of(blocks, kBlock, side())) {
        update_blockers(distance, side(), part, levels);
        for (std::uint32_t level = 0; level < levels.size(); ++level) {
            const std::uint32_t cell = kLeastBlockerCell << level, cells = side() / cell;
            const std::uint32_t x = part.x / cell, y = part.y / cell;
            uploads_.add(blockers_, layer, level, square(x, y, part.width / cell),
                         &levels[level][std::size_t{y} * cells + x], cells * sizeof(Blockers),
                         sizeof(Blockers));
        }
    }
}

void DistanceImages::add_whole(std::uint32_t layer, const std::vector<std::uint16_t>& distance,
                               const std::vector<std::vector<Blockers>>& levels) {
    uploads_.add(texture_, layer, 0, distance.data(), sizeof distance[0]);
    for (std::uint32_t level = 0; level < levels.size(); ++level)
        uploads_.add(blockers_, layer, level, levels[level].data(), sizeof(Blockers));
}

DistanceImages::~DistanceImages() = default;

float DistanceImages::reach_m(const shared::Light& light) const {
    return light.map > 0 && light.map <= far_.size() ? reach_in(far_[light.map - 1], light) : kEndless_m;
}

} // namespace ghost::render
