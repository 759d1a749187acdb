#pragma once
// SPDX-License-Identifier: Apache-2.0
// DirtyTiles: which parts of the kept images of resting lights are stale since something moved in front of
// the camera, and what it takes to draw these parts again and nothing else. Bounds for cull.comp in which
// only stale tiles are left; lights that cannot reach them are left out. Main thread; device and fragments
// must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/geometry/fragments.h"
#include "render/geometry/screen_area.h"
#include "render/relight/light_tree.h"
#include "shared/types.h"

#include <map>
#include <vector>

namespace ghost::render {

class DirtyTiles {
public:
    // rooms: shared::TileRoom of each tile.
    DirtyTiles(const gpu::Device& device, const Fragments& fragments, const gpu::Buffer& rooms);

    // Fragments changed in these rectangles: every image made so far is stale there. False: in too many
    // tiles by now, they must be forgotten.
    bool touch(const std::vector<PixelRect>& rects);
    // An image was made (ImageSum::target >= 0) from lights and other images; it is stale where one of these
    // is.
    void made(const ImageSum& sum);
    void forget() { kept_.clear(); }

    bool is_stale(int slot) const;
    // Since so many touches at least.
    bool is_stale_since(int slot, int touches) const;
    // What to draw into an image where it is stale.
    ImageSum mend(int slot, const std::vector<shared::Light>& lights) const;
    // Records bounds() and tiles() for this image, which then counts as mended. Returns the number of tiles.
    std::uint32_t record(gpu::Commands& commands, int slot);
    // A sum of images some of which are stale: what to draw where they are, instead of all of it. They stay
    // stale. tiles: there.
    ImageSum patch(const ImageSum& sum, const std::vector<shared::Light>& lights, TileSet& tiles) const;
    // Records bounds() and tiles() for these.
    std::uint32_t record(gpu::Commands& commands, const TileSet& stale);
    const gpu::Buffer& bounds() const { return bounds_; }
    const gpu::Buffer& tiles() const { return tiles_; } // a list of the stale ones
    // Of all that is drawn with bounds(), the tiles around stale ones, too; none: there are more than fit.
    const gpu::Buffer& drawn_tiles() const { return drawn_tiles_; }
    std::uint32_t drawn_count() const { return drawn_count_; }
    std::uint64_t memory_bytes() const {
        return bounds_.bytes() + wanted_.bytes() + tiles_.bytes() + drawn_tiles_.bytes();
    }
    // More stale tiles than this cannot be recorded: forget the images.
    static constexpr std::uint64_t kMostTiles = 16384;

private:
    void add_reaching(const std::vector<int>& indices, const std::vector<shared::Light>& lights,
                      const std::vector<PixelRect>& rects, std::vector<int>& to) const;

    struct Kept {
        std::vector<int> lights; // all that it shows
        bool base = false;
        bool at_unit = false;
        TileSet stale;
        std::uint64_t since = 0; // which touch made it stale
    };
    const Fragments& fragments_;
    const gpu::Buffer& rooms_;
    gpu::Program program_;
    gpu::Buffer bounds_, wanted_, tiles_, drawn_tiles_;
    std::uint32_t drawn_count_ = 0;
    std::map<int, Kept> kept_; // by slot
    std::uint64_t touches_ = 0;
};

// Whether a beam may be seen in these pixels, in the air or on a surface. Conservative.
bool may_reach(const shared::Light& light, const shared::View& view, const PixelRect& rect);

} // namespace ghost::render
