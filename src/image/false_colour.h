#pragma once
// SPDX-License-Identifier: Apache-2.0
// False colour: a quantity that spans decades (lux, cd/m^2) as colours from dark blue over green to dark red,
// by its logarithm. Below the scale almost black, above it white, so that neither is taken for a value of it.
// The colours are those of Turbo (Mikhailov 2019). Pure.

#include "image/image.h"

#include <array>
#include <cstdint>

namespace ghost::image {

// low above 0, high above low, in the unit of the values.
struct Scale {
    float low = 1;
    float high = 1000;
    bool operator==(const Scale&) const = default;
};

using Rgb8 = std::array<std::uint8_t, 3>; // sRGB

// Place on the scale, 0 low .. 1 high; may lie beyond both.
float place_on(const Scale& scale, float value);
// NaN is shown as what lies below.
Rgb8 false_colour(const Scale& scale, float value);
// One channel -> RGBA.
Image8 false_coloured(const ImageF& values, const Scale& scale);

} // namespace ghost::image
