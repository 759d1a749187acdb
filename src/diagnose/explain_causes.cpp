// SPDX-License-Identifier: Apache-2.0
// What in a fixture keeps a beam dark: one finding for each part of the chain that lets next to nothing
// through, with the channel that is to blame.
#include "diagnose/explain_parts.h"

#include "base/text.h"
#include "fixture/values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <optional>

namespace ghost::scene::explained {
namespace {

using fixture::Role;

constexpr float kThinnest_deg = 0.5f; // a beam of less is a laser's
constexpr float kOut = 1e-3f;         // of a blade

struct Beam {
    const fixture::Mode& mode;
    std::size_t beam;
    const std::vector<ChannelFacts>& channels;

    // Channels that change this beam and are what `wanted` asks for.
    std::vector<int> find(const std::function<bool(const ChannelFacts&)>& wanted) const {
        std::vector<int> found;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const std::vector<int>& beams = mode.channels[i].beams;
            if (std::find(beams.begin(), beams.end(), static_cast<int>(beam)) != beams.end() &&
                wanted(channels[i]))
                found.push_back(static_cast<int>(i));
        }
        return found;
    }
    std::vector<int> of_role(Role role) const {
        return find([&](const ChannelFacts& channel) { return channel.role == role; });
    }
    const ChannelFacts& at(int index) const { return channels[static_cast<std::size_t>(index)]; }
};

std::string function_text(const ChannelFacts& channel) {
    return "'" + (channel.set.empty() ? channel.function : channel.set) + "' (DMX " + channel.range + ")";
}

std::string places_text(const Beam& beam, const std::vector<int>& channels) {
    std::vector<std::string> places;
    for (const int channel : channels) places.push_back(place_text(beam.at(channel)));
    constexpr std::size_t kMost = 8;
    if (places.size() > kMost) {
        const std::size_t more = places.size() - kMost;
        places.resize(kMost);
        places.push_back(std::to_string(more) + " more");
    }
    return joined(places);
}

bool selects_colour(Role role) {
    return role == Role::color_wheel || role == Role::color_wheel_index || role == Role::color_wheel_spin ||
           role == Role::color_wheel_random;
}
bool selects_gobo(Role role) {
    return role == Role::gobo_wheel || role == Role::gobo_wheel_index || role == Role::gobo_wheel_spin ||
           role == Role::gobo_wheel_random || role == Role::gobo_wheel_shake ||
           role == Role::gobo_select_spin || role == Role::gobo_select_shake;
}

Reason blocking(Cause cause, std::string text, std::string group, std::vector<int> channels, float fraction) {
    return {cause, true, std::move(text), std::move(group), std::move(channels), fraction};
}

// Of two bytes: what stands in the fine one would be light in the coarse one.
bool may_be_swapped(const ChannelFacts& channel) {
    constexpr std::uint32_t kHigh = 128;
    return channel.places.size() == 2 && channel.reading.received && channel.reading.raw < 256 &&
           channel.reading.raw >= kHigh;
}

// Nothing: the filament is dark because its lamp is out, not because of the dimmer.
std::optional<Reason> dimmer_finding(const Beam& beam, const fixture::Optics& optics,
                                     const BeamFacts& facts) {
    const std::string group =
        "their dimmer is " + std::string(optics.dimmer <= 0.0f ? "at 0" : "nearly at 0");
    const auto is_low = [](const ChannelFacts& channel) {
        return channel.role == Role::dimmer && channel.reading.physical < kBlocks;
    };
    std::vector<int> low =
        beam.find([&](const ChannelFacts& channel) { return is_low(channel) && channel.number > 0; });
    if (!low.empty()) {
        const ChannelFacts& first = beam.at(low.front());
        std::string text = "the dimmer on " + place_text(first) + " " + value_text(first) + " of function " +
                           function_text(first) + ", that is " + first.meaning;
        if (may_be_swapped(first))
            text += "; its coarse byte is at 0 and its fine one at " + std::to_string(first.reading.raw) +
                    ": a fader at its foot, or a desk that sends the fine byte first (16-bit order)";
        if (low.size() > 1)
            text += "; so " + std::string(low.size() > 2 ? "are " : "is ") +
                    places_text(beam, {low.begin() + 1, low.end()});
        return blocking(Cause::dimmer, text, group, low, optics.dimmer);
    }
    float asked = 1.0f;
    const std::vector<int> dimmers = beam.find(
        [](const ChannelFacts& channel) { return channel.role == Role::dimmer && channel.number > 0; });
    if (dimmers.empty())
        return blocking(Cause::dimmer, "no channel of its file dims it: hands alone light it",
                        "hands alone light them: no channel of their file dims them", {}, optics.dimmer);
    for (const int dimmer : dimmers) asked *= std::clamp(beam.at(dimmer).reading.physical, 0.0f, 1.0f);
    const std::string places = places_text(beam, dimmers);
    if (asked >= kBlocks && facts.lamp < kBlocks) return std::nullopt;
    if (asked >= kBlocks)
        return blocking(Cause::dimmer,
                        "the dimmer (" + places + ") is still on its way: it gives " +
                            percent(optics.dimmer) + ", asked is " + percent(asked),
                        "their dimmer is still on its way", dimmers, optics.dimmer);
    return blocking(Cause::dimmer, "all dimmers together (" + places + ") give " + percent(optics.dimmer),
                    group, dimmers, optics.dimmer);
}

// A dimmer without an address: the desk multiplies it into other channels.
void add_virtual_dimmer(const Beam& beam, std::vector<Reason>& findings) {
    const std::vector<int> virtuals = beam.find(
        [](const ChannelFacts& channel) { return channel.role == Role::dimmer && channel.number == 0; });
    if (virtuals.empty()) return;
    std::vector<int> followers;
    for (const fixture::Relation& relation : beam.mode.relations)
        if (relation.master_channel == virtuals.front() && relation.follower_channel >= 0 &&
            std::find(followers.begin(), followers.end(), relation.follower_channel) == followers.end())
            followers.push_back(relation.follower_channel);
    findings.push_back({Cause::dimmer, false,
                        "its dimmer is " + place_text(beam.at(virtuals.front())) +
                            ": it has no DMX channel, the desk works it into " +
                            (followers.empty() ? "the other channels" : places_text(beam, followers)),
                        "their dimmer is virtual", virtuals});
}

Reason shutter_finding(const Beam& beam, const BeamFacts& facts) {
    const std::vector<int> closed = beam.find([](const ChannelFacts& channel) {
        return channel.role == Role::shutter && channel.reading.physical < kBlocks;
    });
    const std::string group = "their shutter is closed";
    if (closed.empty()) return blocking(Cause::shutter, "the shutter is closed", group, {}, facts.shutter);
    const ChannelFacts& first = beam.at(closed.front());
    return blocking(Cause::shutter,
                    "the shutter function " + function_text(first) + " is active on " + place_text(first) +
                        (first.reading.received ? ", value " : ", default ") + first.value,
                    group, closed, facts.shutter);
}

Reason strobe_finding(const Beam& beam, const BeamFacts& facts) {
    const std::vector<int> active = beam.find([](const ChannelFacts& channel) {
        return channel.role == Role::strobe || channel.role == Role::strobe_random ||
               channel.role == Role::strobe_pulse || channel.role == Role::strobe_effect;
    });
    std::string text = "its strobe is between two flashes at this moment";
    if (!active.empty()) {
        const ChannelFacts& first = beam.at(active.front());
        text += ": function " + function_text(first) + " on " + place_text(first) + ", value " + first.value +
                ", flashes " + number(static_cast<double>(facts.strobe_hz), 1) + " times a second";
    }
    return blocking(Cause::strobe, text, "their strobe is between two flashes", active, facts.strobe);
}

// Flags in words: "cyan 100 % on channel 6 (1.006)".
void add_colour_findings(const Beam& beam, const fixture::Optics& optics, const BeamFacts& facts,
                         std::vector<Reason>& findings) {
    if (facts.colour >= kBlocks) return;
    const std::string passes = percent(facts.colour) + " of the light";
    std::vector<std::string> parts;
    std::vector<int> channels;
    const auto add_flag = [&](Role role, const char* name, float in) {
        const std::vector<int> found = beam.of_role(role);
        if (in < 0.2f) return;
        parts.push_back(std::string(name) + " " + percent(in) +
                        (found.empty() ? "" : " on " + place_text(beam.at(found.front()))));
        channels.insert(channels.end(), found.begin(), found.end());
    };
    add_flag(Role::color_sub_c, "cyan", optics.cyan);
    add_flag(Role::color_sub_m, "magenta", optics.magenta);
    add_flag(Role::color_sub_y, "yellow", optics.yellow);
    for (const WheelFacts& wheel : facts.wheels) {
        if (!wheel.colour || wheel.fraction > 0.6f) continue;
        const std::vector<int> found = beam.find([&](const ChannelFacts& channel) {
            return selects_colour(channel.role) &&
                   fixture::attribute_from(channel.attribute).number == wheel.number;
        });
        parts.push_back("'" + wheel.slot + (wheel.next.empty() ? "" : "' and '" + wheel.next) + "' of '" +
                        wheel.name + "'" +
                        (found.empty() ? ""
                                       : " on " + place_text(beam.at(found.front())) + ", value " +
                                             beam.at(found.front()).value));
        channels.insert(channels.end(), found.begin(), found.end());
    }
    if (parts.empty()) parts.push_back("the colour");
    findings.push_back(
        blocking(Cause::colour,
                 joined(parts) + (parts.size() > 1 ? " let " : " lets ") + "only " + passes + " through",
                 "their colours let next to nothing through", channels, facts.colour));
}

// "the framing blades (top 60 % on channel 20 (1.020), bottom 45 % on channel 24 (1.024)) let only 0.1 %
// ...".
void add_blade_finding(const Beam& beam, const fixture::Optics& optics, const BeamFacts& facts,
                       std::vector<Reason>& findings) {
    if (facts.blades >= kBlocks) return;
    constexpr std::array kSides{"top", "right", "bottom", "left"};
    std::vector<std::string> parts;
    std::vector<int> channels;
    for (std::size_t k = 0; k < std::min(optics.blades.size(), kSides.size()); ++k) {
        const fixture::Blade& blade = optics.blades[k];
        const float in = std::max(blade.a, blade.b);
        if (in <= kOut) continue;
        const std::vector<int> found = beam.find([&](const ChannelFacts& channel) {
            return (channel.role == Role::blade_a || channel.role == Role::blade_b) &&
                   fixture::attribute_from(channel.attribute).number == static_cast<int>(k) + 1;
        });
        parts.push_back(std::string(kSides[k]) + " " + percent(in) +
                        (found.empty() ? "" : " in on " + places_text(beam, found)));
        channels.insert(channels.end(), found.begin(), found.end());
    }
    const std::vector<int> turns = beam.find([](const ChannelFacts& channel) {
        return channel.role == Role::blade_rotate || channel.role == Role::shaper_rotate;
    });
    channels.insert(channels.end(), turns.begin(), turns.end());
    const std::string reaches = facts.iris < 0.9f ? " of what the iris leaves" : " of the light";
    findings.push_back(blocking(Cause::blades,
                                "the framing blades (" + joined(parts, ", ") + ") let only " +
                                    percent(facts.blades) + reaches + " through",
                                "their framing blades let next to nothing through", channels, facts.blades));
}

Reason animation_finding(const Beam& beam, const BeamFacts& facts) {
    const std::vector<int> wheels = beam.of_role(Role::animation_wheel);
    return blocking(Cause::animation,
                    "the animation wheel lets only " + percent(facts.animation) + " of the light through" +
                        (wheels.empty() ? "" : " (" + places_text(beam, wheels) + ")"),
                    "their animation wheel lets next to nothing through", wheels, facts.animation);
}

void add_gobo_findings(const Beam& beam, const BeamFacts& facts, std::vector<Reason>& findings) {
    if (facts.gobo >= kBlocks) return;
    for (const WheelFacts& wheel : facts.wheels) {
        if (wheel.colour || wheel.fraction > 0.6f) continue;
        const std::vector<int> found = beam.find([&](const ChannelFacts& channel) {
            return selects_gobo(channel.role) &&
                   fixture::attribute_from(channel.attribute).number == wheel.number;
        });
        const std::string where = wheel.next.empty()
                                      ? "stands at '" + wheel.slot + "'"
                                      : "stands between '" + wheel.slot + "' and '" + wheel.next + "'";
        findings.push_back(blocking(Cause::gobo,
                                    "gobo wheel '" + wheel.name + "' " + where + " and lets only " +
                                        percent(wheel.fraction) + " of the light through" +
                                        (found.empty() ? ""
                                                       : " (" + place_text(beam.at(found.front())) +
                                                             ", value " + beam.at(found.front()).value + ")"),
                                    "their gobo lets next to nothing through", found, facts.gobo));
    }
}

void add_zoom_findings(const Beam& beam, const fixture::Type& type, const fixture::BeamState& state,
                       std::vector<Reason>& findings) {
    const fixture::Geometry& geometry = type.geometries[static_cast<std::size_t>(state.geometry)];
    const std::vector<int> zooms = beam.of_role(Role::zoom);
    const float zoom_deg = state.optics.zoom_deg;
    const bool thin = zoom_deg < kThinnest_deg && geometry.kind != fixture::GeometryKind::laser;
    std::string text;
    bool odd = thin;
    for (const int zoom : zooms) {
        const ChannelFacts& channel = beam.at(zoom);
        const float deg = channel.reading.physical;
        odd = odd || deg < fixture::kMinZoom_deg || deg > fixture::kMaxZoom_deg;
        text = "the zoom on " + place_text(channel) + " " + value_text(channel) + ", which the file calls " +
               channel.meaning;
    }
    if (zooms.empty()) {
        odd = odd || geometry.beam->field_angle_deg > fixture::kMaxZoom_deg;
        text = "the file gives its beam " + number(static_cast<double>(geometry.beam->field_angle_deg), 2) +
               " deg";
    }
    if (!odd) return;
    findings.push_back({Cause::zoom, thin,
                        text + ": no angle of a lamp; drawn is a field of " +
                            number(static_cast<double>(zoom_deg), 2) + " deg",
                        "their zoom gives no beam", zooms, 1.0f});
}

// Of a range that has names for its parts these tell what is meant: one of "Control and reset" is idle.
bool says_reset(const ChannelFacts& channel) {
    const std::string said = lower(channel.set.empty() ? channel.function : channel.set);
    const std::size_t at = said.find("reset");
    return at != std::string::npos && said.find("no reset") == std::string::npos &&
           (at == 0 || std::isalpha(static_cast<unsigned char>(said[at - 1])) == 0);
}

// A lamp that does not burn, and a channel that says so.
void add_lamp_findings(const Beam& beam, const BeamFacts& facts, std::vector<Reason>& findings) {
    if (!(facts.full_lm > 0.0f))
        findings.push_back(
            blocking(Cause::lamp, "its file gives the lamp 0 lumens", "their lamp has 0 lumens", {}, 0.0f));
    const bool out = facts.lamp < kBlocks;
    bool said_off = false;
    for (std::size_t i = 0; i < beam.channels.size(); ++i) {
        const ChannelFacts& channel = beam.channels[i];
        if (channel.role != Role::none && channel.role != Role::lamp) continue;
        const std::string said = lower(channel.function + " " + channel.set);
        if (channel.role == Role::none && says_reset(channel))
            findings.push_back({Cause::lamp,
                                false,
                                "it is told to reset itself: function " + function_text(channel) + " on " +
                                    place_text(channel) + ", value " + channel.value +
                                    " (in the picture it does not)",
                                "they are told to reset themselves",
                                {static_cast<int>(i)},
                                1.0f});
        if (said.find("lamp off") == std::string::npos && said.find("lampoff") == std::string::npos) continue;
        said_off = true;
        findings.push_back({Cause::lamp,
                            out,
                            "the lamp is told to go off: function " + function_text(channel) + " on " +
                                place_text(channel) + ", value " + channel.value +
                                (out ? "" : " (in the picture it burns)"),
                            "their lamp is off",
                            {static_cast<int>(i)},
                            facts.lamp});
    }
    if (out && !said_off)
        findings.push_back(blocking(Cause::lamp,
                                    "its lamp gives " + percent(facts.lamp) +
                                        ": it is off, or was struck less than a minute ago",
                                    "their lamp is off", {}, facts.lamp));
}

} // namespace

std::vector<Reason> causes_in_beam(const fixture::Patch& patch, std::size_t beam_index,
                                   const fixture::BeamState& state, const BeamFacts& facts,
                                   const std::vector<ChannelFacts>& channels,
                                   const fixture::Programmer* hand) {
    const Beam beam{patch.mode_of(), beam_index, channels};
    const fixture::Optics& optics = state.optics;
    std::vector<Reason> findings;
    const int node = patch.mode_of().beams[beam_index];
    if (patch.type
            ->geometries[static_cast<std::size_t>(
                patch.mode_of().nodes[static_cast<std::size_t>(node)].geometry)]
            .beam->is_assumed)
        findings.push_back({Cause::no_beam,
                            false,
                            "stand-in optics of 10000 lm and 25 degrees: its file says nothing of its own",
                            "their optics are a stand-in",
                            {}});
    if (hand && hand->intensity && *hand->intensity < kBlocks)
        findings.push_back(blocking(Cause::dimmer, "its intensity is at " + percent(*hand->intensity),
                                    "their intensity is at 0", {}, optics.dimmer));
    else if (std::optional<Reason> dimmer =
                 optics.dimmer < kBlocks ? dimmer_finding(beam, optics, facts) : std::nullopt)
        findings.push_back(std::move(*dimmer));
    add_virtual_dimmer(beam, findings);
    if (facts.shutter < kBlocks) findings.push_back(shutter_finding(beam, facts));
    if (facts.strobe < kBlocks) findings.push_back(strobe_finding(beam, facts));
    if (facts.iris < kBlocks) {
        const std::vector<int> irises = beam.of_role(Role::iris);
        std::string text = "the iris is closed to " + percent(optics.iris) + " of the beam's width";
        if (!irises.empty())
            text += ": " + place_text(beam.at(irises.front())) + " " + value_text(beam.at(irises.front()));
        findings.push_back(blocking(Cause::iris, text, "their iris is closed", irises, facts.iris));
    }
    add_blade_finding(beam, optics, facts, findings);
    add_colour_findings(beam, optics, facts, findings);
    add_gobo_findings(beam, facts, findings);
    if (facts.animation < kBlocks) findings.push_back(animation_finding(beam, facts));
    if (facts.picture < kBlocks)
        findings.push_back(blocking(Cause::picture,
                                    "the picture that it projects is black at this moment: of white it has " +
                                        percent(facts.picture),
                                    "their picture is black", {}, facts.picture));
    add_zoom_findings(beam, *patch.type, state, findings);
    if (facts.emitters < kBlocks && !optics.emitters.empty()) {
        const std::vector<int> colours = beam.of_role(Role::color_add);
        findings.push_back(blocking(
            Cause::emitters,
            std::string(colours.size() > 1 ? "all its colours are" : "its colour is") +
                " at 0: an LED needs colour as well as its dimmer (" + places_text(beam, colours) + ")",
            "their colours are all at 0", colours, facts.emitters));
    }
    add_lamp_findings(beam, facts, findings);
    return findings;
}

} // namespace ghost::scene::explained
