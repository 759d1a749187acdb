// SPDX-License-Identifier: Apache-2.0
#include "photometry/frost_flux.h"

#include "shared/beam.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int kClearPoints = 6000, kFrostedPoints = 2000;
constexpr float kGoldenAngle = 2.3999632f;
constexpr float kBlurPerPoint = 0.35f;  // of the distance between two points, so that none falls between
constexpr float kMostCorrection = 8.0f; // of what is nearly dark
constexpr float kLeastFlux_lm = 1e-6f;
constexpr float kTurns = 256; // angles of a picture that turns
constexpr std::size_t kMostGates = 4096;

void step_turn(float& cosine, float& sine) {
    const float length = std::hypot(cosine, sine), step = 2.0f * shared::kPi / kTurns;
    const float angle = step * std::round(std::atan2(sine, cosine) / step);
    cosine = length * std::cos(angle);
    sine = length * std::sin(angle);
}

// The gate alone, with intensity 1: dimmer and colour are alike with and without frost, and may be 0.
shared::Light gate_of(shared::Light light) {
    light.position_m = light.axis_u = light.axis_v = light.axis_w = light.off_map_m = vec3(0);
    light.intensity_cd = vec3(1);
    light.bounce_cd = vec3(0);
    light.pass = light.map = 0;
    for (shared::Wheel& wheel : light.wheel) step_turn(wheel.cosine, wheel.sine);
    step_turn(light.disc.cosine, light.disc.sine);
    return light;
}

} // namespace

vec3 flux_through(const shared::Light& light, const shared::Gobos& gobos, float at_m, int points) {
    const float reach = light.cut_radius, tan2 = light.tan_field * light.tan_field;
    shared::Focus focus = shared::beam_focus(light, std::max(at_m, light.lens_m));
    const float area = shared::kPi * reach * reach / static_cast<float>(points);
    focus.least = kBlurPerPoint * std::sqrt(area);
    vec3 sum(0);
    for (int k = 0; k < points; ++k) { // as the seeds of a sunflower, evenly over the disc
        const float radius = reach * std::sqrt((static_cast<float>(k) + 0.5f) / static_cast<float>(points)),
                    angle = kGoldenAngle * static_cast<float>(k);
        const float shape = 1.0f / std::pow(1.0f + radius * radius * tan2, 1.5f);
        sum +=
            shape * shared::beam_gate(light, radius * vec2(std::cos(angle), std::sin(angle)), focus, gobos);
    }
    return light.intensity_cd * sum * (area * tan2);
}

vec3 FrostFlux::correction(const std::function<shared::Light()>& clear, const shared::Light& frosted,
                           const shared::Gobos& gobos, float at_m) {
    const shared::Light gate = gate_of(frosted);
    std::string key(reinterpret_cast<const char*>(&gate), sizeof gate);
    key.append(reinterpret_cast<const char*>(&at_m), sizeof at_m);
    const auto [entry, is_new] = found_.try_emplace(std::move(key), vec3(1));
    if (!is_new) return entry->second;
    const vec3 before = flux_through(gate_of(clear()), gobos, at_m, kClearPoints),
               after = flux_through(gate, gobos, at_m, kFrostedPoints);
    for (int k = 0; k < 3; ++k)
        if (after[k] > kLeastFlux_lm) entry->second[k] = std::min(before[k] / after[k], kMostCorrection);
    return entry->second;
}

void FrostFlux::trim() {
    if (found_.size() > kMostGates) found_.clear();
}

} // namespace ghost::scene
