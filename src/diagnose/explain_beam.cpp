// SPDX-License-Identifier: Apache-2.0
// One beam measured: how much light leaves, and how much of it each part lets through, drawn by light_from,
// so that it holds whatever the optics do.
#include "diagnose/explain_parts.h"

#include "beam_groups/prism.h"
#include "photometry/photometry.h"
#include "shared/beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ghost::scene::explained {
namespace {

using fixture::BeamState;
using fixture::Optics;
using fixture::WheelState;

constexpr float kBetween = 0.004f; // of a slot: light_from takes less as centred
constexpr float kNothing = 1e-6f;

BeamState open_beam(const BeamState& state) {
    BeamState open;
    open.node = state.node;
    open.geometry = state.geometry;
    open.optics.dimmer = 1.0f;
    open.optics.zoom_deg = state.optics.zoom_deg;
    open.optics.focus_m = state.optics.focus_m;
    open.optics.emitters = state.optics.emitters;
    for (fixture::EmitterLevel& emitter : open.optics.emitters) emitter.level = 1.0f;
    return open;
}

// What the parts of a beam let through, one behind the other.
class Shares {
public:
    Shares(const fixture::Type& type, const BeamState& state, const GoboStack& gobos,
           const Projector* projector)
        : type_(type), gobos_(gobos), projector_(projector), open_(open_beam(state)), chain_(open_),
          full_lm_(lumens(open_, false)), passed_lm_(full_lm_) {}

    float full_lm() const { return full_lm_; }
    // Of an open beam, once change has set one part of its optics.
    template <class Change>
    float alone(Change change) const {
        BeamState one = open_;
        change(one.optics);
        return full_lm_ > 0.0f ? lumens(one, false) / full_lm_ : 1.0f;
    }
    // Of what the parts before it leave; where that is nothing, of an open beam.
    template <class Change>
    float next(bool is_in, Change change) {
        change(chain_.optics);
        return is_in ? behind([&] { return alone(change); }) : 1.0f;
    }
    // What is projected, of a white panel.
    float picture() {
        has_picture_ = true;
        return behind([&] { return full_lm_ > 0.0f ? lumens(open_, true) / full_lm_ : 1.0f; });
    }

private:
    template <class Alone>
    float behind(Alone alone) {
        const float reached_lm = passed_lm_;
        passed_lm_ = lumens(chain_, has_picture_);
        return reached_lm > kNothing * full_lm_ ? passed_lm_ / reached_lm : alone();
    }
    float lumens(const BeamState& state, bool with_picture) const {
        ProfileTable profiles;
        shared::Light light = light_from(type_, state, glm::mat4(1.0f), gobos_, profiles, projector_);
        if (!with_picture) show_white(light);
        return output_lm(light, gobos_);
    }

    const fixture::Type& type_;
    const GoboStack& gobos_;
    const Projector* projector_;
    BeamState open_, chain_;
    bool has_picture_ = false;
    float full_lm_, passed_lm_;
};

WheelFacts wheel_facts(const fixture::Type& type, const WheelState& state, bool colour) {
    const fixture::Wheel& wheel = item(type.wheels, state.wheel);
    WheelFacts facts;
    facts.colour = colour;
    facts.number = state.number;
    facts.name = wheel.name;
    facts.position = state.position;
    facts.spinning = state.spinning;
    if (wheel.slots.empty()) return facts;
    const float position = std::max(state.position, 0.0f);
    const auto first = static_cast<std::size_t>(position) % wheel.slots.size();
    const auto next = (first + 1) % wheel.slots.size();
    const float shift = position - std::floor(position);
    facts.slot = wheel.slots[shift > 1.0f - kBetween ? next : first].name;
    if (shift >= kBetween && shift <= 1.0f - kBetween) facts.next = wheel.slots[next].name;
    return facts;
}

// "'6F linear' of wheel 'Prism'", or nothing where the file names no slot.
std::string slot_text(const fixture::Type& type, const fixture::Insert& insert) {
    if (insert.wheel < 0) return "";
    const fixture::Wheel& wheel = item(type.wheels, insert.wheel);
    if (insert.slot < 0 || static_cast<std::size_t>(insert.slot) >= wheel.slots.size()) return "";
    return " '" + item(wheel.slots, insert.slot).name + "'";
}

// What shapes the beam besides wheels of colours and gobos, in the order of the light's way.
std::vector<std::string> optics_text(const fixture::Type& type, const Optics& now) {
    std::vector<std::string> texts;
    const auto way = [](float in) {
        return in < 0.999f ? ", " + percent(in) + " of the way in" : std::string();
    };
    const auto turn = [](const fixture::Insert& insert) {
        return insert.rotating ? ", turning at " + number(static_cast<double>(insert.deg_s), 1) + " deg/s"
                               : std::string();
    };
    for (const fixture::Insert& disc : now.animations)
        if (disc.in > 1e-3f)
            texts.push_back("animation wheel " + std::to_string(disc.number) + slot_text(type, disc) +
                            way(disc.in) + turn(disc));
    if (now.iris_hz > 0.0f)
        texts.push_back("the iris pulses at " + number(static_cast<double>(now.iris_hz), 1) + " Hz");
    constexpr std::array kSides{"top", "right", "bottom", "left"};
    std::vector<std::string> blades;
    for (std::size_t k = 0; k < std::min(now.blades.size(), kSides.size()); ++k) {
        const fixture::Blade& blade = now.blades[k];
        if (std::max(blade.a, blade.b) <= 1e-3f) continue;
        blades.push_back(
            std::string(kSides[k]) + " " + percent(blade.a) +
            (blade.a != blade.b ? " to " + percent(blade.b) : "") +
            (blade.deg != 0.0f ? " turned " + number(static_cast<double>(blade.deg), 1) + " deg" : ""));
    }
    if (!blades.empty()) texts.push_back("blades in: " + joined(blades));
    const std::vector<Copy> copies = copies_of(type, now, kMostCopies);
    for (const fixture::Insert& prism : now.prisms)
        if (prism.in > 1e-3f)
            texts.push_back("prism " + std::to_string(prism.number) + slot_text(type, prism) + way(prism.in) +
                            turn(prism) + ": " + std::to_string(copies.size()) + " pictures" +
                            (now.prisms.size() > 1 ? " of all prisms" : ""));
    if (now.frost > 1e-3f)
        texts.push_back("frost " + percent(now.frost) + ": scatters by " +
                        number(static_cast<double>(now.frost * now.frost_full_deg), 2) +
                        " deg (standard deviation)");
    return texts;
}

// The dimmer nearest to the beam, and what stands above it.
void split_dimmers(const fixture::Mode& mode, std::size_t beam, const std::vector<ChannelFacts>& channels,
                   float all, BeamFacts& facts) {
    int nearest = -1;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const fixture::Channel& channel = mode.channels[i];
        const bool here = std::find(channel.beams.begin(), channel.beams.end(), static_cast<int>(beam)) !=
                          channel.beams.end();
        if (!here || channels[i].role != fixture::Role::dimmer || channel.offsets.empty()) continue;
        if (nearest < 0 || channel.node > item(mode.channels, nearest).node) nearest = static_cast<int>(i);
    }
    facts.master = 1.0f;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::vector<int>& beams = mode.channels[i].beams;
        if (static_cast<int>(i) != nearest && channels[i].role == fixture::Role::dimmer &&
            channels[i].number > 0 &&
            std::find(beams.begin(), beams.end(), static_cast<int>(beam)) != beams.end())
            facts.master *= std::clamp(channels[i].reading.physical, 0.0f, 1.0f);
    }
    // A dimmer on its way gives what it gives now.
    if (!(facts.master > 0.0f)) facts.master = all > 0.0f ? 1.0f : 0.0f;
    const float own = nearest < 0 ? 1.0f : item(channels, nearest).reading.physical;
    facts.dimmer = facts.master > 0.0f ? all / facts.master : std::clamp(own, 0.0f, 1.0f);
}

} // namespace

float fraction_of(const fixture::Type& type, const BeamState& state, const GoboStack& gobos) {
    const auto lumens = [&](const BeamState& beam) {
        return output_lm(light_from(type, beam, glm::mat4(1.0f), gobos), gobos);
    };
    const float full_lm = lumens(open_beam(state));
    return full_lm > 0.0f ? lumens(state) / full_lm : 0.0f;
}

BeamFacts measure(const fixture::Patch& patch, std::size_t beam, const BeamState& state,
                  const shared::Light& light, const std::vector<ChannelFacts>& channels,
                  const GoboStack& gobos, const Projector* projector) {
    const fixture::Type& type = *patch.type;
    const fixture::Mode& mode = patch.mode_of();
    const Optics& now = state.optics;
    Shares fractions(type, state, gobos, projector);
    BeamFacts facts;
    facts.name = item(mode.nodes, state.node).name;
    facts.full_lm = fractions.full_lm();
    facts.output_lm = output_lm(light, gobos);
    facts.projects = light.slide.layer != 0;
    facts.lamp = now.lamp;
    split_dimmers(mode, beam, channels, now.dimmer, facts);
    facts.shutter = now.shutter_position;
    facts.strobe = now.strobe == fixture::Strobe::none || now.shutter_position <= 0.0f
                       ? 1.0f
                       : now.shutter / now.shutter_position;
    facts.strobe_hz = now.strobe == fixture::Strobe::none ? 0.0f : now.strobe_hz;
    facts.mix = fractions.next(now.has_mix || now.brightness != 1.0f, [&](Optics& optics) {
        optics.has_mix = now.has_mix;
        optics.mix = now.mix;
        optics.brightness = now.brightness;
    });
    // A mixed colour takes the place of the emitters.
    facts.emitters = fractions.next(!now.emitters.empty() && !now.has_mix,
                                    [&](Optics& optics) { optics.emitters = now.emitters; });
    facts.correction = fractions.next(now.cct_k > 0.0f || now.tint != 0.0f, [&](Optics& optics) {
        optics.cct_k = now.cct_k;
        optics.cct_is_filter = now.cct_is_filter;
        optics.tint = now.tint;
    });
    facts.colour = fractions.next(true, [&](Optics& optics) {
        optics.cyan = now.cyan;
        optics.magenta = now.magenta;
        optics.yellow = now.yellow;
        optics.color_wheels = now.color_wheels;
        optics.color_flags = now.color_flags;
        optics.flag_filters = now.flag_filters;
    });
    if (facts.projects) facts.picture = fractions.picture();
    facts.animation =
        fractions.next(!now.animations.empty(), [&](Optics& optics) { optics.animations = now.animations; });
    facts.gobo = fractions.next(!now.gobo_wheels.empty(),
                                [&](Optics& optics) { optics.gobo_wheels = now.gobo_wheels; });
    facts.iris = fractions.next(now.iris < 1.0f, [&](Optics& optics) { optics.iris = now.iris; });
    facts.blades = fractions.next(!now.blades.empty(), [&](Optics& optics) {
        optics.blades = now.blades;
        optics.shaper_deg = now.shaper_deg;
    });
    facts.optics = optics_text(type, now);
    for (const WheelState& wheel : now.color_wheels) {
        if (!wheel.in) continue;
        facts.wheels.push_back(wheel_facts(type, wheel, true));
        facts.wheels.back().fraction =
            fractions.alone([&](Optics& optics) { optics.color_wheels = {wheel}; });
    }
    for (const WheelState& wheel : now.gobo_wheels) {
        if (!wheel.in) continue;
        facts.wheels.push_back(wheel_facts(type, wheel, false));
        facts.wheels.back().fraction = fractions.alone([&](Optics& optics) { optics.gobo_wheels = {wheel}; });
    }
    const float known = now.lamp * now.dimmer * facts.shutter * facts.strobe * facts.mix * facts.emitters *
                        facts.correction * facts.colour * facts.picture * facts.animation * facts.gobo *
                        facts.iris * facts.blades * facts.full_lm;
    facts.rest = known > 1e-4f * facts.full_lm ? facts.output_lm / known : 1.0f;

    const LitGate lit = lit_gate(light, gobos);
    facts.field_deg = lit.field_deg;
    facts.beam_deg = lit.beam_deg;
    facts.lit_deg = lit.lit_deg;
    facts.is_cut = lit.is_cut;
    const float z = light.lens_m + 1.0f / std::max(light.focus_per_m, 1e-4f);
    const glm::vec3 middle(lit.middle * light.tan_field * z, z);
    const glm::vec3 middle_cd = shared::beam_candela(outline_of(light), middle, gobos.images);
    facts.axis_cd = facts.picture * facts.gobo * facts.animation * glm::dot(middle_cd, kLuminance) *
                    measured_fraction(light);
    facts.direction = light.axis_w;
    facts.lens_m = light.position_m + light.axis_w * light.lens_m;
    return facts;
}

} // namespace ghost::scene::explained
