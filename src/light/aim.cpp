// SPDX-License-Identifier: Apache-2.0
#include "light/aim.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ghost::scene {

namespace {

constexpr float kMostPan_deg = 270; // what nearly every head reaches
constexpr float kSteep = 1e-4f;     // sine of the tilt below which every pan points there

} // namespace

// Pan p and tilt t send the beam along Rz(p) Rx(t) (0, 0, -1) = (-sin p sin t, cos p sin t, -cos t).
PanTilt aim(const glm::vec3& direction, const PanTilt& now) {
    const float length = glm::length(direction);
    if (!(length > 0)) return now;
    const glm::vec3 way = direction / length;
    const float across = std::hypot(way.x, way.y);
    const float tilt_deg = glm::degrees(std::atan2(across, -way.z));
    if (across < kSteep) return {now.pan_deg, tilt_deg};
    const float pan_deg = glm::degrees(std::atan2(-way.x, way.y));
    PanTilt best = now;
    float least = std::numeric_limits<float>::max();
    for (const float side : {1.0f, -1.0f}) // over the other shoulder: half a turn of pan, tilt the other way
        for (int turn = -1; turn <= 1; ++turn) {
            const PanTilt one{pan_deg + (side < 0 ? 180.0f : 0.0f) + 360.0f * static_cast<float>(turn),
                              side * tilt_deg};
            if (std::abs(one.pan_deg) > kMostPan_deg) continue;
            const float way_deg =
                std::max(std::abs(one.pan_deg - now.pan_deg), std::abs(one.tilt_deg - now.tilt_deg));
            if (way_deg < least) {
                least = way_deg;
                best = one;
            }
        }
    return best;
}

} // namespace ghost::scene
