// SPDX-License-Identifier: Apache-2.0
// Channels of a fixture in words: where they are patched, what was chosen, why, and what it means.
#include "diagnose/explain_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::scene::explained {
namespace {

using fixture::Channel;
using fixture::ChannelFunction;
using fixture::ChannelReading;
using fixture::Role;

std::size_t bytes_of(const Channel& channel) {
    return channel.offsets.empty() ? 4 : channel.offsets.size();
}

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

// "2-3", "2, 5": numbers that follow each other become a range.
std::string runs(const std::vector<std::string>& single, bool follow) {
    if (single.empty()) return "";
    if (single.size() == 1) return single[0];
    if (follow) return single.front() + "-" + single.back();
    std::string text = single[0];
    for (std::size_t i = 1; i < single.size(); ++i) text += ", " + single[i];
    return text;
}

void find_places(const fixture::Patch& patch, const Channel& channel, ChannelFacts& facts) {
    facts.dmx_break = channel.dmx_break;
    if (channel.offsets.empty()) return;
    facts.number = channel.offsets.front() + 1;
    const auto which = static_cast<std::size_t>(channel.dmx_break - 1);
    const bool patched = which < patch.addresses.size() && patch.addresses[which].channel >= 1 &&
                         patch.addresses[which].universe >= 1;
    std::vector<std::string> numbers, addresses;
    bool follow = true;
    for (std::size_t k = 0; k < channel.offsets.size(); ++k) {
        numbers.push_back(std::to_string(channel.offsets[k] + 1));
        follow = follow && channel.offsets[k] == channel.offsets[0] + static_cast<int>(k);
        if (!patched) continue;
        const int place = patch.addresses[which].channel - 1 + channel.offsets[k];
        facts.places.push_back({patch.addresses[which].universe + place / 512, place % 512 + 1});
        addresses.push_back(address_text(facts.places.back()));
    }
    facts.numbers = runs(numbers, follow);
    facts.addresses = runs(addresses, follow);
    // Of one universe that is said once: "1.024-025".
    if (follow && facts.places.size() > 1 && facts.places.front().universe == facts.places.back().universe)
        facts.addresses = addresses.front() + "-" + addresses.back().substr(addresses.back().find('.') + 1);
}

struct Unit {
    const char* text;
    float factor;
};

Unit unit_of(Role role) {
    switch (role) {
    case Role::dimmer:
    case Role::shutter:
    case Role::color_add:
    case Role::color_sub_c:
    case Role::color_sub_m:
    case Role::color_sub_y:
    case Role::iris:
    case Role::frost:
    case Role::color_sub_r:
    case Role::color_sub_g:
    case Role::color_sub_b:
    case Role::color_rgb:
    case Role::hsb_saturation:
    case Role::hsb_brightness:
    case Role::blade_a:
    case Role::blade_b:
        return {"%", 100.0f};
    case Role::strobe:
    case Role::strobe_random:
    case Role::strobe_pulse:
    case Role::strobe_effect:
    case Role::color_wheel_random:
    case Role::gobo_wheel_random:
    case Role::gobo_wheel_shake:
    case Role::gobo_shake:
        return {"Hz", 1.0f};
    case Role::pan:
    case Role::tilt:
    case Role::zoom:
    case Role::gobo_index:
    case Role::color_wheel_index:
    case Role::gobo_wheel_index:
    case Role::hsb_hue:
    case Role::prism_index:
    case Role::animation_index:
    case Role::blade_rotate:
    case Role::shaper_rotate:
        return {"deg", 1.0f};
    case Role::pan_rotate:
    case Role::tilt_rotate:
    case Role::color_wheel_spin:
    case Role::gobo_wheel_spin:
    case Role::gobo_rotate:
    case Role::prism_rotate:
    case Role::animation_rotate:
        return {"deg/s", 1.0f};
    case Role::cct:
        return {"K", 1.0f};
    case Role::time_position:
    case Role::time_color:
    case Role::time_beam:
    case Role::time_gobo:
        return {"s", 1.0f};
    default:
        return {"", 1.0f};
    }
}

// "(Gobo2) on channel 14 is at 30": the master that a function waits for.
std::string master_text(const std::vector<ChannelFacts>& channels, const fixture::Mode& mode,
                        const ChannelFunction& function) {
    const ChannelFacts& master = item(channels, function.master_channel);
    const std::size_t bytes = bytes_of(item(mode.channels, function.master_channel));
    return place_text(master) + " is at " + master.value + ", needed is " +
           range_text(function.master_from, function.master_to, bytes);
}

bool is_emitter(const fixture::Mode& mode, int channel, const ChannelReading& reading, bool of_macro) {
    if (reading.function < 0) return false;
    const ChannelFunction& chosen = item(item(mode.channels, channel).functions, reading.function);
    return chosen.meaning.role == Role::color_add && chosen.attribute.starts_with("ColorMacro") == of_macro;
}

// "; the macro on channel 8 (1.008) is in its place": an emitter that is not shown.
std::string macro_text(const std::vector<ChannelFacts>& channels, const fixture::Mode& mode,
                       const Channel& channel) {
    const ChannelFacts* macro = nullptr;
    for (const int index : mode.order) {
        if (!is_emitter(mode, index, item(channels, index).reading, true)) continue;
        const std::vector<int>& beams = item(mode.channels, index).beams;
        if (std::find_first_of(channel.beams.begin(), channel.beams.end(), beams.begin(), beams.end()) !=
            channel.beams.end())
            macro = &item(channels, index); // the last one counts
    }
    return macro ? "; the macro on " + place_text(*macro) + " is in its place" : "";
}

std::string why_of(const std::vector<ChannelFacts>& channels, const fixture::Mode& mode,
                   const Channel& channel, const ChannelFacts& facts) {
    const ChannelReading& reading = facts.reading;
    std::string text = facts.value;
    if (channel.offsets.empty())
        text = "the default " + facts.value + " of a virtual channel";
    else if (!reading.received)
        text = "the default " + facts.value;
    if (reading.function < 0) return "no function has " + text;
    const ChannelFunction& chosen = item(channel.functions, reading.function);
    text += " is in " + range_text(chosen.dmx_from, chosen.dmx_to, bytes_of(channel));
    if (is_emitter(mode, static_cast<int>(&channel - mode.channels.data()), reading, false))
        text += macro_text(channels, mode, channel);
    if (chosen.master_channel >= 0) return text + " and " + master_text(channels, mode, chosen);
    for (const ChannelFunction& other : channel.functions)
        if (other.master_channel >= 0 && reading.raw >= other.dmx_from && reading.raw <= other.dmx_to)
            return text + "; " + quoted(other.name) +
                   " does not count: " + master_text(channels, mode, other);
    return text;
}

void describe(const fixture::Type& type, const fixture::Mode& mode, const Channel& channel,
              std::vector<ChannelFacts>& channels, ChannelFacts& facts) {
    facts.why = why_of(channels, mode, channel, facts);
    if (facts.reading.function < 0) {
        facts.attribute = channel.logical.empty() ? "" : channel.logical[0].attribute;
        facts.meaning = "nothing";
        return;
    }
    const ChannelFunction& function = item(channel.functions, facts.reading.function);
    facts.attribute = function.attribute;
    facts.function = function.name;
    facts.role = function.meaning.role;
    facts.range = range_text(function.dmx_from, function.dmx_to, bytes_of(channel));
    const fixture::ChannelSet* set =
        facts.reading.set >= 0 ? &item(function.sets, facts.reading.set) : nullptr;
    if (set && !set->name.empty()) {
        facts.set = set->name;
        facts.range = range_text(set->dmx_from, set->dmx_to, bytes_of(channel));
    }
    if (set && set->slot >= 0 && function.wheel >= 0) {
        const fixture::Wheel& wheel = item(type.wheels, function.wheel);
        facts.slot = set->slot + 1;
        facts.meaning = "slot " + std::to_string(facts.slot) + " " +
                        quoted(item(wheel.slots, set->slot).name) + " of " + quoted(wheel.name);
        return;
    }
    const Unit unit = unit_of(facts.role);
    facts.unit = unit.factor == 1.0f ? unit.text : "share";
    const bool selects =
        facts.role == Role::none || facts.role == Role::color_wheel || facts.role == Role::gobo_wheel;
    if (selects && !facts.set.empty())
        facts.meaning = facts.set;
    else
        facts.meaning = number(static_cast<double>(facts.reading.physical * unit.factor), 2) +
                        (facts.unit.empty() ? "" : std::string(" ") + unit.text);
}

} // namespace

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "?";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    std::string result = text;
    if (result.find('.') != std::string::npos) {
        while (result.back() == '0') result.pop_back();
        if (result.back() == '.') result.pop_back();
    }
    return result == "-0" ? "0" : result;
}

std::string percent(float fraction) {
    const double value = 100.0 * static_cast<double>(fraction);
    return number(value, std::abs(value) >= 10.0 ? 0 : std::abs(value) >= 1.0 ? 1 : 2) + " %";
}

std::string dmx_text(std::uint32_t raw, std::size_t bytes) {
    std::string text;
    for (std::size_t k = bytes; k-- > 0;)
        text += (text.empty() ? "" : ".") + std::to_string((raw >> (8 * k)) & 255u);
    return text;
}

std::string range_text(std::uint32_t from, std::uint32_t to, std::size_t bytes) {
    if (from > to) return "none";
    const auto shift = static_cast<unsigned>(8 * (bytes - 1));
    const std::uint32_t fine = (std::uint32_t{1} << shift) - 1u;
    if ((from & fine) == 0 && (to & fine) == fine) {
        from >>= shift;
        to >>= shift;
        bytes = 1;
    }
    return from == to ? dmx_text(from, bytes) : dmx_text(from, bytes) + "-" + dmx_text(to, bytes);
}

std::string address_text(const fixture::Address& address) {
    char text[32];
    std::snprintf(text, sizeof text, "%d.%03d", address.universe, address.channel);
    return text;
}

std::string place_text(const ChannelFacts& channel) {
    if (channel.number == 0) return "the virtual channel " + quoted(channel.name);
    return "channel " + channel.numbers +
           (channel.dmx_break > 1 ? " of break " + std::to_string(channel.dmx_break) : "") +
           (channel.addresses.empty() ? "" : " (" + channel.addresses + ")");
}

std::string value_text(const ChannelFacts& channel) {
    return channel.reading.received ? "is at " + channel.value : "is at its default " + channel.value;
}

std::string joined(const std::vector<std::string>& parts, const std::string& last) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "" : i + 1 == parts.size() ? last : ", ") + parts[i];
    return text;
}

std::vector<ChannelFacts> channel_facts(const fixture::Patch& patch,
                                        const std::vector<ChannelReading>& readings) {
    const fixture::Mode& mode = patch.mode_of();
    std::vector<ChannelFacts> channels(mode.channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        channels[i].name = mode.channels[i].name;
        channels[i].reading = readings[i];
        channels[i].value = dmx_text(readings[i].raw, bytes_of(mode.channels[i]));
        find_places(patch, mode.channels[i], channels[i]);
    }
    for (std::size_t i = 0; i < channels.size(); ++i)
        describe(*patch.type, mode, mode.channels[i], channels, channels[i]);
    return channels;
}

} // namespace ghost::scene::explained
