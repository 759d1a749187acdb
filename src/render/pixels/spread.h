#pragma once
// SPDX-License-Identifier: Apache-2.0
// coarse_spread.comp and coarse_fold.comp: from light at coarse points to the picture (shared/coarse.h).
// Planes as the shaders bind them; any thread, has_vectors().

#include "render/pixels/plane.h"

#include <cstdint>

namespace ghost::render {

struct CoarsePlanes {
    Plane points;                    // rgba32ui: light and haze as six halves
    Plane surfaces, hazes, reflects; // rgba32ui: of cells
    Plane edges;                     // rg32ui
    Plane extras;                    // rgba32ui
    std::uint32_t edge_count = 0;
};

// base: rgba16f, or none; frame: rgba16f, written whole.
void spread_points(const CoarsePlanes& coarse, const Plane& base, const Plane& frame);
// Adds the extra fragments of pixels on silhouettes.
void fold_extras(const CoarsePlanes& coarse, const Plane& frame);

} // namespace ghost::render
