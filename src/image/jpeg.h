#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pictures for a network: made smaller, and written as JPEG (ITU-T T.81, baseline) by libjpeg-turbo. Any
// thread.

#include "base/result.h"
#include "image/image.h"

#include <cstdint>
#include <vector>

namespace ghost::image {

struct JpegQuality {
    int percent = 75;         // 1..100
    bool full_colour = false; // 4:4:4; else colour has half of the pixels each way
};

// 3 or 4 channels; alpha is left out.
Result<std::vector<std::uint8_t>> encode_jpeg(const Image8& pixels, const JpegQuality& quality);

// As wide as that at most, in the shape that it has, at least one pixel high: each pixel the mean of the code
// values of those that it covers.
Image8 narrowed(const Image8& pixels, int width);

} // namespace ghost::image
