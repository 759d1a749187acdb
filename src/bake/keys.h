#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a pass depends on, as hashes (hasher.h): a pass whose key did not change is not baked again. Pure.

#include "bake/frame.h"
#include "light/bodies.h"
#include "show/camera.h"
#include "stage/stage.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::bake {

// Raise it when the same input gives another picture than before.
inline constexpr int kBakerVersion = 3;

// Keys of the stage without fixture bodies, and of each fixture's body (empty where it has none).
struct StageKeys {
    std::string stage;
    std::vector<std::string> bodies; // per fixture
};
StageKeys stage_keys(const scene::Stage& stage_with_bodies, std::size_t fixture_count);

std::string geometry_key(const StageKeys& keys, const scene::Camera& camera, int spp);
std::string light_key(const std::string& geometry_key, const glm::vec3& position_m, int bounces);

// Where in the picture the bodies of a fixture are; empty where the camera does not see them.
Rect body_rect(const scene::Stage& stage, int fixture, const scene::Camera& camera);

} // namespace ghost::bake
