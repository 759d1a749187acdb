#pragma once
// SPDX-License-Identifier: Apache-2.0
// DirtyTiles: which parts of the kept images of resting lights are stale since something moved in front of
// the camera, and what it takes to draw these parts again (TileLists) and nothing else; lights that cannot
// reach them are left out. Main thread; fragments must outlive it.

#include "render/geometry/fragments.h"
#include "render/geometry/screen_area.h"
#include "render/relight/light_tree.h"
#include "shared/types.h"

#include <map>
#include <vector>

namespace ghost::render {

class DirtyTiles {
public:
    explicit DirtyTiles(const Fragments& fragments) : fragments_(fragments) {}

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
    // Where it is; from now on it counts as mended.
    TileSet take_stale(int slot);
    // A sum of images some of which are stale: what to draw where they are, instead of all of it. They stay
    // stale. tiles: there. all: those of the sum's own lights that reach them, too.
    enum class Lights { all, resting };
    ImageSum patch(const ImageSum& sum, const std::vector<shared::Light>& lights, TileSet& tiles,
                   Lights which) const;

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
    std::map<int, Kept> kept_; // by slot
    std::uint64_t touches_ = 0;
};

// Whether a beam may be seen in these pixels, in the air or on a surface. Conservative.
bool may_reach(const shared::Light& light, const shared::View& view, const PixelRect& rect);

} // namespace ghost::render
