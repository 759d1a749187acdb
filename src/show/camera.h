#pragma once
// SPDX-License-Identifier: Apache-2.0
// Camera: where the picture is seen from, and how. Metres, degrees; Z up. Plain values.

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

namespace ghost::scene {

struct Camera {
    std::string name;
    glm::vec3 position_m{0, -10, 2};
    glm::vec3 target_m{0, 0, 2};
    float fov_y_deg = 40; // vertical
    int width = 1280;
    int height = 720;
    float ev100 = 6; // exposure
    bool auto_exposure = false;
    std::filesystem::path
        foreign_passes; // a passes.toml rendered elsewhere (docs/reference/foreign-passes.md), or empty
    int mover = -1;     // that carries it (show/movers.h); -1: none
};

// Camera space to world (columns: right, up, backward, eye); the camera looks down its -Z.
glm::mat4 camera_to_world(const Camera& camera);

} // namespace ghost::scene
