#pragma once
// SPDX-License-Identifier: Apache-2.0
// Test cards, drawn: for setting up projectors, and what is shown where a source has nothing. Pure.

#include "image/image.h"

#include <string_view>

namespace ghost::video {

// "grid": squares, a circle, the corners marked; "bars": the eight colours; "ramp": black to white; "white".
// 16:9, sRGB. Any other name is a grid.
image::Image8 test_card(std::string_view name);

// Slanted stripes of magenta: something is missing here.
image::Image8 missing_card();

} // namespace ghost::video
