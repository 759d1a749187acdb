#pragma once
// SPDX-License-Identifier: Apache-2.0
// fold.comp: adds the light of extra fragments to their pixels, and mends the haze of these. Planes as the
// shader binds them; any thread, has_vectors().

#include "render/pixels/plane.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

struct FragmentPlanes {
    int width = 0; // of the picture
    int height = 0;
    std::vector<DrawnLights> drawn; // of which the first one gets what is folded; no haze: there is none
    Plane places;                   // rgba32f
    Plane edges;                    // rg32ui
    Plane sources;                  // r16ui, as edges: of haze (silhouettes.comp)
    std::uint32_t edge_count = 0;
    struct Edges {
        std::uint32_t first, count;
    };
    std::vector<Edges> parts; // nothing but these edges, which are another pixel's each; empty: all
    bool corners = false;     // haze was sampled at the corners of the pixels
};

void fold_fragments(const FragmentPlanes& fragments);

} // namespace ghost::render
