// SPDX-License-Identifier: Apache-2.0
#include "light/illuminance.h"

#include "shared/beam.h"
#include "shared/haze.h"

#include <algorithm>

namespace ghost::scene {

glm::vec3 illuminance(const shared::Light& light, const glm::vec3& point_m, const glm::vec3& normal,
                      const shared::Gobos& gobos, const LitAir& air) {
    constexpr float kNearest_m = 0.01f; // as the shaders have it
    const glm::vec3 way = point_m - light.position_m;
    const float distance_m = std::max(glm::length(way), kNearest_m);
    const float cosine = -glm::dot(way, normal) / distance_m;
    if (cosine <= 0) return glm::vec3(0);
    const glm::vec3 q = shared::to_gate(light, way);
    const glm::vec3 candela = shared::beam_candela(light, q, gobos);
    return candela * (cosine / (distance_m * distance_m) *
                      shared::haze_transmittance(air.haze, shared::way_from_lens_m(light, q)) *
                      shared::attenuation_factor(air.attenuation, distance_m));
}

} // namespace ghost::scene
