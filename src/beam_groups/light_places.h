#pragma once
// SPDX-License-Identifier: Apache-2.0
// Where the lights of a fixture come from; world metres. Pure.

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::scene {

struct PatchedFixture;

// Where the light comes from for passes: the pivot of the head (tilt axis), which does not move when the head
// turns, or the middle of the lights of a bar.
glm::vec3 light_position_m(const PatchedFixture& fixture, std::size_t stop);

// Where distance maps are made: BeamGroups::places_m. None where all beams only glow.
std::vector<glm::vec3> light_places_m(const PatchedFixture& fixture, std::size_t stop);

} // namespace ghost::scene
