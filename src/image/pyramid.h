#pragma once
// SPDX-License-Identifier: Apache-2.0
// A picture as a square of levels, each half as many texels a side as the one before and the mean of it (of
// light, not of code values), for moving pictures in the gate of a projector. Any thread.

#include "image/image.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace ghost::image {

inline constexpr int kLeastPyramid = 4; // texels a side of the last level

struct Pyramid {
    int side = 0; // of level 0: a power of two
    glm::vec2 extent{
        1.0f}; // share of the square that the picture takes, in its middle; beyond, its rim goes on
    glm::vec3 mean{0.0f}; // of the picture: linear, Rec.709
    // Per level side * side * RGBA, sRGB, top row first; alpha is in the colours.
    std::shared_ptr<const std::vector<std::vector<std::uint8_t>>> levels;
};

// Size in which a picture fits into the square; never below 1.
glm::ivec2 fitted(int width, int height, int side);

// rgba: sRGB, any size; what is not fitted() is resampled, slowly. side: a power of two, at least
// kLeastPyramid.
Pyramid make_pyramid(const Image8& rgba, int side);

} // namespace ghost::image
