// SPDX-License-Identifier: Apache-2.0
#include "live/session/atmosphere.h"

#include "base/check.h"
#include "render/relight/relighter.h"

#include <algorithm>
#include <cmath>

namespace ghost::app {

shared::Haze Atmosphere::medium() const {
    return {haze.extinction_per_m, haze.extinction_per_m * haze.albedo, haze.forward_g, haze.back_g,
            haze.back_weight};
}

bool Atmosphere::is_uneven() const {
    return haze.unevenness > 0 || !hazers.empty();
}

shared::Air Atmosphere::field(double time_s) const {
    constexpr float kChurn = 0.25f; // radians a second: swirls live for some ten seconds
    const float moved_s = is_uneven() ? static_cast<float>(time_s) : 0.0f;
    shared::Air air = render::even_air();
    air.attenuation = {attenuation.constant, attenuation.linear, attenuation.quadratic};
    air.unevenness = haze.unevenness;
    air.drift_m = haze.wind_m_s * moved_s;
    air.per_m = 2.0f * shared::kPi / std::max(2.0f * haze.patch_m, 0.1f);
    air.churn = kChurn * moved_s;
    for (const scene::Hazer& hazer : hazers) {
        CHECK(air.hazers < shared::kMostHazers);
        air.plume[air.hazers++] = {hazer.position_m, hazer.rate,
                                   hazer.direction,  std::tan(glm::radians(0.5f * hazer.spread_deg)),
                                   hazer.reach_m,    0.0f};
    }
    return air;
}

Atmosphere atmosphere_of(const scene::Show& show, const scene::SceneLook& look, float density) {
    constexpr float kMostSmoke = 20, kMostLux = 100000;
    Atmosphere air{show.haze, show.hazers, show.attenuation, {}};
    air.haze.extinction_per_m *= std::clamp(look.smoke.value_or(1.0f), 0.0f, kMostSmoke) * density;
    if (look.attenuation) air.attenuation = {look.attenuation->x, look.attenuation->y, look.attenuation->z};
    air.ambient = look.ambient_colour.value_or(show.ambient_colour) *
                  std::clamp(look.ambient_lux.value_or(show.ambient_lux), 0.0f, kMostLux);
    return air;
}

} // namespace ghost::app
