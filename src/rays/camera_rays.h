#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rays of a pinhole camera. Pixels, y down; world metres. Pure.

#include "show/camera.h"

#include <cmath>
#include <glm/glm.hpp>

namespace ghost::bake {

struct CameraRays {
    glm::vec3 eye{0};
    glm::vec3 forward{0};
    glm::vec3 right{0}; // to the edge of the picture
    glm::vec3 up{0};
    float width = 1;
    float height = 1;

    explicit CameraRays(const scene::Camera& camera)
        : width(static_cast<float>(camera.width)), height(static_cast<float>(camera.height)) {
        const glm::mat4 world = scene::camera_to_world(camera);
        const float tan_y = std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
        right = glm::vec3(world[0]) * (tan_y * width / height);
        up = glm::vec3(world[1]) * tan_y;
        forward = -glm::vec3(world[2]);
        eye = glm::vec3(world[3]);
    }

    glm::vec3 direction(float x, float y) const {
        return glm::normalize(forward + right * (2.0f * x / width - 1.0f) + up * (1.0f - 2.0f * y / height));
    }
    // Width of a pixel at this distance from the eye.
    float pixel_m(float distance_m) const { return distance_m * 2.0f * glm::length(up) / height; }
};

} // namespace ghost::bake
