#pragma once
// SPDX-License-Identifier: Apache-2.0
// Mip levels of an RGBA picture, each the mean of 2x2 texels of the one above, down to 1x1. Pure.

#include "image/image.h"

#include <vector>

namespace ghost::render {

// srgb: red, green and blue are averaged as light. first: finest levels that are left out of the result.
std::vector<image::Image8> mip_levels(const image::Image8& pixels, bool srgb, int first);

} // namespace ghost::render
