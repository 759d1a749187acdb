#pragma once
// SPDX-License-Identifier: Apache-2.0
// Lasers: what a scanner makes of the beam of a laser. Rays that it jumps between are a light each, with an
// even fraction of the flux; a curve that it sweeps is one light with that curve in its gate
// (shaders/shared/figure.h). The eye sees the mean of a round of the scanner. Pure. docs/design/lasers.md.

#include "fixture/laser_curve.h"
#include "fixture/state.h"
#include "fixture/type.h"
#include "shared/types.h"
#include "show/laser.h"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ghost::scene {

struct Copy; // prism.h

// Directions of the rays of a figure that is not swept, as copies of a beam of this field.
std::vector<Copy> rays_of(const fixture::LaserCurve& figure, float tan_field);

// The beam, swept along the curve of a figure; the beam itself where the figure is smaller than it is wide.
shared::Light swept(const shared::Light& beam, const fixture::LaserCurve& figure);

} // namespace ghost::scene
