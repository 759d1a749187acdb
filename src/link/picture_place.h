#pragma once
// SPDX-License-Identifier: Apache-2.0
// Where a picture lies in a window, whoever shows it there. Pure.

#include "link/link.h"

namespace ghost::ui {

// In doubles, for pixels are counted in it.
struct Rect {
    double x = 0, y = 0, width = 0, height = 0;
};
// Where a frame lies in a window: in its middle, as large as all of it fits. Without pixels: all of it.
Rect place_of_frame(double width, double height, const glm::ivec2& frame);
// Where a picture of that size lies in the window: so that its frame lies there, all of it.
Rect place_of_picture(double width, double height, const glm::ivec2& picture, const Framed& framed);

} // namespace ghost::ui
