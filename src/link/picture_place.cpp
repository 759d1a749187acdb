// SPDX-License-Identifier: Apache-2.0
#include "link/picture_place.h"

#include <algorithm>

namespace ghost::ui {

Rect place_of_frame(double width, double height, const glm::ivec2& frame) {
    if (frame.x <= 0 || frame.y <= 0) return {0, 0, width, height};
    const double scale = std::min(width / frame.x, height / frame.y);
    const double across = scale * frame.x, up = scale * frame.y;
    return {(width - across) / 2, (height - up) / 2, across, up};
}

Rect place_of_picture(double width, double height, const glm::ivec2& picture, const Framed& framed) {
    const glm::ivec2 size = glm::max(picture, 1);
    if (framed.frame.x <= 0 || framed.frame.y <= 0) return place_of_frame(width, height, size);
    const Rect frame = place_of_frame(width, height, framed.frame);
    const double up = frame.height / static_cast<double>(framed.share), across = up * size.x / size.y;
    return {frame.x + (frame.width - across) / 2, frame.y + (frame.height - up) / 2, across, up};
}

} // namespace ghost::ui
