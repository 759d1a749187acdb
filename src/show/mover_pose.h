#pragma once
// SPDX-License-Identifier: Apache-2.0
// Where the load of a mover is for the values of its axes (metres, degrees; show/movers.h): a rigid motion of
// the world, the identity while all values are 0. Pure; double, so that nested movers stay rigid.
//
// A truss on hoists is rigid and its chains hang straight down: of two points that lie L apart and are lifted
// by different heights h1 and h2 it tilts by asin((h2 - h1) / L) about the middle of its points, which rises
// by the mean. For three and more it is the plane of least squares through the heights. Neglected: that the
// chains lean by the way that the points come closer, sag, swing.

#include "show/movers.h"

#include <glm/glm.hpp>
#include <span>

namespace ghost::scene {

glm::dmat4 pose_of(const Mover& mover, std::span<const double> values);

// The axis values, which follow a tracker that has moved by this much in the frame of what carries the mover.
// Nothing of use: those of a mover that no tracker moves (hoists, revolve).
std::vector<double> values_towards(const Mover& mover, const glm::dvec3& by_m);

double length_m(const std::vector<glm::vec3>& path_m);

} // namespace ghost::scene
