#pragma once
// SPDX-License-Identifier: Apache-2.0
// LED walls: a fixture whose front shows a moving picture as pixels of a stated luminance. The camera sees
// the picture on it (shared/led_wall.h); stage and haze are lit by the mean colour of each cell of a coarse
// grid, one wide light a cell (fixture/wall_type.h). Metres, cd/m^2. Pure. docs/led-walls.md.

#include "scene/media.h"
#include "scene/projector.h"

#include <glm/glm.hpp>
#include <string>

namespace ghost::shared {
struct Light;
struct LedWall;
struct SlidePicture;
} // namespace ghost::shared

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

glm::ivec2 cells_of(const LedWall& wall);

// The wall as the camera sees it. to_world: of the fixture; factor: of its light (dimmer, gels).
shared::LedWall seen_wall(const LedWall& wall, const glm::mat4& to_world, const MediaNow& now,
                          const glm::vec3& factor);

// Mean colour of a cell of the grid, as a share of full white. cell: row by row, the top left one first.
glm::vec3 cell_share(const LedWall& wall, int cell, const MediaNow& now, const shared::SlidePicture& picture);

// Makes a light of a cell, which light_from has put and aimed, as bright as the cell at full dimmer: lumens
// are those of a surface that is equally bright from all sides.
void light_cell(const LedWall& wall, const glm::vec3& share, shared::Light& light);

} // namespace ghost::scene
