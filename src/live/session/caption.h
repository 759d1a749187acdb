#pragma once
// SPDX-License-Identifier: Apache-2.0
// A line of text burnt into the lower left corner of a picture, on a dark ground: what is shown is not the
// best that could be. Capitals, digits and a few signs, 5x7 dots; other characters are left blank. Pure.

#include "image/image.h"

#include <string>

namespace ghost::app {

// picture: RGBA. Letters grow with the picture; a line that is too long is cut at the edge.
void draw_caption(image::Image8& picture, const std::string& text);

} // namespace ghost::app
