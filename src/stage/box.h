#pragma once
// SPDX-License-Identifier: Apache-2.0
// The box round some places, and round each instance of a stage. Pure.

#include <glm/glm.hpp>
#include <vector>

namespace ghost::scene {

struct Box {
    glm::vec3 low_m{1e30f}, high_m{-1e30f};

    void add(const glm::vec3& place_m) {
        low_m = glm::min(low_m, place_m);
        high_m = glm::max(high_m, place_m);
    }
    void add(const glm::vec3& place_m, float radius_m) {
        add(place_m - radius_m);
        add(place_m + radius_m);
    }
    bool is_empty() const { return low_m.x > high_m.x; }
    bool holds(const glm::vec3& place_m) const {
        return glm::all(glm::lessThanEqual(low_m, place_m)) && glm::all(glm::lessThanEqual(place_m, high_m));
    }
    glm::vec3 middle_m() const { return 0.5f * (low_m + high_m); }
    glm::vec3 size_m() const { return high_m - low_m; }
};

struct Stage;
// In the world; empty where there is no triangle.
std::vector<Box> boxes_of(const Stage& stage);

} // namespace ghost::scene
