// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include "base/check.h"

namespace ghost::image {

ImageF averaged(const ImageF& picture, int factor) {
    CHECK(factor >= 1);
    if (factor == 1) return picture;
    ImageF small(picture.width / factor, picture.height / factor, picture.channels);
    const float share = 1.0f / static_cast<float>(factor * factor);
    for (int y = 0; y < small.height * factor; ++y)
        for (int x = 0; x < small.width * factor; ++x)
            for (int c = 0; c < picture.channels; ++c)
                small.at(x / factor, y / factor)[c] += share * picture.at(x, y)[c];
    return small;
}

} // namespace ghost::image
