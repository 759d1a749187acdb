// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"
#include "scene/show.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

glm::mat4 node_to_fixture(const fixture::Mode& mode, int node) {
    glm::mat4 matrix(1.0f);
    for (; node >= 0; node = mode.nodes[static_cast<std::size_t>(node)].parent)
        matrix = mode.nodes[static_cast<std::size_t>(node)].local * matrix;
    return matrix;
}

bool turns(const fixture::Mode& mode, int node) {
    for (const fixture::Axis& axis : mode.axes)
        if (axis.node == node) return true;
    return false;
}

// The axis next to the beam (tilt on a moving head), else the beam itself, in the fixture's frame. Pan turns
// the tilt axis about a line through it, so its origin stays.
glm::vec3 pivot_of(const fixture::Mode& mode) {
    if (mode.beams.empty()) return glm::vec3(0.0f);
    const int beam = mode.beams.front();
    int node = beam;
    while (node >= 0 && !turns(mode, node)) node = mode.nodes[static_cast<std::size_t>(node)].parent;
    return glm::vec3(node_to_fixture(mode, node >= 0 ? node : beam)[3]);
}

} // namespace

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

glm::mat4 fixture_to_world(const PatchedFixture& fixture, std::size_t stop) {
    const std::vector<glm::vec3> stops = fixture.stops_m();
    CHECK(stop < stops.size());
    glm::mat4 matrix = glm::translate(glm::mat4(1.0f), stops[stop]);
    matrix = glm::rotate(matrix, glm::radians(fixture.rotation_deg.z), glm::vec3(0, 0, 1));
    matrix = glm::rotate(matrix, glm::radians(fixture.rotation_deg.y), glm::vec3(0, 1, 0));
    return glm::rotate(matrix, glm::radians(fixture.rotation_deg.x), glm::vec3(1, 0, 0));
}

glm::vec3 light_position_m(const PatchedFixture& fixture, std::size_t stop) {
    const glm::mat4 to_world = fixture_to_world(fixture, stop);
    if (!fixture.type) return glm::vec3(to_world[3]);
    const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
    return glm::vec3(to_world * glm::vec4(pivot_of(mode), 1.0f));
}

} // namespace ghost::scene
