#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which grid of camera rays a light's haze is known on while the picture moves (shaders/common/grid.glsl),
// from the part of its fan that the picture shows. Pure.

#include "shared/fan.h"
#include "shared/push.h"
#include "shared/types.h"

#include <optional>

namespace ghost::render {

// reach_m: along the beam, from its apex, beyond which nothing of it is lit. Nothing: so few pixels see the
// beam that a grid costs more than they do.
std::optional<shared::HazeGrid> make_grid(const shared::Light& light, const shared::Fan& fan,
                                          const shared::View& view, float pixels_per_rad, float reach_m);

} // namespace ghost::render
