// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_box.h"

#include "image/finite.h"

#include <cmath>
#include <limits>

namespace ghost::scene {
namespace {

constexpr float kRoundLamps_m = 6;    // at least
constexpr float kFarFromLamps_m = 30; // at most
constexpr float kSkin_m = 0.05f;      // walls lie within

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{-std::numeric_limits<float>::max()};

    bool empty() const { return low.x > high.x; }
    void add(const glm::vec3& point, float margin = 0) {
        if (!image::is_finite(point)) return;
        low = glm::min(low, point - margin);
        high = glm::max(high, point + margin);
    }
};

} // namespace

BounceBox bounce_box(const Stage& stage, const std::vector<shared::Light>& lights) {
    std::vector<glm::vec3> lamps_m;
    for (const shared::Light& light : lights) lamps_m.push_back(light.position_m - light.off_map_m);
    return bounce_box(stage, lamps_m);
}

BounceBox bounce_box(const Stage& stage, const std::vector<glm::vec3>& lamps_m) {
    Bounds room, lamps, near_lamps;
    for (const glm::vec3& place_m : lamps_m) {
        lamps.add(place_m);
        near_lamps.add(place_m, kRoundLamps_m);
    }
    for (const Instance& instance : stage.instances) {
        if (!instance.shown || instance.fixture != kNone || instance.mesh < 0 ||
            instance.mesh >= static_cast<int>(stage.meshes.size()))
            continue;
        for (const glm::vec3& position : stage.meshes[static_cast<std::size_t>(instance.mesh)].positions)
            room.add(glm::vec3(instance.world * glm::vec4(position, 1)), kSkin_m);
    }
    if (lamps.empty()) return room.empty() ? BounceBox{} : BounceBox{room.low, room.high};
    if (room.empty()) room = near_lamps;
    room.add(near_lamps.low);
    room.add(near_lamps.high);
    return {glm::max(room.low, lamps.low - kFarFromLamps_m),
            glm::min(room.high, lamps.high + kFarFromLamps_m)};
}

} // namespace ghost::scene
