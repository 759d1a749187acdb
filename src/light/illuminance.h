#pragma once
// SPDX-License-Identifier: Apache-2.0
// Illuminance: what arrives from a light at a point of a surface, without shadows: E = I cos / d^2, by the
// beam of shared/beam.h, through the haze, with the show's attenuation. Lux by channel, linear Rec.2020: its
// luminance is what a meter shows. Pure.

#include "shared/attenuation.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <glm/glm.hpp>

namespace ghost::scene {

struct LitAir {
    shared::Haze haze{};
    shared::Attenuation attenuation{0, 0, 1};
};

// normal: unit, of the side that is asked about.
glm::vec3 illuminance(const shared::Light& light, const glm::vec3& point_m, const glm::vec3& normal,
                      const shared::Gobos& gobos, const LitAir& air = {});

} // namespace ghost::scene
