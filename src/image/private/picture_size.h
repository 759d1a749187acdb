#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureSize: pixels as the header of a picture file states them, before anything is made room for.

#include <cstddef>

namespace ghost::image {

struct PictureSize {
    int width = 0, height = 0;
    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

} // namespace ghost::image
