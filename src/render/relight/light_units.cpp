// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_units.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ghost::render {
namespace {

// A light this much brighter than its unit is drawn anew: half floats end near what a lens shows.
constexpr float kMostWeight = 4;
constexpr float kSameBounce = 1e-3f;

float brightest(const glm::vec3& value) {
    return std::max({value.x, value.y, value.z});
}

} // namespace

bool same_shape(const shared::Light& a, const shared::Light& b) {
    shared::Light as_b = a;
    as_b.intensity_cd = b.intensity_cd;
    as_b.bounce_cd = b.bounce_cd;
    return std::memcmp(&as_b, &b, sizeof b) == 0;
}

// The light is a weight times its unit.
bool LightUnits::holds(const shared::Light& light, const Unit& unit) const {
    const float most_cd = brightest(light.intensity_cd);
    if (most_cd > kMostWeight * unit.intensity_cd) return false;
    for (int c = 0; bounces_ && c < 3; ++c) {
        const float expected = unit.bounce[c] * light.intensity_cd[c];
        if (std::abs(light.bounce_cd[c] - expected) > kSameBounce * std::max(expected, light.bounce_cd[c]))
            return false;
    }
    return true;
}

LightUnits::Changes LightUnits::look(const std::vector<shared::Light>& lights) {
    Changes changes;
    const bool known = lights_.size() == lights.size();
    units_.resize(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const shared::Light& light = lights[i];
        if (known && std::memcmp(&light, &lights_[i], sizeof light) == 0) continue;
        if (known && same_shape(light, lights_[i]) && holds(light, units_[i])) {
            changes.dimmed.push_back(static_cast<int>(i));
            continue;
        }
        changes.changed.push_back(static_cast<int>(i));
        Unit& unit = units_[i];
        unit.intensity_cd = brightest(light.intensity_cd);
        for (int c = 0; c < 3; ++c)
            unit.bounce[c] = light.intensity_cd[c] > 0 ? light.bounce_cd[c] / light.intensity_cd[c] : 0.0f;
    }
    lights_ = lights;
    return changes;
}

shared::Light LightUnits::at_unit(int light) const {
    const auto i = static_cast<std::size_t>(light);
    shared::Light unit = lights_[i];
    unit.intensity_cd = glm::vec3(units_[i].intensity_cd);
    unit.bounce_cd = units_[i].bounce * units_[i].intensity_cd;
    return unit;
}

glm::vec3 LightUnits::weight(int light) const {
    const auto i = static_cast<std::size_t>(light);
    return units_[i].intensity_cd > 0 ? lights_[i].intensity_cd / units_[i].intensity_cd : glm::vec3(0.0f);
}

} // namespace ghost::render
