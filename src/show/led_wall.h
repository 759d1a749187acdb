#pragma once
// SPDX-License-Identifier: Apache-2.0
// LED walls as a show sets them; what they send out: light/led_wall_light.h. Metres, cd/m^2. Values only.

#include "show/projector.h"

#include <glm/glm.hpp>
#include <string>

namespace ghost::scene {

inline constexpr int kMostWallCells = 8; // on a side
inline constexpr float kWallDepth_m = 0.1f;

struct LedWall {
    int media = 0; // Show::media
    glm::vec2 size_m{4, 2.25f};
    float nits = 1500;       // cd/m^2 of full white
    float pitch_m = 0.0039f; // of its LEDs
    glm::ivec2 cells{0};     // of the light that it throws; 0: by its size
    Fit fit = Fit::contain;
    float reach_m = 0.01f; // surfaces so far before or behind the rectangle show the picture, too
    bool has_body = true;  // false: the plot draws it
    // A DMX channel that chooses the medium, as a projector's.
    int universe = 0;
    int address = 0;
};

// Of a [[wall]]: walls of the plot with such a name are like this, but as large and shaped as they are drawn.
struct WallSettings {
    std::string name;  // a pattern, as for an [[object]]
    std::string where; // file:line, for messages
    LedWall wall;
};

} // namespace ghost::scene
