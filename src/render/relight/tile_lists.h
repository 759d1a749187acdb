#pragma once
// SPDX-License-Identifier: Apache-2.0
// TileLists: bounds for cull.comp in which only some tiles of the picture are left, and lists of them: where
// kept images are drawn again. Main thread; device and fragments must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/geometry/fragments.h"
#include "render/geometry/screen_area.h"

#include <cstdint>

namespace ghost::render {

class TileLists {
public:
    TileLists(const gpu::Device& device, const Fragments& fragments);

    // Records bounds() and tiles() for these. rooms: shared::TileRoom of each tile. Returns their number.
    std::uint32_t record(gpu::Commands& commands, const gpu::Buffer& rooms, const TileSet& stale);
    const gpu::Buffer& bounds() const { return bounds_; }
    const gpu::Buffer& tiles() const { return tiles_; } // a list of the stale ones
    // Of all that is drawn with bounds(), the tiles around stale ones, too; none: there are more than fit.
    const gpu::Buffer& drawn_tiles() const { return drawn_tiles_; }
    std::uint32_t drawn_count() const { return drawn_count_; }
    std::uint64_t memory_bytes() const {
        return bounds_.bytes() + wanted_.bytes() + tiles_.bytes() + drawn_tiles_.bytes();
    }
    // More tiles than this cannot be recorded.
    static constexpr std::uint64_t kMostTiles = 16384;
    // Pixels of a stale tile take haze of their neighbours (fold.comp, wide beams): one tile around is drawn
    // too.
    static PixelRect around(const PixelRect& rect);

private:
    const Fragments& fragments_;
    gpu::Program program_;
    gpu::Buffer bounds_, wanted_, tiles_, drawn_tiles_;
    std::uint32_t drawn_count_ = 0;
};

} // namespace ghost::render
