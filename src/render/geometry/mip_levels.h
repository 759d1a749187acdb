#pragma once
// SPDX-License-Identifier: Apache-2.0
// Mip levels of an RGBA picture, each the mean of 2x2 texels of the one above, down to 1x1. Where bumps are
// too small to be seen their mean is smooth, yet they still scatter what is reflected: that is kept in alpha,
// as the square root of the variance of their slopes (Toksvig, Mipmapping Normal Maps, 2005). Pure; on all
// cores.

#include "image/image.h"

#include <vector>

namespace ghost::render {

enum class TextureUse {
    data,
    colour, // sRGB: red, green and blue are averaged as light
    bumps   // normals in tangent space
};

// first: finest levels that are left out of the result.
std::vector<image::Image8> mip_levels(const image::Image8& pixels, TextureUse use, int first);

} // namespace ghost::render
