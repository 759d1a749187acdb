// SPDX-License-Identifier: Apache-2.0
#include "beam_groups/light_places.h"

#include "beam_groups/beam_groups.h"
#include "show/show.h"

namespace ghost::scene {

glm::vec3 light_position_m(const PatchedFixture& fixture, std::size_t stop) {
    const glm::mat4 to_world = fixture_to_world(fixture, stop);
    if (!fixture.type) return glm::vec3(to_world[3]);
    const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
    return glm::vec3(to_world * glm::vec4(beam_groups_of(*fixture.type, mode).middle_m, 1.0f));
}

std::vector<glm::vec3> light_places_m(const PatchedFixture& fixture, std::size_t stop) {
    std::vector<glm::vec3> places_m;
    if (!fixture.type) return places_m;
    const glm::mat4 to_world = fixture_to_world(fixture, stop);
    const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
    for (const glm::vec3& place_m : beam_groups_of(*fixture.type, mode).places_m)
        places_m.push_back(glm::vec3(to_world * glm::vec4(place_m, 1.0f)));
    return places_m;
}

} // namespace ghost::scene
