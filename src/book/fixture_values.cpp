// SPDX-License-Identifier: Apache-2.0
#include "book/fixture_values.h"

#include "image/colour.h"
#include "print/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ghost::scene {
namespace {

using fixture::Optics;
using fixture::Slot;
using fixture::Type;
using glm::vec3;

constexpr float kLeast = 0.01f; // of a flag, a prism, an emitter: nobody sees less
constexpr float kOpenTransmission = 99.0f;

float most_of(const vec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

void add_part(std::string& list, const std::string& part) {
    list += (list.empty() ? "" : " + ") + part;
}

std::string slot_text(const fixture::Wheel& wheel, std::size_t slot, const PrintStyle& style) {
    if (is_open(wheel.slots[slot])) return style("open");
    const std::string& name = wheel.slots[slot].name;
    return style("slot %1", {std::to_string(slot + 1)}) + (name.empty() ? "" : " '" + name + "'");
}

// "": open.
std::string wheel_text(const Type& type, const fixture::WheelState& state, const PrintStyle& style) {
    if (state.wheel < 0 || !state.in) return "";
    const fixture::Wheel& wheel = type.wheels[static_cast<std::size_t>(state.wheel)];
    if (wheel.slots.empty()) return "";
    if (state.spinning) return style("wheel turning");
    const auto first = static_cast<std::size_t>(state.position) % wheel.slots.size();
    const float rest = state.position - std::floor(state.position);
    const std::size_t next = (first + 1) % wheel.slots.size();
    std::string text;
    if (rest < 0.05f)
        text = slot_text(wheel, first, style);
    else if (rest > 0.95f)
        text = slot_text(wheel, next, style);
    else
        text = style("half %1, half %2", {slot_text(wheel, first, style), slot_text(wheel, next, style)});
    if (state.shake_hz > 0 || state.turn_shake_hz > 0) text += " " + style("shaking");
    if (text != style("open") && state.rotating) text += " " + style("turning");
    return text == style("open") ? "" : text;
}

std::string wheels_text(const Type& type, const std::vector<fixture::WheelState>& wheels,
                        const PrintStyle& style) {
    std::string text;
    for (const fixture::WheelState& wheel : wheels)
        if (const std::string one = wheel_text(type, wheel, style); !one.empty()) add_part(text, one);
    return text;
}

std::string inserts_text(Word word, const std::vector<fixture::Insert>& inserts, const PrintStyle& style) {
    std::string text;
    for (const fixture::Insert& insert : inserts)
        if (insert.in >= 0.5f)
            add_part(text, style(word) + " " + std::to_string(insert.number) +
                               (insert.rotating ? " " + style("turning") : ""));
    return text;
}

// sRGB as a web page writes it, as bright as that colour can be.
std::string hex(const vec3& rec2020) {
    vec3 rgb = glm::max(image::rec2020_to_rec709(rec2020), vec3(0.0f));
    rgb /= std::max(most_of(rgb), 1e-6f);
    char text[8];
    const auto byte = [](float linear) { return std::lround(255.0f * image::linear_to_srgb(linear)); };
    std::snprintf(text, sizeof text, "#%02lx%02lx%02lx", static_cast<unsigned long>(byte(rgb.x)),
                  static_cast<unsigned long>(byte(rgb.y)), static_cast<unsigned long>(byte(rgb.z)));
    return text;
}

vec3 mixed(const Optics& optics) {
    return image::xyy_to_rec2020({optics.mix.x, optics.mix.y, optics.mix.Y / 100.0f});
}

// Of emitters and mixed colours: how bright, as a share of full, whatever the colour is.
float source_level(const Optics& optics) {
    float level = 1;
    if (optics.has_mix) {
        level = most_of(image::rec2020_to_rec709(mixed(optics)));
    } else if (!optics.emitters.empty()) {
        level = 0;
        for (const fixture::EmitterLevel& emitter : optics.emitters) level = std::max(level, emitter.level);
    }
    return std::clamp(level * optics.brightness, 0.0f, 1.0f);
}

std::string emitters_text(const Type& type, const Optics& optics, float level) {
    std::string text;
    for (const fixture::EmitterLevel& emitter : optics.emitters) {
        if (emitter.level < kLeast) continue;
        std::string name(emitter.letter ? 1 : 0, emitter.letter);
        if (name.empty() && emitter.emitter >= 0)
            name = type.emitters[static_cast<std::size_t>(emitter.emitter)].name;
        text += (text.empty() ? "" : " ") + name + " " + number_text(100.0f * emitter.level / level, 0);
    }
    return text.empty() ? "" : text + " %";
}

std::string flags_text(const Optics& optics) {
    std::string text;
    const auto flag = [&text](char letter, float in) {
        if (in < kLeast) return;
        text += (text.empty() ? "" : " ") + std::string(1, letter) + " " + number_text(100.0f * in, 0);
    };
    flag('C', optics.cyan);
    flag('M', optics.magenta);
    flag('Y', optics.yellow);
    for (const fixture::ColorFlag& other : optics.color_flags) flag(other.letter, other.in);
    return text.empty() ? "" : text + " %";
}

std::string colour_of(const Type& type, const Optics& optics, const PrintStyle& style) {
    std::string text;
    const float level = source_level(optics);
    if (optics.has_mix)
        text = hex(mixed(optics));
    else if (level >= kLeast)
        text = emitters_text(type, optics, level);
    if (const std::string flags = flags_text(optics); !flags.empty()) add_part(text, flags);
    if (const std::string wheels = wheels_text(type, optics.color_wheels, style); !wheels.empty())
        add_part(text, wheels);
    if (optics.cct_k > 0) add_part(text, number_text(optics.cct_k, 0) + " K");
    return text.empty() ? style("open") : text;
}

struct BeamValues {
    float light = 0; // 0..1
    std::string colour, gobo, effects;

    bool operator==(const BeamValues&) const = default;
};

BeamValues beam_values(const Type& type, const Optics& optics, const PrintStyle& style) {
    BeamValues values;
    values.light = optics.dimmer * optics.lamp * optics.shutter_position * source_level(optics);
    values.colour = colour_of(type, optics, style);
    values.gobo = wheels_text(type, optics.gobo_wheels, style);
    if (values.gobo.empty()) values.gobo = style("open");
    values.effects = inserts_text("prism", optics.prisms, style);
    if (const std::string discs = inserts_text("animation", optics.animations, style); !discs.empty())
        add_part(values.effects, discs);
    if (values.effects.empty()) values.effects = style("open");
    return values;
}

// How far the pictures in the light are turned, and how fast they turn, all together: two that differ in it
// look different.
void add_turns(const Type& type, const Optics& optics, FixtureValues& values) {
    const auto put = [](float deg, bool turns, float deg_s, float& turn_deg, float& turn_deg_s) {
        turn_deg += turns ? 0 : deg;
        turn_deg_s += turns ? deg_s : 0;
    };
    for (const fixture::WheelState& wheel : optics.gobo_wheels)
        if (!wheel_text(type, wheel, {}).empty())
            put(wheel.gobo_deg, wheel.rotating, wheel.gobo_deg_s, values.gobo_deg, values.gobo_deg_s);
    for (const std::vector<fixture::Insert>* inserts : {&optics.prisms, &optics.animations})
        for (const fixture::Insert& insert : *inserts)
            if (insert.in >= 0.5f)
                put(insert.deg, insert.rotating, insert.deg_s, values.effects_deg, values.effects_deg_s);
}

void add_hands(const fixture::Programmer& programmer, const PrintStyle& style, FixtureValues& values) {
    const auto put = [&](const std::string& part) {
        values.colour = values.colour == style("open") ? part : values.colour + " + " + part;
    };
    if (programmer.gel) put(style("gel %1", {hex(*programmer.gel)}));
    if (programmer.lamp)
        put(style("lamp of %1 times the light", {style.number(static_cast<double>(*programmer.lamp), 2)}));
    if (programmer.lamp_k) put(style("lamp of %1 K", {number_text(*programmer.lamp_k, 0)}));
}

} // namespace

FixtureValues values_of(const Type& type, const fixture::State& state, const fixture::Programmer* programmer,
                        const PrintStyle& style) {
    FixtureValues values;
    values.colour = values.gobo = values.effects = style("open");
    values.pan_deg = state.pan_deg;
    values.tilt_deg = state.tilt_deg;
    if (state.beams.empty()) return values;
    std::vector<BeamValues> beams;
    for (const fixture::BeamState& beam : state.beams) beams.push_back(beam_values(type, beam.optics, style));
    float light = 0;
    for (const BeamValues& beam : beams) light += beam.light;
    values.light_percent = 100.0f * light / static_cast<float>(beams.size());
    const bool are_alike =
        std::all_of(beams.begin(), beams.end(), [&](const BeamValues& one) { return one == beams[0]; });
    const auto of_all = [&](std::string BeamValues::*text) {
        const bool same = std::all_of(beams.begin(), beams.end(),
                                      [&](const BeamValues& one) { return one.*text == beams[0].*text; });
        return same ? beams[0].*text : style("several");
    };
    values.colour = of_all(&BeamValues::colour);
    values.gobo = of_all(&BeamValues::gobo);
    values.effects = of_all(&BeamValues::effects);
    if (!are_alike)
        for (const BeamValues& beam : beams)
            values.cells += number_text(100.0f * beam.light, 0) + " " + beam.colour + "; ";
    const Optics& optics = state.beams[0].optics;
    values.zoom_deg = optics.zoom_deg;
    values.iris_percent = 100.0f * optics.iris;
    values.frost_percent = 100.0f * optics.frost;
    for (const fixture::Blade& blade : optics.blades)
        values.blades_percent = std::max(values.blades_percent, 100.0f * std::max(blade.a, blade.b));
    std::copy_n(optics.blades.begin(), std::min(optics.blades.size(), values.blades.size()),
                values.blades.begin());
    values.shaper_deg = optics.shaper_deg;
    values.focus_percent = 100.0f * optics.focus;
    values.tint_percent = 100.0f * optics.tint;
    values.figure = optics.figure;
    add_turns(type, optics, values);
    if (optics.strobe != fixture::Strobe::none) values.strobe_hz = optics.strobe_hz;
    if (programmer) add_hands(*programmer, style, values);
    return values;
}

bool is_open(const Slot& slot) {
    const fixture::ColorCie white;
    return slot.media < 0 && slot.media_file.empty() && slot.facets.empty() && slot.filter < 0 &&
           !slot.animation && slot.color.x == white.x && slot.color.y == white.y &&
           slot.color.Y >= kOpenTransmission;
}

std::string colour_text(const fixture::ColorCie& colour) {
    return hex(image::xyy_to_rec2020({colour.x, colour.y, 1.0f}));
}

float full_lm(const Type& type, const fixture::Mode& mode) {
    float lumens = 0;
    for (const int beam : mode.beams) {
        const fixture::Node& node = mode.nodes[static_cast<std::size_t>(beam)];
        const auto& source = type.geometries[static_cast<std::size_t>(node.geometry)].beam;
        if (source) lumens += source->luminous_flux_lm;
    }
    return lumens;
}

} // namespace ghost::scene
