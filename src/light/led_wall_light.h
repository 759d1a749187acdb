#pragma once
// SPDX-License-Identifier: Apache-2.0
// LED walls: a fixture whose front shows a moving picture as pixels of a stated luminance. The camera sees
// the picture on it (shared/led_wall.h); stage and haze are lit by the mean colour of each cell of a coarse
// grid, one wide light a cell (fixture_files/common/wall_type.h). Metres, cd/m^2. Pure.
// docs/design/led-walls.md.

#include "light/projector_beam.h"
#include "show/led_wall.h"
#include "show/media.h"

#include <glm/glm.hpp>
#include <string>

namespace ghost::shared {
struct Light;
struct LedWall;
struct SlidePicture;
} // namespace ghost::shared

namespace ghost::scene {

glm::ivec2 cells_of(const LedWall& wall);

// The wall as the camera sees it. to_world: of the fixture; factor: of its light (dimmer, gels).
shared::LedWall seen_wall(const LedWall& wall, const glm::mat4& to_world, const MediaNow& now,
                          const glm::vec3& factor);

// Mean colour of a cell of the grid, as a fraction of full white. cell: row by row, the top left one first.
glm::vec3 cell_fraction(const LedWall& wall, int cell, const MediaNow& now,
                        const shared::SlidePicture& picture);

// Makes a light of a cell, which light_from has put and aimed, as bright as the cell at full dimmer: lumens
// are those of a surface that is equally bright from all sides.
void light_cell(const LedWall& wall, const glm::vec3& fraction, shared::Light& light);

} // namespace ghost::scene
