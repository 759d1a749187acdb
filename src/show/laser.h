#pragma once
// SPDX-License-Identifier: Apache-2.0
// `laser` of a [[fixture]]: what is set of a scanner (light/laser_rays.h). Values only.

#include "fixture/laser_curve.h"

#include <glm/vec3.hpp>
#include <optional>

namespace ghost::scene {

// `laser` of a [[fixture]].
struct Laser {
    fixture::LaserCurve figure;
    bool has_figure = false;         // it says how the figure is, where no channel does
    float watts = 0;                 // of light; 0: as its file says
    std::optional<glm::vec3> colour; // times that of the fixture, linear Rec.2020
};

} // namespace ghost::scene
