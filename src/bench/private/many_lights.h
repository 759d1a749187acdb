#pragma once
// SPDX-License-Identifier: Apache-2.0
// A festival for tables: up to 1000 moving heads over a stage hung as tools/make_festival.py hangs it, the
// geometry reduced to boxes. Metres, Z up. Any thread.

#include "shared/types.h"
#include "stage/stage.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::app {

struct Place {
    glm::vec3 position_m{0};
    bool stands = false; // on the floor, light goes up
};

// Ten trusses in double rows, floor rows, ladders, wings, delay towers, a grid beside the wall: 1000 places,
// after tools/festival/layout.py.
std::vector<Place> festival_places();
scene::Stage festival_stage();
// Of the places evenly so many, all turning. Three spots to one wash; every other spot has a gobo.
std::vector<shared::Light> festival_lights(const std::vector<Place>& places, std::size_t count,
                                           double seconds);

} // namespace ghost::app
