// SPDX-License-Identifier: Apache-2.0
#include "light/private/gate.h"

#include "shared/beam.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kSlotCentred = 0.004f; // of a slot; nearer than a wheel can stand
constexpr float kNoBlade = 8.0f;       // gate radii
constexpr float kOut = 1e-3f;          // of a blade or a disc on its way
// A disc whose file does not say how it passes the gate: the way of the gate over the picture's -1..1.
constexpr float kDiscCentre = 0.62f;
constexpr float kDiscScale = 0.34f;
constexpr int kFractionSteps = 12;

// Fraction of the light that a gobo lets through: its most blurred level, averaged.
vec3 gobo_mean(const shared::Gobos& gobos, std::uint32_t layer) {
    if (layer == 0) return vec3(1.0f);
    constexpr int kLevel = shared::kGoboLevels - 1;
    constexpr int kSide = shared::kGoboSize >> kLevel;
    vec3 sum(0.0f);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) sum += shared::gobo_texel(gobos, kLevel, layer, x, y);
    return sum / static_cast<float>(kSide * kSide);
}

float turn_rad(float deg) {
    return deg * shared::kPi / 180.0f;
}

vec2 turned(const vec2& at, float rad) {
    const float c = std::cos(rad), s = std::sin(rad);
    return {c * at.x - s * at.y, s * at.x + c * at.y};
}

void add_wheel(const fixture::Type& type, const fixture::WheelState& state, const GoboStack& gobos,
               shared::Light& light) {
    const SlotPair pair = slots_at(type, state);
    if (!pair.a || light.wheel_count >= std::size(light.wheel)) return;
    shared::Wheel wheel{};
    wheel.layer_a = gobos.layer(&type, pair.a->media);
    wheel.layer_b = pair.shift > 0 ? gobos.layer(&type, pair.b->media) : wheel.layer_a;
    wheel.shift = pair.shift;
    if (wheel.layer_a == 0 && wheel.layer_b == 0 && wheel.shift == 0.0f) return;
    wheel.cosine = std::cos(turn_rad(state.gobo_deg));
    wheel.sine = std::sin(turn_rad(state.gobo_deg));
    wheel.depth =
        kGoboDepth[std::min(static_cast<std::size_t>(std::max(state.number - 1, 0)), kGoboDepth.size() - 1)];
    light.wheel[light.wheel_count++] = wheel;
}

// The slot that is in, or the first one with a picture.
std::uint32_t disc_picture(const fixture::Type& type, const fixture::Insert& disc, const GoboStack& gobos,
                           const fixture::Slot** chosen) {
    if (disc.wheel < 0) return 0;
    const std::vector<fixture::Slot>& slots = type.wheels[static_cast<std::size_t>(disc.wheel)].slots;
    const auto at = static_cast<std::size_t>(std::max(disc.slot, 0));
    if (disc.slot >= 0 && at < slots.size()) *chosen = &slots[at];
    if (*chosen && gobos.layer(&type, (*chosen)->media) != 0) return gobos.layer(&type, (*chosen)->media);
    for (const fixture::Slot& slot : slots)
        if (const std::uint32_t layer = gobos.layer(&type, slot.media); layer != 0) {
            *chosen = &slot;
            return layer;
        }
    return 0;
}

bool add_disc(const fixture::Type& type, const fixture::Optics& optics, const GoboStack& gobos,
              shared::Light& light) {
    for (const fixture::Insert& insert : optics.animations) {
        if (!(insert.in > kOut)) continue;
        const fixture::Slot* slot = nullptr;
        shared::Disc disc{};
        disc.layer = disc_picture(type, insert, gobos, &slot);
        if (disc.layer == 0) continue;
        disc.cosine = std::cos(turn_rad(insert.deg));
        disc.sine = std::sin(turn_rad(insert.deg));
        disc.depth = kDiscDepth;
        const float in = std::clamp(insert.in, 0.0f, 1.0f);
        disc.centre = vec2(kDiscCentre + (1.0f - in) * (1.0f + kDiscScale - kDiscCentre), 0.0f);
        disc.scale = kDiscScale;
        if (slot->animation && slot->animation->radius > 0.01f) {
            // Shares of the picture's width, from its middle.
            disc.centre = glm::clamp(2.0f * glm::mix(slot->animation->p1, slot->animation->p3, in),
                                     vec2(-4.0f), vec2(4.0f));
            disc.scale = std::min(2.0f * slot->animation->radius, 2.0f);
        }
        light.disc = disc;
        return true;
    }
    return false;
}

bool add_blades(const fixture::Optics& optics, shared::Light& light) {
    bool any = false;
    for (int k = 0; k < 4; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const fixture::Blade blade = at < optics.blades.size() ? optics.blades[at] : fixture::Blade{};
        light.blade[k] = blade_plane(blade, k, optics.shaper_deg);
        any = any || light.blade[k].offset < kNoBlade;
    }
    return any;
}

// All that is in the gate stands in one plane: the beam as a whole is focused there.
void focus_on(float depth, shared::Light& light) {
    if (light.lens_radius_m > 0.0f) light.focus_per_m -= depth * light.tan_field / light.lens_radius_m;
    light.iris_depth = 0.0f;
    for (shared::Wheel& wheel : light.wheel) wheel.depth = 0.0f;
}

} // namespace

SlotPair slots_at(const fixture::Type& type, const fixture::WheelState& state) {
    SlotPair pair;
    if (state.wheel < 0 || !state.in) return pair;
    const std::vector<fixture::Slot>& slots = type.wheels[static_cast<std::size_t>(state.wheel)].slots;
    if (slots.empty()) return pair;
    const float position = std::max(state.position, 0.0f);
    const auto first = static_cast<std::size_t>(position) % slots.size();
    pair.a = &slots[first];
    pair.b = &slots[(first + 1) % slots.size()];
    pair.shift = position - std::floor(position);
    if (pair.shift < kSlotCentred) pair.shift = 0;
    if (pair.shift > 1.0f - kSlotCentred) {
        pair.a = pair.b;
        pair.shift = 0;
    }
    return pair;
}

shared::Blade blade_plane(const fixture::Blade& blade, int which, float all_deg) {
    const float a = std::clamp(blade.a, 0.0f, 1.0f), b = std::clamp(blade.b, 0.0f, 1.0f);
    shared::Blade plane{};
    plane.normal = {0.0f, 1.0f};
    plane.offset = kNoBlade;
    plane.depth = kBladeDepth[static_cast<std::size_t>(which)];
    if (a < kOut && b < kOut) return plane;
    // As the top one: through its corners (-1, 1 - 2a) and (1, 1 - 2b).
    const float length = std::sqrt(1.0f + (b - a) * (b - a));
    const vec2 normal = vec2(b - a, 1.0f) / length;
    const float offset = (1.0f - a - b) / length;
    // A blade that turns moves in along its own way: one that touches the rim goes on touching it.
    const float turn = turn_rad(blade.deg);
    plane.normal = turned(normal, turn + turn_rad(all_deg - 90.0f * static_cast<float>(which)));
    plane.offset = 1.0f + (offset - 1.0f) * std::cos(turn);
    return plane;
}

float frost_pull(float sigma, float width) {
    return width * width / std::max(width * width + sigma * sigma, 1e-12f);
}

void set_gate(const fixture::Type& type, const fixture::Optics& optics, const GoboStack& gobos, float pull,
              shared::Light& light) {
    light.wheel_count = 0;
    for (const fixture::WheelState& wheel : optics.gobo_wheels) add_wheel(type, wheel, gobos, light);
    const bool has_disc = add_disc(type, optics, gobos, light);
    const bool has_blades = add_blades(optics, light);
    // The rim of an open gate is that of the gobo.
    light.iris_depth = optics.iris < kOpenIris ? kIrisDepth
                       : light.wheel_count > 0 ? light.wheel[0].depth
                                               : kGoboDepth[0];
    const bool has_slide = light.slide.layer != 0; // in the plane of depth 0
    bool one_plane = !has_disc && !has_blades && !(has_slide && light.iris_depth != 0.0f);
    for (std::uint32_t k = 0; k < light.wheel_count; ++k)
        one_plane = one_plane && light.wheel[k].depth == light.iris_depth;
    const bool no_lens = !(light.lens_radius_m > 0.0f);
    if (one_plane || no_lens) focus_on(light.iris_depth, light);
    if (no_lens) {
        light.disc.depth = 0.0f;
        for (shared::Blade& blade : light.blade) blade.depth = 0.0f;
    }
    // The pictures are as much larger.
    for (shared::Wheel& wheel : light.wheel) {
        wheel.cosine *= pull;
        wheel.sine *= pull;
    }
    light.disc.scale *= pull;
    for (shared::Blade& blade : light.blade)
        if (blade.offset < kNoBlade) blade.offset /= pull;
    if (light.split < shared::kNoSplit) light.split = std::min(light.split / pull, 0.5f * shared::kNoSplit);
    const bool slide_among = has_slide && (light.wheel_count > 0 || !(one_plane || no_lens));
    const bool between = std::any_of(light.wheel, light.wheel + light.wheel_count,
                                     [](const shared::Wheel& wheel) { return wheel.shift != 0.0f; });
    // Shaders of this class know two slots at once.
    light.shaped = has_disc || has_blades || slide_among || between   ? 2
                   : light.wheel_count > 2 || !(one_plane || no_lens) ? 1
                                                                      : 0;
    if (light.shaped != 0) return;
    light.disc = {};
    for (shared::Blade& blade : light.blade) blade = {};
}

vec3 gate_transmittance(const shared::Light& light, const shared::Gobos& gobos) {
    vec3 fraction(1.0f);
    for (std::uint32_t k = 0; k < light.wheel_count; ++k)
        fraction *= gobo_mean(gobos, light.wheel[k].layer_a);
    if (light.shaped == 0) return fraction;
    if (light.disc.layer != 0) fraction *= gobo_mean(gobos, light.disc.layer);
    const shared::Focus focus = shared::even_focus(light, light.edge);
    float passed = 0.0f, all = 0.0f;
    for (int y = 0; y < kFractionSteps; ++y)
        for (int x = 0; x < kFractionSteps; ++x) {
            const vec2 at = 2.0f * (vec2(x, y) + 0.5f) / static_cast<float>(kFractionSteps) - 1.0f;
            if (glm::length(at) > 1.0f) continue;
            passed += shared::blades_transmittance(light, at, focus);
            all += 1.0f;
        }
    return fraction * (passed / all);
}

} // namespace ghost::scene
