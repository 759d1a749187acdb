#pragma once
// SPDX-License-Identifier: Apache-2.0
// Aiming a moving head at a point: the pan and tilt whose beam goes there. Pure.

#include <glm/glm.hpp>

namespace ghost::scene {

struct PanTilt {
    float pan_deg = 0;
    float tilt_deg = 0;
};

// direction: from the head to the point, in the fixture's frame (which hangs: its beam leaves along -Z at pan
// and tilt 0). Of the ways to point there the one with the least turn from `now`, within half a turn and a
// half of pan each way.
PanTilt aim(const glm::vec3& direction, const PanTilt& now);

} // namespace ghost::scene
