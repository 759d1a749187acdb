#pragma once
// SPDX-License-Identifier: Apache-2.0
// Video projectors as a show sets them; what their beam then is: light/projector_beam.h.
// docs/design/projectors.md. Values only.

#include "show/media.h"

#include <glm/glm.hpp>

namespace ghost::scene {

enum class Fit {
    contain, // the whole picture, black beside it
    cover,   // the whole panel, the picture's ends cut off
    stretch,
};

struct Projector {
    int media = -1;   // Show::media; -1: a test card
    float lumens = 0; // of full white; 0: as the fixture's lamp
    float throw_ratio =
        0; // distance over width of the panel's picture; 0: its diagonal fills the fixture's field
    float aspect = 16.0f / 9.0f; // of the panel
    glm::vec2 lens_shift{0.0f};  // to the right and up, in widths and heights of the panel's picture
    glm::vec2 keystone_deg{
        0.0f}; // the picture is right on a wall turned by so much, about the vertical and the horizontal
    float contrast = 2000; // white over black
    glm::vec4 blend{0.0f}; // left, right, bottom, top: share of the picture that fades out
    Fit fit = Fit::contain;
    float focus_m = 0; // where the picture is sharp; 0: as the fixture is focused
    // A DMX channel that chooses the medium: 0 leaves `media`, n is the n-th of the show.
    int universe = 0;
    int address = 0; // 1-based; 0: none
};

} // namespace ghost::scene
