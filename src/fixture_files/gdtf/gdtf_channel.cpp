// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/gdtf/private/gdtf_channel.h"

#include "base/text.h"
#include "fixture/decode.h"
#include "fixture/values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxChannelFunctions = 4096; // per channel
constexpr std::size_t kMaxSets = 4096;             // per function
constexpr std::size_t kMaxSubSets = 64;            // per function; the standard has 11 kinds
constexpr float kMaxPhysical = 1e9f;

// "1,2": bytes from 1, coarse first. Empty and "None": virtual.
std::vector<int> read_offsets(GdtfReader& reader, pugi::xml_node node) {
    const std::string text = reader.text(node, "Offset");
    std::vector<int> offsets;
    if (text.empty() || lower(text) == "none") return offsets;
    for (const std::string_view part : split(text, ',')) {
        const std::optional<int> number = parse_int(part);
        if (!number || *number < 1 || *number > 65536 || offsets.size() == 4) {
            reader.say(Severity::error, node,
                       "Offset is '" + text +
                           "', expected one to four numbers from 1; taking a virtual channel");
            return {};
        }
        offsets.push_back(*number - 1);
    }
    return offsets;
}

bool says(const std::string& name, const char* word) {
    return lower(name).find(word) != std::string::npos;
}

// A strobe of one rate whose name says that the light is off, or on, is none.
void repair_strobe(ChannelFunction& function) {
    if (function.meaning.role != Role::strobe || function.physical_from != function.physical_to) return;
    const bool off = says(function.name, "light off") || says(function.name, "clos");
    const bool on = says(function.name, "light on") || says(function.name, "open");
    if (off == on) return;
    function.meaning.role = Role::shutter;
    function.physical_from = function.physical_to = on ? 1.0f : 0.0f;
}

// Real files leave physical values at the default 0..1 where that makes no sense.
void repair_physical(GdtfReader& reader, pugi::xml_node node, ChannelFunction& function) {
    const bool is_default = function.physical_from == 0.0f && function.physical_to == 1.0f;
    const Role role = function.meaning.role;
    if (!is_default) {
        const float narrow_deg = std::min(function.physical_from, function.physical_to);
        const float wide_deg = std::max(function.physical_from, function.physical_to);
        if (role != Role::zoom || (narrow_deg >= kMinZoom_deg && wide_deg <= kMaxZoom_deg)) return;
        char text[120];
        std::snprintf(text, sizeof text,
                      "Zoom goes from %g to %g degrees, which no lens does; drawn within %g to %g",
                      static_cast<double>(function.physical_from), static_cast<double>(function.physical_to),
                      static_cast<double>(kMinZoom_deg), static_cast<double>(kMaxZoom_deg));
        reader.say_once(Severity::note, node, text);
        return;
    }
    if (role == Role::pan || role == Role::tilt) {
        const float half_deg = role == Role::pan ? 270.0f : 135.0f;
        reader.say(Severity::warning, node,
                   function.attribute + " has no physical range, taking -" +
                       std::to_string(static_cast<int>(half_deg)) + " to " +
                       std::to_string(static_cast<int>(half_deg)) + " degrees");
        function.physical_from = -half_deg;
        function.physical_to = half_deg;
        function.is_range_assumed = true;
    }
    if (role == Role::zoom) {
        // Which end is narrow cannot be guessed, so it does nothing.
        const auto& geometries = reader.type().geometries;
        const auto with_beam =
            std::find_if(geometries.begin(), geometries.end(),
                         [](const Geometry& geometry) { return geometry.beam.has_value(); });
        const float deg =
            with_beam == geometries.end() ? Beam{}.field_angle_deg : with_beam->beam->field_angle_deg;
        reader.say(Severity::warning, node,
                   "Zoom has no physical range: the beam keeps its " + std::to_string(std::lround(deg)) +
                       " degrees");
        function.physical_from = function.physical_to = deg;
    }
    // A name that says one of both is believed, unless the function or a set of it says the other.
    const auto is_said = [&](const char* word) {
        const auto sets = node.children("ChannelSet");
        return says(function.name, word) ||
               std::any_of(sets.begin(), sets.end(),
                           [&](const pugi::xml_node& set) { return says(reader.text(set, "Name"), word); });
    };
    if (role != Role::shutter) return;
    if (says(function.name, "open") && !is_said("clos")) function.physical_from = 1.0f;
    if (says(function.name, "clos") && !is_said("open")) function.physical_to = 0.0f;
}

void read_sub_sets(GdtfReader& reader, pugi::xml_node node, ChannelFunction& function) {
    for (const pugi::xml_node child : node.children("SubChannelSet")) {
        if (reader.is_full(child, function.sub_sets.size(), kMaxSubSets, "sub-channel sets")) return;
        SubChannelSet set;
        set.name = reader.text(child, "Name");
        set.physical_from = reader.number(child, "PhysicalFrom", 0.0f, -kMaxPhysical, kMaxPhysical);
        set.physical_to = reader.number(child, "PhysicalTo", 0.0f, -kMaxPhysical, kMaxPhysical);
        // A link "Attribute.Type", or the type alone.
        const std::string unit = reader.text(child, "SubPhysicalUnit");
        set.sub_unit =
            unit.substr(unit.find_last_of('.') == std::string::npos ? 0 : unit.find_last_of('.') + 1);
        set.dmx_profile = reader.link(child, "DMXProfile", reader.dmx_profiles);
        function.sub_sets.push_back(std::move(set));
    }
}

// Files give slots but forget the wheel: "Color2" or "Prism1SelectSpin" mean the wheel Color2 or Prism1.
int guess_wheel(GdtfReader& reader, pugi::xml_node node, const std::string& attribute) {
    bool has_slots = false;
    for (const pugi::xml_node set : node.children("ChannelSet"))
        has_slots = has_slots || parse_int(reader.text(set, "WheelSlotIndex", "0")).value_or(0) > 0;
    if (!has_slots) return -1;
    const std::size_t digit = attribute.find_first_of("0123456789");
    if (digit == std::string::npos) return -1;
    const std::size_t end = std::min(attribute.find_first_not_of("0123456789", digit), attribute.size());
    const std::string name = attribute.substr(0, end);
    int wheel = find_name(reader.wheels, name);
    if (wheel < 0 && name.substr(digit) == "1") wheel = find_name(reader.wheels, name.substr(0, digit));
    if (wheel >= 0)
        reader.say(Severity::warning, node,
                   "slots without a Wheel, taking '" +
                       reader.type().wheels[static_cast<std::size_t>(wheel)].name + "'");
    return wheel;
}

ChannelFunction read_function(GdtfReader& reader, pugi::xml_node node, int bytes, std::size_t number) {
    ChannelFunction function;
    function.attribute = reader.text(node, "Attribute", "NoFeature");
    function.meaning = attribute_from(function.attribute);
    function.name = reader.text(node, "Name");
    if (function.name.empty()) function.name = function.attribute + " " + std::to_string(number);
    function.dmx_from = dmx_value(reader, node, "DMXFrom", bytes, 0);
    function.dmx_default = dmx_value(reader, node, "Default", bytes, function.dmx_from);
    function.physical_from = reader.number(node, "PhysicalFrom", 0.0f, -kMaxPhysical, kMaxPhysical);
    function.physical_to = reader.number(node, "PhysicalTo", 1.0f, -kMaxPhysical, kMaxPhysical);
    function.real_fade_s = reader.number(node, "RealFade", 0.0f, 0.0f, 1e6f);
    function.real_acceleration_s = reader.number(node, "RealAcceleration", 0.0f, 0.0f, 1e6f);
    function.original_attribute = reader.text(node, "OriginalAttribute");
    function.custom_name = reader.text(node, "CustomName");
    function.definition = find_name(reader.definitions, function.attribute);
    if (function.definition < 0 && !reader.definitions.empty() && function.meaning.role == Role::none &&
        lower(function.attribute) != "nofeature")
        reader.say_once(Severity::note, node,
                        "the attribute '" + function.attribute + "' is not in AttributeDefinitions");
    function.wheel = reader.link(node, "Wheel", reader.wheels);
    if (function.wheel < 0 && reader.text(node, "Wheel").empty())
        function.wheel = guess_wheel(reader, node, function.attribute);
    if (function.wheel >= 0 && reader.type().wheels[static_cast<std::size_t>(function.wheel)].slots.empty())
        function.wheel = -1;
    function.emitter = reader.link(node, "Emitter", reader.emitters);
    function.filter = reader.link(node, "Filter", reader.filters);
    if (lower(reader.text(node, "ColorSpace")) != lower(reader.type().color_space.name))
        function.color_space = reader.link(node, "ColorSpace", reader.color_spaces);
    function.gamut = reader.link(node, "Gamut", reader.gamuts);
    if (function.gamut < 0) function.gamut = reader.link(node, "Gammut", reader.gamuts); // so in the schema
    function.dmx_profile = reader.link(node, "DMXProfile", reader.dmx_profiles);
    function.profile_min = reader.number(node, "Min", function.physical_from, -kMaxPhysical, kMaxPhysical);
    function.profile_max = reader.number(node, "Max", function.physical_to, -kMaxPhysical, kMaxPhysical);
    read_sub_sets(reader, node, function);
    repair_strobe(function);
    repair_physical(reader, node, function);
    return function;
}

// A function ends before the next one that counts under the same master.
void close_functions(GdtfReader& reader, ChannelTemplate& source, const std::vector<pugi::xml_node>& nodes) {
    std::map<std::tuple<std::string, std::string, std::string>, std::vector<std::size_t>> groups;
    std::vector<ChannelFunction>& functions = source.channel.functions;
    std::vector<std::size_t> emptied; // their range becomes 1..0
    for (std::size_t i = 0; i < functions.size(); ++i)
        groups[{source.masters[i].link, reader.text(nodes[i], "ModeFrom", "0/1"),
                reader.text(nodes[i], "ModeTo", "0/1")}]
            .push_back(i);
    for (auto& [master, members] : groups) {
        std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return functions[a].dmx_from < functions[b].dmx_from;
        });
        for (std::size_t i = 0; i < members.size(); ++i) {
            ChannelFunction& function = functions[members[i]];
            // Files end a channel with a second function at the first one's place: the first is meant.
            if (i > 0 && functions[members[i - 1]].dmx_from == function.dmx_from) {
                reader.say(
                    Severity::error, nodes[members[i]],
                    "'" + functions[members[i - 1]].name + "' and '" + function.name +
                        "' start at the same DMX value without different mode masters; the first one counts");
                emptied.push_back(members[i]);
            }
            std::size_t next = i + 1;
            while (next < members.size() && functions[members[next]].dmx_from == function.dmx_from) ++next;
            function.dmx_to =
                next < members.size() ? functions[members[next]].dmx_from - 1 : source.channel.max;
        }
    }
    for (const std::size_t i : emptied) {
        functions[i].dmx_from = 1;
        functions[i].dmx_to = 0;
    }
}

void read_sets(GdtfReader& reader, pugi::xml_node node, int bytes, ChannelFunction& function) {
    const int slots =
        function.wheel < 0
            ? 0
            : static_cast<int>(reader.type().wheels[static_cast<std::size_t>(function.wheel)].slots.size());
    if (function.dmx_from > function.dmx_to) return; // said already
    std::size_t bad_slots = 0;
    pugi::xml_node first_bad;
    for (const pugi::xml_node child : node.children("ChannelSet")) {
        if (reader.is_full(child, function.sets.size(), kMaxSets, "channel sets")) break;
        const std::optional<std::uint32_t> from = parse_dmx(reader.text(child, "DMXFrom", "0/1"), bytes);
        const std::uint32_t lowest =
            function.sets.empty() ? function.dmx_from : function.sets.back().dmx_from + 1;
        if (!from || *from < lowest || *from > function.dmx_to) {
            reader.say(Severity::error, child,
                       "DMXFrom of the channel set is '" + reader.text(child, "DMXFrom") +
                           "', expected a value inside of its function and above the set before; left out");
            continue;
        }
        ChannelSet set;
        set.name = reader.text(child, "Name");
        set.dmx_from = *from;
        set.physical_from = reader.number(child, "PhysicalFrom", 0.0f, -kMaxPhysical, kMaxPhysical);
        set.physical_to = reader.number(child, "PhysicalTo", 0.0f, -kMaxPhysical, kMaxPhysical);
        set.is_stated = reader.attribute(child, "PhysicalFrom") && reader.attribute(child, "PhysicalTo");
        const std::optional<int> slot = parse_int(reader.text(child, "WheelSlotIndex", "0"));
        if (slot && *slot >= 1 && *slot <= slots)
            set.slot = *slot - 1;
        else if ((!slot || *slot > slots) && ++bad_slots == 1)
            first_bad = child;
        if (!function.sets.empty()) function.sets.back().dmx_to = set.dmx_from - 1;
        function.sets.push_back(std::move(set));
    }
    if (bad_slots > 0)
        reader.say(Severity::error, first_bad,
                   "WheelSlotIndex is '" + reader.text(first_bad, "WheelSlotIndex") + "', " +
                       (function.wheel < 0
                            ? std::string("but the function names no wheel")
                            : "the wheel '" +
                                  reader.type().wheels[static_cast<std::size_t>(function.wheel)].name +
                                  "' has " + (slots == 0 ? "no" : std::to_string(slots)) + " slots") +
                       (bad_slots > 1 ? " (" + std::to_string(bad_slots) + " sets of this function)" : ""));
    if (function.sets.empty()) return;
    function.sets.back().dmx_to = function.dmx_to;
    settle_sets(function);
}

// What a value below the first function means, where files leave that open: a dimmer that begins at 1 is dark
// at 0, but a strobe that begins at 10 does not flash at 0.
bool holds_below(Role role) {
    switch (role) {
    case Role::dimmer:
    case Role::pan:
    case Role::tilt:
    case Role::color_add:
    case Role::color_sub_c:
    case Role::color_sub_m:
    case Role::color_sub_y:
    case Role::iris:
    case Role::zoom:
    case Role::focus:
    case Role::frost:
    case Role::cct:
        return true;
    default:
        return false;
    }
}

void fill_below(GdtfReader& reader, Channel& channel, const std::vector<ModeMaster>& masters,
                const std::vector<pugi::xml_node>& nodes) {
    std::size_t lowest = channel.functions.size();
    for (std::size_t i = 0; i < channel.functions.size(); ++i) {
        const ChannelFunction& function = channel.functions[i];
        if (function.dmx_from == 0 || !masters[i].link.empty()) return;
        if (function.dmx_from <= function.dmx_to &&
            (lowest == channel.functions.size() || function.dmx_from < channel.functions[lowest].dmx_from))
            lowest = i;
    }
    if (lowest == channel.functions.size()) return;
    ChannelFunction& function = channel.functions[lowest];
    const std::uint32_t from = function.dmx_from;
    const bool holds = holds_below(function.meaning.role);
    reader.say(Severity::warning, nodes[lowest],
               "no function of the channel starts at DMX 0, '" + function.name + "' starts at " +
                   std::to_string(from) + "; " +
                   (holds ? "below it holds its first value" : "below it the channel does nothing"));
    if (!holds) return;
    // The straight line keeps its place: sets say what counts in each part.
    const bool bare = function.sets.empty() || function.sets.front().dmx_from > from;
    const float first =
        function.sets.empty() || bare ? function.physical_from : function.sets[0].physical_from;
    std::vector<ChannelSet> sets;
    sets.push_back({.name = "",
                    .dmx_from = 0,
                    .dmx_to = from - 1,
                    .physical_from = first,
                    .physical_to = first,
                    .is_stated = false});
    if (bare) {
        const std::uint32_t to = function.sets.empty() ? function.dmx_to : function.sets.front().dmx_from - 1;
        const double share =
            (static_cast<double>(to) - from) / (static_cast<double>(function.dmx_to) - from + 1e-9);
        const double last = function.physical_from +
                            share * (static_cast<double>(function.physical_to) - function.physical_from);
        sets.push_back({.name = "",
                        .dmx_from = from,
                        .dmx_to = to,
                        .physical_from = function.physical_from,
                        .physical_to = static_cast<float>(last),
                        .is_stated = false});
    }
    function.sets.insert(function.sets.begin(), sets.begin(), sets.end());
    function.dmx_from = 0;
}

// A head whose file does not say where it rests is at home, not turned to its stops.
void rest_axis(ChannelFunction& function) {
    const Role role = function.meaning.role;
    if ((role == Role::pan || role == Role::tilt) && function.dmx_to > function.dmx_from)
        function.dmx_default = function.dmx_from + (function.dmx_to - function.dmx_from) / 2 + 1;
}

std::uint32_t find_initial(GdtfReader& reader, pugi::xml_node node, const Channel& channel, int bytes) {
    const std::string wanted = reader.text(node, "InitialFunction");
    const std::vector<std::string_view> parts = split(wanted, '.');
    if (parts.size() >= 3) {
        const std::string name = wanted.substr(static_cast<std::size_t>(parts[2].data() - wanted.data()));
        for (const ChannelFunction& function : channel.functions)
            if (function.name == name) return function.dmx_default;
        for (const ChannelFunction& function : channel.functions)
            if (lower(function.name) == lower(name)) return function.dmx_default;
        reader.say(Severity::warning, node,
                   "InitialFunction '" + wanted + "' does not exist in this channel");
    }
    if (reader.attribute(node, "Default")) return dmx_value(reader, node, "Default", bytes, 0);
    return channel.functions.empty() ? 0 : channel.functions[0].dmx_default;
}

} // namespace

int bytes_of(const Channel& channel) {
    return channel.offsets.empty() ? 4 : static_cast<int>(channel.offsets.size());
}

std::uint32_t dmx_value(GdtfReader& reader, pugi::xml_node node, const char* attribute, int bytes,
                        std::uint32_t fallback) {
    const pugi::xml_attribute found = reader.attribute(node, attribute);
    if (!found) return fallback;
    if (const std::optional<std::uint32_t> value = parse_dmx(found.value(), bytes)) return *value;
    reader.say(Severity::error, node,
               std::string(attribute) + " is '" + reader.text(node, attribute) +
                   "', expected a DMX value like 255/1, taking " + std::to_string(fallback));
    return fallback;
}

ChannelTemplate read_channel(GdtfReader& reader, pugi::xml_node node) {
    ChannelTemplate source;
    source.node = node;
    source.geometry = reader.text(node, "Geometry");
    Channel& channel = source.channel;
    channel.offsets = read_offsets(reader, node);
    const int bytes = bytes_of(channel);
    channel.max = dmx_max(bytes);
    const std::string dmx_break = reader.text(node, "DMXBreak", "1");
    source.overwrite = lower(dmx_break) == "overwrite";
    if (!source.overwrite) {
        const std::optional<int> number = parse_int(dmx_break);
        if (number && *number >= 1 && *number <= 255)
            channel.dmx_break = *number;
        else
            reader.say(Severity::warning, node,
                       "DMXBreak is '" + dmx_break + "', expected 1 to 255, taking 1");
    }
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xml_node logical_node : node.children("LogicalChannel")) {
        LogicalChannel logical;
        logical.attribute = reader.text(logical_node, "Attribute");
        const std::string snap = lower(reader.text(logical_node, "Snap", "No"));
        logical.snap = snap == "yes" || snap == "on";
        logical.master = reader.choice(logical_node, "Master", {"None", "Grand", "Group"});
        logical.mib_fade_s = reader.number(logical_node, "MibFade", 0.0f, 0.0f, 1e6f);
        logical.dmx_change_time_limit_s = reader.number(logical_node, "DMXChangeTimeLimit", 0.0f, 0.0f, 1e6f);
        for (const pugi::xml_node function_node : logical_node.children("ChannelFunction")) {
            if (reader.is_full(function_node, channel.functions.size(), kMaxChannelFunctions,
                               "functions in a channel"))
                break;
            ChannelFunction function =
                read_function(reader, function_node, bytes, channel.functions.size() + 1);
            function.logical = static_cast<int>(channel.logical.size());
            channel.functions.push_back(std::move(function));
            source.masters.push_back({reader.text(function_node, "ModeMaster"), function_node});
            nodes.push_back(function_node);
        }
        channel.logical.push_back(std::move(logical));
        if (reader.is_full(logical_node, channel.logical.size(), kMaxChannelFunctions,
                           "logical channels in a channel"))
            break;
    }
    if (channel.logical.empty())
        reader.say(Severity::warning, node, "the channel has no LogicalChannel: it does nothing");
    else if (channel.functions.empty())
        reader.say(Severity::warning, node,
                   "the channel '" + channel.logical[0].attribute +
                       "' has no ChannelFunction: it does nothing");
    close_functions(reader, source, nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        read_sets(reader, nodes[i], bytes, channel.functions[i]);
        if (!reader.attribute(nodes[i], "Default")) rest_axis(channel.functions[i]);
    }
    fill_below(reader, channel, source.masters, nodes);
    channel.initial = find_initial(reader, node, channel, bytes);
    const std::string highlight = reader.text(node, "Highlight", "None");
    if (lower(highlight) != "none" && !highlight.empty()) {
        const std::optional<std::uint32_t> value = parse_dmx(highlight, bytes);
        channel.has_highlight = value.has_value();
        channel.highlight = value.value_or(0);
        if (!value)
            reader.say(Severity::error, node,
                       "Highlight is '" + highlight +
                           "', expected a DMX value like 255/1 or None, taking None");
    }
    return source;
}

} // namespace ghost::fixture
