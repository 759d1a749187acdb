#pragma once
// SPDX-License-Identifier: Apache-2.0
// Cameras for a show that has none: house (the audience), close (on the stage) and high (from the side),
// measured from where the fixtures hang and what stands below them; and haze that fits the size of the place.
// Exposure is automatic: nobody has measured the light yet. World metres, Y up-stage. Pure.

#include "show/camera.h"

#include <vector>

namespace ghost::scene {

struct Show;
struct Stage;

// show.fixtures and show.stage, one of which may be empty; with both empty they look at the origin.
std::vector<Camera> default_cameras(const Show& show);

// The first of them: all fixtures and the ground below them, from before the walls.
Camera house_camera(const Show& show, const Stage& stage);

// Thin enough to see the back of the rig from the house.
float default_extinction_per_m(const std::vector<Camera>& cameras);

inline constexpr float kDefaultAmbient_lux = 1.5f;

} // namespace ghost::scene
