// SPDX-License-Identifier: Apache-2.0
#include "show/show.h"

#include "base/check.h"
#include "base/suggest.h"

#include <algorithm>
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

Result<std::size_t> Show::find_camera(const std::string& camera_name) const {
    if (cameras.empty()) return Error{"has no camera", file.string()};
    if (camera_name.empty()) return std::size_t{0};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        if (cameras[k].name == camera_name) return k;
        names.push_back(cameras[k].name);
    }
    std::string what =
        "has no camera '" + camera_name + "'" + did_you_mean(camera_name, names) + " (cameras:";
    for (std::size_t k = 0; k < names.size() && k < 20; ++k) what += (k ? ", '" : " '") + names[k] + "'";
    return Error{what + ")", file.string()};
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

glm::vec3 rotation_towards(const glm::vec3& from_m, const glm::vec3& target_m) {
    const glm::vec3 way = target_m - from_m;
    if (glm::length(way) < 1e-6f) return glm::vec3(0.0f);
    const glm::vec3 d = glm::normalize(way);
    const float tilt = std::acos(std::clamp(-d.z, -1.0f, 1.0f));
    const float turn = std::hypot(d.x, d.y) < 1e-6f ? 0.0f : std::atan2(-d.x, d.y);
    return glm::degrees(glm::vec3(tilt, 0.0f, turn));
}

} // namespace ghost::scene
