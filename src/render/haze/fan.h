#pragma once
// SPDX-License-Identifier: Apache-2.0
// The fan of a light for an eye (shaders/shared/fan.h), and how fine its table must be. Pure.

#include "render/haze/fan_nodes.h"
#include "shared/fan.h"
#include "shared/types.h"

namespace ghost::render {

// Rows and columns of the shade.
enum class ShadeDetail {
    full,
    seen,   // no more than the beam's width in the picture asks for
    coarse, // likewise, and half of all of them at most
};

// pixels_per_rad: of the picture, in its middle. A beam that is small in the picture needs less. reach_m:
// along the beam, from its apex, beyond which nothing of it is seen. detail: of shaped beams.
shared::Fan make_fan(const shared::Light& light, const glm::vec3& eye_m, float pixels_per_rad, float reach_m,
                     FanDetail detail, std::uint32_t layer, ShadeDetail shade = ShadeDetail::full);

} // namespace ghost::render
