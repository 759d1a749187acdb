#pragma once
// SPDX-License-Identifier: Apache-2.0
// How the passes of a camera are laid out for the device. Pure; made once per relighter.

#include "passes/passes.h"
#include "shared/push.h"
#include "shared/types.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

// How the fragments lie on the device: the picture's rows first, then the extra ones, in the order of the
// picture's tiles, so that a block of them is near together and can be culled like a tile.
struct Layout {
    std::vector<std::uint32_t> order; // device place -> fragment of the passes
    std::vector<glm::uvec2> edges;    // pixels with extra fragments: pixel, first extra * 4 + number
    std::vector<glm::vec4> bounds;    // two per tile, then two per block, see cull.comp
    std::uint32_t blocks = 0;
};

Layout make_layout(const scene::Passes& passes, std::uint32_t tiles_x, std::uint32_t tiles_y);

shared::View make_view(const glm::mat4& camera_to_world, float fov_y_deg, int width, int height,
                       const shared::Haze& haze);
shared::View make_view(const scene::Passes& passes, const shared::Haze& haze);
float pixels_per_rad(const shared::View& view); // in the middle of the picture

// The picture without lights: ambient and emission, seen through the haze. cd/m^2, one value a pixel.
std::vector<glm::vec4> base_image(const scene::Passes& passes, const glm::vec3& ambient,
                                  const shared::Haze& haze);

} // namespace ghost::render
