// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"
#include "scene/emitters.h"
#include "scene/show.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {

fixture::Patch PatchedFixture::patch() const {
    fixture::Patch patch;
    patch.name = name;
    patch.type = type.get();
    patch.mode = mode;
    patch.addresses = {{universe, address}};
    patch.addresses.insert(patch.addresses.end(), more_addresses.begin(), more_addresses.end());
    patch.invert_pan = invert_pan;
    patch.invert_tilt = invert_tilt;
    return patch;
}

glm::mat4 camera_to_world(const Camera& camera) {
    const glm::vec3 backward = glm::normalize(camera.position_m - camera.target_m);
    // Straight up or down, the top of the picture is up-stage.
    const glm::vec3 up = std::abs(backward.z) > 0.9999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 right = glm::normalize(glm::cross(up, backward));
    return {glm::vec4(right, 0), glm::vec4(glm::cross(backward, right), 0), glm::vec4(backward, 0),
            glm::vec4(camera.position_m, 1)};
}

glm::mat4 placed(const glm::vec3& position_m, const glm::vec3& rotation_deg) {
    glm::mat4 matrix = glm::translate(glm::mat4(1.0f), position_m);
    matrix = glm::rotate(matrix, glm::radians(rotation_deg.z), glm::vec3(0, 0, 1));
    matrix = glm::rotate(matrix, glm::radians(rotation_deg.y), glm::vec3(0, 1, 0));
    return glm::rotate(matrix, glm::radians(rotation_deg.x), glm::vec3(1, 0, 0));
}

glm::mat4 fixture_to_world(const PatchedFixture& fixture, std::size_t stop) {
    const std::vector<glm::vec3> stops = fixture.stops_m();
    CHECK(stop < stops.size());
    return placed(stops[stop], fixture.rotation_deg);
}

glm::vec3 light_position_m(const PatchedFixture& fixture, std::size_t stop) {
    const glm::mat4 to_world = fixture_to_world(fixture, stop);
    if (!fixture.type) return glm::vec3(to_world[3]);
    const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
    return glm::vec3(to_world * glm::vec4(emitters_of(*fixture.type, mode).middle_m, 1.0f));
}

std::vector<glm::vec3> light_places_m(const PatchedFixture& fixture, std::size_t stop) {
    std::vector<glm::vec3> places_m;
    if (!fixture.type) return places_m;
    const glm::mat4 to_world = fixture_to_world(fixture, stop);
    const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
    for (const glm::vec3& place_m : emitters_of(*fixture.type, mode).places_m)
        places_m.push_back(glm::vec3(to_world * glm::vec4(place_m, 1.0f)));
    return places_m;
}

} // namespace ghost::scene
