// SPDX-License-Identifier: Apache-2.0
#include "render/relight/tile_lists.h"

#include "shaders/changed_bounds.h"
#include "shared/g_buffer.h"
#include "shared/push.h"

#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kBoundsGroup = 64; // changed_bounds.comp

std::vector<std::uint32_t> bits_of(const TileSet& tiles, std::size_t words) {
    std::vector<std::uint32_t> bits(words, 0);
    for (const std::uint32_t tile : tiles.list()) bits[tile / 32] |= 1u << (tile % 32);
    return bits;
}

} // namespace

TileLists::TileLists(const gpu::Device& device, const Fragments& fragments)
    : fragments_(fragments), program_(device, shaders::kShader_changed_bounds) {
    const Fragments& f = fragments;
    bounds_ = gpu::Buffer(device, f.tile_bounds.bytes(), gpu::Access::device);
    const std::uint64_t words = (std::uint64_t{f.tiles_x} * f.tiles_y + 31) / 32;
    wanted_ = gpu::Buffer(device, words * sizeof(std::uint32_t), gpu::Access::device);
    for (gpu::Buffer* list : {&tiles_, &drawn_tiles_})
        *list = gpu::Buffer(device, kMostTiles * sizeof(std::uint32_t), gpu::Access::device);
}

PixelRect TileLists::around(const PixelRect& rect) {
    constexpr int kAroundX = static_cast<int>(shared::kTileWidth);
    constexpr int kAroundY = static_cast<int>(shared::kTileHeight);
    return {rect.x0 - kAroundX, rect.y0 - kAroundY, rect.x1 + kAroundX, rect.y1 + kAroundY};
}

std::uint32_t TileLists::record(gpu::Commands& commands, const gpu::Buffer& rooms, const TileSet& stale) {
    const Fragments& f = fragments_;
    const std::uint32_t tiles = f.tiles_x * f.tiles_y;
    const std::size_t words = (tiles + 31) / 32;
    TileSet drawn(static_cast<int>(f.width), static_cast<int>(f.height));
    for (const PixelRect& rect : stale.rects()) drawn.add(around(rect));
    commands.begin_span("mend");
    for (const bool blocks : {false, true}) {
        commands.write(wanted_, bits_of(blocks ? stale : drawn, words));
        commands.dispatch(program_, shared::ChangedBoundsPush{tiles, f.blocks, blocks ? 1u : 0u},
                          shaders::ChangedBoundsBindings{.tile_bounds = gpu::storage(f.tile_bounds),
                                                         .changed_bounds = gpu::storage(bounds_),
                                                         .rooms = gpu::storage(rooms),
                                                         .wanted = gpu::storage(wanted_)},
                          (tiles + f.blocks + kBoundsGroup - 1) / kBoundsGroup);
        commands.barrier();
    }
    commands.write(tiles_, stale.list());
    drawn_count_ = drawn.count() <= kMostTiles ? static_cast<std::uint32_t>(drawn.count()) : 0;
    if (drawn_count_ > 0) commands.write(drawn_tiles_, drawn.list());
    return static_cast<std::uint32_t>(stale.count());
}

} // namespace ghost::render
