#pragma once
// SPDX-License-Identifier: Apache-2.0
// Fragments: what the lights of one picture fall on, on the device. Two suppliers fill it: passes from disk
// (a fixed camera) and the G-buffer (a free one). A pixel on an edge has several fragments, see
// passes/passes.h. Values that own device memory; must not outlive their Device.

#include "gpu/buffer.h"
#include "gpu/texture.h"
#include "render/geometry/beam_reach.h"
#include "shared/types.h"

#include <cstdint>
#include <glm/glm.hpp>

namespace ghost::render {

struct Fragments {
    std::uint32_t width = 0; // of the picture
    std::uint32_t height = 0;
    std::uint32_t tiles_x = 0; // of kTileWidth x kTileHeight pixels (shared/push.h)
    std::uint32_t tiles_y = 0;
    std::uint32_t blocks = 0;     // of kTilePixels extra fragments, rounded up
    std::uint32_t edge_count = 0; // pixels with extra fragments
    shared::View camera{};        // what view holds
    glm::vec3 eye_m{0};
    float pixels_per_rad = 0; // in the middle of the picture
    SeenBox seen;             // of a G-buffer: not known
    gpu::Buffer view;         // shared::View
    // rgba32f: position_m, coverage (< 0: no surface). The picture's rows, then rows of extra fragments;
    // extra k lies at (k % width, height + k / width); what no fragment fills has coverage -1.
    gpu::Texture places;
    gpu::Texture
        edges;         // rg32ui, entry e at (e % width, e / width): pixel, first extra * 4 + number of extras
    gpu::Texture base; // rgba16f, picture only: cd/m^2 without any light (even light, emission), through haze
    gpu::Buffer tile_bounds; // two vec4 a tile, then a block: centre, radius (< 0: nothing to light);
                             // farthest_m, 0, 0, 0
};

} // namespace ghost::render
