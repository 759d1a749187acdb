// SPDX-License-Identifier: Apache-2.0
#include "render/haze/distance_images.h"

#include "base/check.h"
#include "gpu/device_failures.h"
#include "render/haze/memory_order.h"
#include "render/haze/private/blockers.h"

#include <algorithm>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kLeastSide = 32;
constexpr std::uint32_t kBlock = scene::kDistanceBlock;
// Of a map, which go to the device one by one: where there are many, all of it is sooner there (an H200 took
// 43 ms for the blocks of 24 maps that flew; from how many on that is so was not measured).
constexpr std::size_t kFewBlocks = 8;

std::uint32_t layers_of(const gpu::Device& device, const scene::DistanceMaps& maps) {
    return static_cast<std::uint32_t>(
        std::clamp<std::size_t>(maps.maps.size(), 1, device.limits().image_layers));
}

gpu::TextureShape texels_shape(std::uint32_t side, std::uint32_t layers, bool stored) {
    return {side, side, layers, 1, VK_FORMAT_R16_SFLOAT, stored};
}

gpu::TextureShape blockers_shape(std::uint32_t side, std::uint32_t layers, bool stored) {
    const std::uint32_t cells = std::max(side / kLeastBlockerCell, 1u);
    return {cells, cells, layers, blocker_levels(side), VK_FORMAT_R16G16B16A16_SFLOAT, stored};
}

bool is_stored_to(const gpu::Device& device, DistanceImages::Made made) {
    return made == DistanceImages::Made::by_the_device && MapDrawer::lack_of(device).empty();
}

std::uint32_t side_that_fits(const gpu::Device& device, const scene::DistanceMaps& maps) {
    auto side = static_cast<std::uint32_t>(std::max(maps.size, 1));
    const std::uint32_t layers = layers_of(device, maps);
    const std::uint64_t room = share_of(Kept::maps, device);
    while (side % 2 == 0 && side > kLeastSide &&
           gpu::texture_bytes(device, texels_shape(side, layers, false)) +
                   gpu::texture_bytes(device, blockers_shape(side, layers, false)) >
               room)
        side /= 2;
    return side;
}

VkRect2D square(std::uint32_t x, std::uint32_t y, std::uint32_t width) {
    return {{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, {width, width}};
}

} // namespace

DistanceImages::DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps, Made made)
    : wanted_side_(static_cast<std::uint32_t>(std::max(maps.size, 1))),
      texture_(device, texels_shape(side_that_fits(device, maps), layers_of(device, maps),
                                    is_stored_to(device, made))),
      blockers_(device, blockers_shape(side(), layers_of(device, maps), is_stored_to(device, made))),
      uploads_(device), far_(count()), kept_(count()) {
    begin_drawing(device, made);
    for (FarParts& parts : far_) parts.fill(scene::kNoSurface_m);
    for (std::size_t index = 0; index < maps.maps.size(); ++index) set(index, maps.maps[index].distance);
    finish();
}

void DistanceImages::begin_drawing(const gpu::Device& device, Made made) {
    if (made == Made::elsewhere) return;
    lack_ = MapDrawer::lack_of(device);
    if (!lack_.empty())
        lack_ = "the device lacks " + lack_;
    else if (side() != wanted_side_ || !MapDrawer::takes(side()))
        lack_ = "its memory holds maps of " + std::to_string(side()) + " texels a side, not of " +
                std::to_string(wanted_side_);
    if (!lack_.empty()) return;
    try {
        drawer_ = std::make_unique<MapDrawer>(device, side(), static_cast<std::uint32_t>(count()));
    } catch (const gpu::OutOfDeviceMemory&) {
        lack_ = "its memory has no room to draw them";
    }
}

void DistanceImages::draw(const StageModel& model, const std::vector<MapDrawer::Job>& jobs) {
    CHECK(can_draw());
    std::vector<MapDrawer::Job> held;
    for (const MapDrawer::Job& job : jobs) {
        if (job.map >= count() || job.blocks.empty()) continue;
        held.push_back(job);
        kept_[job.map].clear();
    }
    drawer_->draw(model, held, texture_, blockers_, far_);
}

std::vector<gpu::Span> DistanceImages::drawing_spans() const {
    return drawer_ ? drawer_->spans() : std::vector<gpu::Span>();
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

void DistanceImages::set_blocks(const std::vector<Change>& changes) {
    const bool in_parts = side() == wanted_side_ && side() % blocker_unit(kBlock, side()) == 0;
    std::vector<char> whole(changes.size()); // was not known before
    tbb::parallel_for(std::size_t{0}, changes.size(), [&](std::size_t c) {
        const auto& [index, distance, blocks] = changes[c];
        if (index >= count() || !in_parts) return;
        CHECK_EQ(distance.size(), std::size_t{side()} * side());
        std::vector<std::vector<Blockers>>& levels = kept_[index];
        whole[c] = levels.empty();
        if (levels.empty()) {
            levels = blockers_of(distance, side());
            far_[index] = far_parts(distance, side());
            return;
        }
        const std::uint32_t across = side() / kBlock;
        for (const int block : blocks)
            update_far_parts(distance, side(), static_cast<std::uint32_t>(block) % across * kBlock,
                             static_cast<std::uint32_t>(block) / across * kBlock, kBlock, far_[index]);
        for (const BlockerSquare& part : squares_of(blocks, kBlock, side()))
            update_blockers(distance, side(), part, levels);
    });
    for (std::size_t c = 0; c < changes.size(); ++c) {
        const auto& [index, distance, blocks] = changes[c];
        if (index >= count()) continue;
        if (!in_parts)
            set(index, distance);
        else if (whole[c] || blocks.size() > kFewBlocks)
            add_whole(static_cast<std::uint32_t>(index), distance, kept_[index]);
        else
            add_blocks(changes[c]);
    }
}

void DistanceImages::add_blocks(const Change& change) {
    const auto layer = static_cast<std::uint32_t>(change.index);
    const std::uint32_t across = side() / kBlock;
    for (const int block : change.blocks) {
        const auto k = static_cast<std::uint32_t>(block);
        const std::uint32_t x = k % across * kBlock, y = k / across * kBlock;
        uploads_.add(texture_, layer, 0, square(x, y, kBlock), &change.distance[std::size_t{y} * side() + x],
                     side() * sizeof change.distance[0], sizeof change.distance[0]);
    }
    const std::vector<std::vector<Blockers>>& levels = kept_[change.index];
    for (const BlockerSquare& part : squares_of(change.blocks, kBlock, side()))
        for (std::uint32_t level = 0; level < levels.size(); ++level) {
            const std::uint32_t cell = kLeastBlockerCell << level, cells = side() / cell;
            const std::uint32_t x = part.x / cell, y = part.y / cell;
            uploads_.add(blockers_, layer, level, square(x, y, part.width / cell),
                         &levels[level][std::size_t{y} * cells + x], cells * sizeof(Blockers),
                         sizeof(Blockers));
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
