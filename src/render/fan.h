#pragma once
// SPDX-License-Identifier: Apache-2.0
// The fan of a light for an eye (shaders/shared/fan.h), and how fine its table must be. Pure.

#include "shared/fan.h"
#include "shared/types.h"

namespace ghost::render {

// pixels_per_rad: of the picture, in its middle. A beam that is small in the picture needs less.
shared::Fan make_fan(const shared::Light& light, const glm::vec3& eye_m, float pixels_per_rad,
                     std::uint32_t layer);

} // namespace ghost::render
