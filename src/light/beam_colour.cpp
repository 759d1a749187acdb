// SPDX-License-Identifier: Apache-2.0
#include "light/private/beam_colour.h"

#include "fixture/curves.h"
#include "fixture/lamp.h"
#include "image/colour.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using fixture::Beam;
using fixture::ColorCie;
using fixture::Filter;
using fixture::kFullCtb_mired;
using fixture::kFullCto_mired;
using fixture::Optics;
using fixture::Type;
using glm::vec3;

// What the full flags let through: dichroics of a touring CMY system, not ideal block dyes.
const vec3 kCyanFull{0.03f, 0.72f, 0.90f};
const vec3 kMagentaFull{0.80f, 0.03f, 0.75f};
const vec3 kYellowFull{0.95f, 0.80f, 0.02f};
const vec3 kRedFull{0.90f, 0.03f, 0.01f};
const vec3 kGreenFull{0.03f, 0.75f, 0.02f};
const vec3 kBlueFull{0.01f, 0.04f, 0.85f};

// What gels of a full shift let through.
constexpr float kFullCto = 0.55f;
constexpr float kFullCtb = 0.34f;

constexpr float kFullTint_duv = 0.02f;
constexpr float kLeast = 1e-4f; // of a white: its components are divided by

float most_of(const vec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

vec3 chromaticity(const ColorCie& color) {
    return image::into_gamut(image::xyy_to_rec2020({color.x, color.y, 1.0f}));
}

bool is_unsaid(const ColorCie& color) {
    const ColorCie unsaid;
    return color.x == unsaid.x && color.y == unsaid.y;
}

// The emitter that the Beam names, where the file knows its colour.
const fixture::Emitter* emitter_of(const Type& type, const Beam& beam) {
    if (beam.emitter < 0) return nullptr;
    const fixture::Emitter& emitter = type.emitters[static_cast<std::size_t>(beam.emitter)];
    return emitter.spectral_color || !is_unsaid(emitter.color) ? &emitter : nullptr;
}

vec3 undimmed_white(const Type& type, const Beam& beam) {
    if (const fixture::Emitter* emitter = emitter_of(type, beam))
        return chromaticity(emitter->spectral_color.value_or(emitter->color));
    return image::cct_to_rec2020(beam.color_temperature_k);
}

vec3 lamp_white(const Type& type, const Beam& beam, float cct_fraction) {
    if (cct_fraction == 1.0f) return undimmed_white(type, beam);
    const vec3 dimmed = image::cct_to_rec2020(beam.color_temperature_k * cct_fraction);
    if (!emitter_of(type, beam)) return dimmed;
    const vec3 full = glm::max(image::cct_to_rec2020(beam.color_temperature_k), vec3(kLeast));
    const vec3 red = undimmed_white(type, beam) * glm::max(dimmed, vec3(0.0f)) / full;
    return red / image::rec2020_to_xyz(red).y;
}

// The filter that turns the white of the lamp into the white that is asked for.
vec3 correction(const Beam& beam, const Optics& optics) {
    if (optics.cct_k <= 0.0f && optics.tint == 0.0f) return vec3(1.0f);
    const vec3 lamp = glm::max(image::cct_to_rec2020(beam.color_temperature_k), vec3(kLeast));
    const float wanted_k = optics.cct_k > 0.0f ? optics.cct_k : beam.color_temperature_k;
    const vec3 wanted = image::into_gamut(
        image::cct_to_rec2020(wanted_k, kFullTint_duv * std::clamp(optics.tint, -1.0f, 1.0f)));
    const vec3 ratio = wanted / lamp;
    const bool mixes_white = optics.emitters.empty() && !optics.has_mix && !optics.cct_is_filter;
    if (mixes_white) return ratio;
    float passed = 1.0f / most_of(ratio); // no filter adds light
    if (optics.cct_is_filter) {
        const float shift_mired = 1e6f / wanted_k - 1e6f / beam.color_temperature_k;
        passed = std::min(passed, shift_mired > 0.0f ? std::pow(kFullCto, shift_mired / kFullCto_mired)
                                                     : std::pow(kFullCtb, -shift_mired / kFullCtb_mired));
    }
    return ratio * passed;
}

// How dense a filter is at an insertion, as a fraction of its full density: as measured, else the insertion.
float density(const Filter& filter, float in) {
    if (filter.measurements.size() < 2 || in <= 0.0f) return in;
    const float open = fixture::measured_at(filter, 0.0f).transmission;
    const float full = fixture::measured_at(filter, 100.0f).transmission / open;
    const float now = fixture::measured_at(filter, 100.0f * in).transmission / open;
    if (!(full > 0.0f && full < 0.999f && now > 0.0f)) return in;
    return std::clamp(std::log(now) / std::log(full), 0.0f, 1.0f);
}

// Half in the beam, half as dense (Beer's law), as graded dichroic flags are cut to be.
vec3 flag(const Type& type, const Beam& beam, int filter, const vec3& usual, float in) {
    const float inside = std::clamp(in, 0.0f, 1.0f);
    if (inside <= 0.0f) return vec3(1.0f);
    if (filter < 0) return glm::pow(usual, vec3(inside));
    const Filter& named = type.filters[static_cast<std::size_t>(filter)];
    const vec3 full = glm::max(filter_colour(type, beam, named.color), vec3(kLeast));
    return glm::pow(full, vec3(density(named, inside)));
}

} // namespace

vec3 filter_colour(const Type& type, const Beam& beam, const ColorCie& color) {
    vec3 passed = image::into_gamut(image::xyy_to_rec2020({color.x, color.y, color.Y / 100.0f}));
    // Colours beside a measured lamp are those of the beam behind the filter.
    if (emitter_of(type, beam) && !is_unsaid(color))
        passed /= glm::max(undimmed_white(type, beam), vec3(kLeast));
    return passed / std::max(most_of(passed), 1.0f); // no filter adds light
}

vec3 slot_colour(const Type& type, const Beam& beam, const fixture::Slot& slot) {
    return filter_colour(type, beam,
                         slot.filter >= 0 ? type.filters[static_cast<std::size_t>(slot.filter)].color
                                          : slot.color);
}

vec3 flags_colour(const Type& type, const Beam& beam, const Optics& optics) {
    vec3 passed = flag(type, beam, optics.flag_filters[0], kCyanFull, optics.cyan) *
                  flag(type, beam, optics.flag_filters[1], kMagentaFull, optics.magenta) *
                  flag(type, beam, optics.flag_filters[2], kYellowFull, optics.yellow);
    for (const fixture::ColorFlag& other : optics.color_flags)
        passed *=
            flag(type, beam, other.filter,
                 other.letter == 'R' ? kRedFull : (other.letter == 'G' ? kGreenFull : kBlueFull), other.in);
    return passed;
}

vec3 source_colour(const Type& type, const Beam& beam, const Optics& optics) {
    vec3 colour(0.0f);
    if (optics.has_mix) {
        colour = chromaticity(optics.mix) * (optics.mix.Y / 100.0f);
    } else if (optics.emitters.empty()) {
        colour = lamp_white(type, beam, optics.lamp_cct_fraction);
    } else {
        for (const fixture::EmitterLevel& emitter : optics.emitters)
            colour += image::xyy_to_rec2020({emitter.color.x, emitter.color.y, emitter.color.Y / 100.0f}) *
                      emitter.level;
        colour = image::into_gamut(colour);
    }
    return colour * correction(beam, optics) * optics.brightness;
}

} // namespace ghost::scene
