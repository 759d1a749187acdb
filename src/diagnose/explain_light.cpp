// SPDX-License-Identifier: Apache-2.0
// A light in numbers: how many lumens leave, and which part of its gate they leave by. Both are found from
// beam_gate, so that they hold for whatever is drawn.
#include "diagnose/explain_parts.h"

#include "photometry/photometry.h"
#include "shared/beam.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene::explained {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int kRings = 48; // of the gate, closer in the middle, where a closed iris leaves light
constexpr int kSpokes = 64;
constexpr int kPictureSteps = 64;  // across a projected picture
constexpr int kOutlineSteps = 128; // across the gate
constexpr float kLit = 0.1f;       // of the brightest place: where a field ends

constexpr std::uint32_t kNoPicture = ~0u; // a slide without texels

float in_focus_m(const shared::Light& light) {
    return light.lens_m + 1.0f / std::max(light.focus_per_m, 1e-4f);
}

// Solid angle of a unit of the gate's area.
double solid_angle_at(const shared::Light& light, double radius) {
    const double tan_field = static_cast<double>(light.tan_field);
    return tan_field * tan_field / std::pow(1.0 + radius * radius * tan_field * tan_field, 1.5);
}

// Lumens by rings and spokes: coarse at the rim, so for what wheels take away only.
double sum_of_rings(const shared::Light& light, const GoboStack& gobos) {
    const shared::Focus focus = shared::beam_focus(light, in_focus_m(light));
    double sum = 0.0;
    double inner = 0.0;
    for (int ring = 0; ring < kRings; ++ring) {
        const auto edge = [&](double at) {
            return static_cast<double>(light.cut_radius) * (at / kRings) * (at / kRings);
        };
        const double outer = edge(ring + 1.0);
        const double radius = edge(ring + 0.5);
        const double area = (outer * outer - inner * inner) * static_cast<double>(shared::kPi) / kSpokes;
        vec3 passed(0.0f);
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const float angle = 2.0f * shared::kPi * (static_cast<float>(spoke) + 0.5f) / kSpokes;
            const vec2 at = static_cast<float>(radius) * vec2(std::cos(angle), std::sin(angle));
            passed += shared::beam_gate(light, at, focus, gobos.images);
        }
        sum += static_cast<double>(glm::dot(passed * light.intensity_cd, kLuminance)) * area *
               solid_angle_at(light, radius);
        inner = outer;
    }
    return sum;
}

// Lumens by squares, over what lies in each.
double sum_of_squares(const shared::Light& light, const GoboStack& gobos) {
    const float side = 2.0f * light.cut_radius / kPictureSteps;
    shared::Focus focus = shared::beam_focus(light, in_focus_m(light));
    focus.least = 0.5f * side;
    double sum = 0.0;
    for (int y = 0; y < kPictureSteps; ++y)
        for (int x = 0; x < kPictureSteps; ++x) {
            const vec2 at = side * (vec2(x, y) + 0.5f) - light.cut_radius;
            const vec3 passed = shared::beam_gate(light, at, focus, gobos.images);
            sum += static_cast<double>(glm::dot(passed * light.intensity_cd, kLuminance)) *
                   solid_angle_at(light, static_cast<double>(glm::length(at)));
        }
    return sum * static_cast<double>(side) * static_cast<double>(side);
}

// Full angle between two places of the gate on one line through `across`.
// As a data sheet has it: of the picture on a wall, seen from the lens.
float angle_deg(float from, float to, const shared::Light& light) {
    const float tan_field = light.tan_field * (1.0f + light.lens_m / kMeasured_m);
    return glm::degrees(std::atan(to * tan_field) - std::atan(from * tan_field));
}

} // namespace

float output_lm(const shared::Light& light, const GoboStack& gobos) {
    double lumens = 0.0;
    if (light.figure.kind != shared::kNoFigure) {
        // A swept curve keeps those of its beam.
        lumens = 4.0 * static_cast<double>(shared::kPi * glm::dot(light.bounce_cd, kLuminance));
    } else if (light.slide.layer != 0) {
        lumens = sum_of_squares(light, gobos);
    } else {
        const Profile profile{.tan_field = light.tan_field,
                              .power = light.profile_power,
                              .scale = light.profile_scale,
                              .edge = light.edge,
                              .cut_radius = light.cut_radius};
        lumens = static_cast<double>(glm::dot(light.intensity_cd, kLuminance) *
                                     beam_solid_angle(profile, light.iris_radius));
    }
    if (light.slide.layer == 0 &&
        (light.wheel_count > 0 || light.shaped != 0 || light.split < shared::kNoSplit)) {
        shared::Light plain = light;
        plain.wheel_count = plain.shaped = 0;
        plain.split = shared::kNoSplit;
        plain.colour_b = vec3(1.0f);
        const double all = sum_of_rings(plain, gobos);
        lumens *= all > 0.0 ? sum_of_rings(light, gobos) / all : 0.0;
    }
    return std::isfinite(lumens) ? static_cast<float>(std::max(lumens, 0.0)) : 0.0f;
}

void show_white(shared::Light& light) {
    if (light.slide.layer == 0) return;
    light.slide.layer = kNoPicture;
    light.slide.black = 1.0f;
}

shared::Light outline_of(const shared::Light& light) {
    shared::Light outline = light;
    outline.wheel_count = 0;
    outline.disc.layer = 0;
    outline.split = shared::kNoSplit;
    outline.colour_b = vec3(1.0f);
    show_white(outline);
    return outline;
}

LitGate lit_gate(const shared::Light& light, const GoboStack& gobos) {
    const shared::Light outline = outline_of(light);
    const auto degrees_across = [&](float radius) { return angle_deg(-radius, radius, outline); };
    LitGate lit;
    if (outline.figure.kind != shared::kNoFigure) {
        lit.half = vec2(1.0f);
        lit.beam_deg = lit.field_deg = degrees_across(1.0f);
        lit.lit_deg = vec2(lit.field_deg);
        return lit;
    }
    if (outline.slide.layer == 0) {
        // exp2(-scale r^(2 power)) is 50 % and 10 % there, unless the iris ends it before.
        const float exponent = 0.5f / outline.profile_power;
        const float r50 = std::min(std::pow(outline.profile_scale, -exponent), outline.iris_radius);
        const float r10 =
            std::min(std::pow(std::log2(10.0f) / outline.profile_scale, exponent), outline.iris_radius);
        lit.half = vec2(r10);
        lit.beam_deg = degrees_across(r50);
        lit.field_deg = degrees_across(r10);
        lit.lit_deg = vec2(lit.field_deg);
        if (outline.shaped < 2) return lit; // no blade is in
    }
    const shared::Focus focus = shared::beam_focus(outline, in_focus_m(outline));
    const float side = 2.0f * outline.cut_radius / kOutlineSteps;
    std::vector<float> passed;
    float most = 0.0f;
    for (int y = 0; y < kOutlineSteps; ++y)
        for (int x = 0; x < kOutlineSteps; ++x) {
            const vec2 at = side * (vec2(x, y) + 0.5f) - outline.cut_radius;
            passed.push_back(shared::beam_gate(outline, at, focus, gobos.images).x);
            most = std::max(most, passed.back());
        }
    vec2 low(outline.cut_radius), high(-outline.cut_radius), sum(0.0f);
    int count = 0;
    for (int y = 0; y < kOutlineSteps; ++y)
        for (int x = 0; x < kOutlineSteps; ++x) {
            if (!(passed[static_cast<std::size_t>(y * kOutlineSteps + x)] > kLit * most)) continue;
            const vec2 at = side * (vec2(x, y) + 0.5f) - outline.cut_radius;
            low = glm::min(low, at - 0.5f * side);
            high = glm::max(high, at + 0.5f * side);
            sum += at;
            ++count;
        }
    if (count == 0) {
        lit.half = lit.lit_deg = vec2(0.0f);
        return lit;
    }
    const vec2 all_deg(angle_deg(low.x, high.x, outline), angle_deg(low.y, high.y, outline));
    lit.half = 0.5f * (high - low);
    lit.is_cut = outline.slide.layer == 0 && glm::any(glm::lessThan(all_deg, 0.97f * lit.lit_deg));
    if (outline.slide.layer != 0) lit.beam_deg = lit.field_deg = all_deg.x;
    if (outline.slide.layer != 0 || lit.is_cut) lit.lit_deg = all_deg;
    // What blades leave is convex: its middle is lit.
    const bool is_middle_lit = shared::beam_gate(outline, vec2(0.0f), focus, gobos.images).x > kLit * most;
    if (!is_middle_lit) lit.middle = sum / static_cast<float>(count);
    return lit;
}

} // namespace ghost::scene::explained
