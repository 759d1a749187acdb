// SPDX-License-Identifier: Apache-2.0
// Physical values of a fixture -> shared::Light. Order of the optics: source and its correction
// (beam_colour.h), dimmer and shutter, flags, colour wheels, gobo wheels, iris, zoom, focus.
#include "scene/beam_colour.h"
#include "scene/lit.h"
#include "scene/photometry.h"
#include "shared/beam.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr std::uint32_t kOpenSamples = 4; // Screen Space Re-Rendering, section 2.2
constexpr std::uint32_t kGoboSamples = 10;
constexpr float kMinLens_m = 0.01f;
constexpr float kSlotCentred = 0.004f; // of a slot; nearer than a wheel can stand

struct SlotPair {
    const fixture::Slot* a = nullptr;
    const fixture::Slot* b = nullptr;
    float shift = 0; // 0 = a centred .. 1 = b centred
};

SlotPair slots_at(const fixture::Type& type, const fixture::WheelState& state) {
    SlotPair pair;
    if (state.wheel < 0) return pair;
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

// Share of the light that a gobo lets through: its most blurred level, averaged.
vec3 gobo_mean(const shared::Gobos& gobos, std::uint32_t layer) {
    if (layer == 0) return vec3(1.0f);
    constexpr int kLevel = shared::kGoboLevels - 1;
    constexpr int kSide = shared::kGoboSize >> kLevel;
    vec3 sum(0.0f);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) sum += shared::gobo_texel(gobos, kLevel, layer, x, y);
    return sum / static_cast<float>(kSide * kSide);
}

} // namespace

vec3 apex_of(const fixture::BeamState& beam, const glm::mat4& to_world, const vec3& place_m) {
    const glm::mat4 placed = to_world * beam.to_fixture;
    const vec3 lens_m(placed[3]);
    const vec3 axis = -glm::normalize(vec3(placed[2]));
    const vec3 apex_m = lens_m - axis * std::max(glm::dot(lens_m - place_m, axis), kMinLens_m);
    return glm::distance(apex_m, place_m) < kOnPlace_m ? place_m : apex_m;
}

shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const vec3& position_m, const GoboStack& gobos) {
    ProfileTable profiles;
    return light_from(type, beam, to_world, position_m, gobos, profiles);
}

shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const vec3& position_m, const GoboStack& gobos, ProfileTable& profiles) {
    const fixture::Optics& optics = beam.optics;
    const fixture::Beam& source = *type.geometries[static_cast<std::size_t>(beam.geometry)].beam;
    const bool hard_edge =
        source.beam_type == fixture::BeamType::spot || source.beam_type == fixture::BeamType::rectangle;

    const float field_deg = optics.zoom_deg;
    const float beam_deg = field_deg * source.beam_angle_deg / std::max(source.field_angle_deg, 0.01f);
    const float iris = hard_edge ? std::clamp(optics.iris, 0.02f, 1.0f) : 1.0f;
    const MeasuredProfile& measured = profiles.find(beam_deg, field_deg, hard_edge, iris);
    const Profile& profile = measured.profile;

    const glm::mat3 axes(to_world * beam.to_fixture);
    shared::Light light{};
    light.position_m = position_m;
    light.axis_u = glm::normalize(axes[0]);
    light.axis_v = glm::normalize(axes[1]);
    light.axis_w = -glm::normalize(axes[2]);
    const vec3 lens_m = vec3(to_world * beam.to_fixture * glm::vec4(0, 0, 0, 1));
    light.lens_m = std::max(glm::dot(lens_m - position_m, light.axis_w), kMinLens_m);
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.edge = profile.edge;
    light.iris_radius = profile.aperture * iris;
    light.lens_radius_m = hard_edge ? source.beam_radius_m : 0.0f;
    light.disc_radius_m = source.beam_radius_m;
    light.focus_per_m = 1.0f / std::max(optics.focus_m + light.lens_m, 0.1f);

    vec3 colour = source_colour(type, source, optics) * flags_colour(type, source, optics);
    light.colour_b = vec3(1.0f);
    light.split = shared::kNoSplit;
    for (const fixture::WheelState& wheel : optics.color_wheels) {
        const SlotPair pair = slots_at(type, wheel);
        if (!pair.a) continue;
        const vec3 a = glm::max(slot_colour(type, source, *pair.a), vec3(1e-4f));
        colour *= a;
        if (pair.shift == 0.0f) continue;
        // One wheel at a time stands between two slots in practice; the last one wins.
        light.colour_b = slot_colour(type, source, *pair.b) / a;
        light.split = shared::kSlotSpacing * (0.5f - pair.shift);
    }
    const float peak_cd = measured.open_sr > 0 ? source.luminous_flux_lm / measured.open_sr : 0.0f;
    light.intensity_cd = colour * (peak_cd * optics.lamp * optics.dimmer * optics.shutter);

    for (const fixture::WheelState& wheel : optics.gobo_wheels) {
        if (light.wheel_count >= 2) break;
        const SlotPair pair = slots_at(type, wheel);
        if (!pair.a) continue;
        shared::Wheel gate{};
        gate.layer_a = gobos.layer(&type, pair.a->media);
        gate.layer_b = pair.shift > 0 ? gobos.layer(&type, pair.b->media) : gate.layer_a;
        gate.shift = pair.shift;
        if (gate.layer_a == 0 && gate.layer_b == 0 && gate.shift == 0.0f) continue;
        const float turn = wheel.gobo_deg * shared::kPi / 180.0f;
        gate.cosine = std::cos(turn);
        gate.sine = std::sin(turn);
        light.wheel[light.wheel_count++] = gate;
    }
    light.bounce_cd = light.intensity_cd * (measured.iris_sr / (4.0f * shared::kPi));
    for (std::uint32_t k = 0; k < light.wheel_count; ++k)
        light.bounce_cd *= gobo_mean(gobos.images, light.wheel[k].layer_a);
    light.haze_samples = light.wheel_count > 0 ? kGoboSamples : kOpenSamples;
    return light;
}

} // namespace ghost::scene
