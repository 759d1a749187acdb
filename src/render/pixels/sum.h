#pragma once
// SPDX-License-Identifier: Apache-2.0
// sum.comp: kept images, each with its weight, the lights drawn just now, the picture without lights: to the
// frame or to an image that is kept. Planes as the shader binds them; any thread, has_vectors().

#include "render/pixels/plane.h"

#include <glm/glm.hpp>
#include <vector>

namespace ghost::render {

struct KeptImage {
    const std::uint8_t* at = nullptr; // rgba32ui: two pixels, or surface and haze of one point, as six halves
    glm::vec3 weight{0};
};

struct ImageAddition {
    std::vector<KeptImage> kept;
    std::size_t kept_row_bytes = 0;
    std::vector<DrawnLights> drawn; // just now
    bool corners = false;           // haze was sampled at the corners of the pixels
    std::vector<PlanePart> parts;   // nothing but these, which begin at even columns; empty: all
};

// base: rgba16f, or none; frame: rgba16f.
void add_pixels(const ImageAddition& images, const Plane& base, const Plane& frame);
// The same, of so many pixels a row to an image that is kept: rgba32ui, two pixels in a texel.
void keep_pixels(const ImageAddition& images, const Plane& base, int width, const Plane& kept);
// white: rgba32f, what light is multiplied with to have it on white, or none; points: rgba32ui
// (shared/coarse.h), the frame's or kept ones.
void add_points(const ImageAddition& images, const Plane& white, const Plane& points);

} // namespace ghost::render
