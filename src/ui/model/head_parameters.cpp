// SPDX-License-Identifier: Apache-2.0
#include "ui/model/head_parameters.h"

#include "fixture/decode.h"
#include "show/show.h"
#include "ui/language/language.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>

namespace ghost::ui {
namespace {

using fixture::Channel;
using fixture::ChannelFunction;
using fixture::Role;

// Translated where they are shown.
const QStringList kGroups{
    QT_TRANSLATE_NOOP("Parameter", "Shutter"),  QT_TRANSLATE_NOOP("Parameter", "Beam"),
    QT_TRANSLATE_NOOP("Parameter", "Gobo"),     QT_TRANSLATE_NOOP("Parameter", "Colour"),
    QT_TRANSLATE_NOOP("Parameter", "Blades"),   QT_TRANSLATE_NOOP("Parameter", "Laser"),
    QT_TRANSLATE_NOOP("Parameter", "Position"), QT_TRANSLATE_NOOP("Parameter", "Machine")};

// Those that the panel has as rows of their own.
bool has_own_row(Role role) {
    return role == Role::dimmer || role == Role::pan || role == Role::tilt || role == Role::zoom;
}

QString group_of_role(Role role) {
    switch (role) {
    case Role::shutter:
    case Role::strobe:
    case Role::strobe_random:
    case Role::strobe_pulse:
    case Role::strobe_effect:
    case Role::strobe_duration:
    case Role::strobe_frequency:
    case Role::strobe_mode:
        return "Shutter";
    case Role::iris:
    case Role::iris_strobe:
    case Role::iris_pulse:
    case Role::focus:
    case Role::frost:
    case Role::prism:
    case Role::prism_select_spin:
    case Role::prism_index:
    case Role::prism_rotate:
        return "Beam";
    case Role::gobo_wheel:
    case Role::gobo_wheel_index:
    case Role::gobo_wheel_spin:
    case Role::gobo_index:
    case Role::gobo_rotate:
    case Role::gobo_wheel_random:
    case Role::gobo_wheel_shake:
    case Role::gobo_select_spin:
    case Role::gobo_select_shake:
    case Role::gobo_shake:
    case Role::animation_wheel:
    case Role::animation_index:
    case Role::animation_rotate:
    case Role::animation_select_spin:
        return "Gobo";
    case Role::color_add:
    case Role::color_sub_c:
    case Role::color_sub_m:
    case Role::color_sub_y:
    case Role::color_sub_r:
    case Role::color_sub_g:
    case Role::color_sub_b:
    case Role::color_wheel:
    case Role::color_wheel_index:
    case Role::color_wheel_spin:
    case Role::color_wheel_random:
    case Role::color_macro:
    case Role::color_rgb:
    case Role::hsb_hue:
    case Role::hsb_saturation:
    case Role::hsb_brightness:
    case Role::cie_x:
    case Role::cie_y:
    case Role::cie_brightness:
    case Role::cct:
    case Role::tint:
        return "Colour";
    case Role::blade_a:
    case Role::blade_b:
    case Role::blade_rotate:
    case Role::shaper_rotate:
    case Role::shaper_macro:
        return "Blades";
    case Role::laser_figure:
    case Role::laser_rays:
    case Role::laser_width:
    case Role::laser_height:
    case Role::laser_turn:
    case Role::laser_turning:
    case Role::laser_running:
        return "Laser";
    case Role::pan_rotate:
    case Role::tilt_rotate:
    case Role::position_x:
    case Role::position_y:
    case Role::position_z:
    case Role::rotation_x:
    case Role::rotation_y:
    case Role::rotation_z:
        return "Position";
    default:
        return "Machine";
    }
}

float share_of(const Channel& channel, std::uint32_t raw) {
    return static_cast<float>(static_cast<double>(raw) / std::max(static_cast<double>(channel.max), 1.0));
}

// Small machine names say less than the attribute.
QString name_of(const ChannelFunction& function) {
    return attribute_words(function.attribute.empty() ? function.name : function.attribute);
}

// Of a function that means one thing only, all over its range.
QString choice_of(const ChannelFunction& function) {
    if (function.meaning.role != Role::shutter || function.physical_from != function.physical_to) return {};
    return function.physical_from > 0.5f ? translated("Parameter", "Open")
                                         : translated("Parameter", "Closed");
}

QString unit_of(Role role) {
    switch (role) {
    case Role::strobe:
    case Role::strobe_random:
    case Role::strobe_pulse:
    case Role::strobe_effect:
    case Role::strobe_frequency:
    case Role::gobo_shake:
        return " Hz";
    case Role::cct:
        return " K";
    case Role::gobo_index:
    case Role::gobo_wheel_index:
    case Role::prism_index:
    case Role::blade_rotate:
    case Role::shaper_rotate:
    case Role::hsb_hue:
    case Role::animation_index:
        return "\u00b0";
    case Role::gobo_rotate:
    case Role::gobo_wheel_spin:
    case Role::prism_rotate:
    case Role::pan_rotate:
    case Role::tilt_rotate:
    case Role::animation_rotate:
    case Role::color_wheel_spin:
        return "\u00b0/s";
    default:
        return "";
    }
}

// "12 to 180 °/s", "0 °/s", "50 to 75 %".
QString span_of(float from, float to, const QString& unit) {
    const QString end = QString::number(static_cast<double>(to), 'f', 0) + unit;
    return from == to ? end
                      : translated("Parameter", "%1 to %2")
                            .arg(QString::number(static_cast<double>(from), 'f', 0), end);
}

// Names that several have, with what sets these apart.
void tell_apart(std::vector<ParameterRange>& ranges, const std::vector<QString>& apart) {
    std::map<QString, int> count;
    for (const ParameterRange& range : ranges) ++count[range.name];
    for (std::size_t i = 0; i < ranges.size(); ++i)
        if (count[ranges[i].name] > 1 && ranges[i].name != apart[i]) ranges[i].name += ": " + apart[i];
}

std::vector<ParameterRange> ranges_of(const Channel& channel) {
    std::vector<ParameterRange> ranges;
    std::vector<QString> does, shares; // what each does, and where it lies
    for (const ChannelFunction& function : channel.functions) {
        bool named = false;
        for (const fixture::ChannelSet& set : function.sets) {
            if (set.name.empty()) continue;
            ranges.push_back({QString::fromStdString(set.name), share_of(channel, set.dmx_from),
                              share_of(channel, set.dmx_to), function.wheel, set.slot});
            does.push_back(name_of(function));
            named = true;
        }
        if (named) continue;
        const QString choice = choice_of(function), unit = unit_of(function.meaning.role);
        ranges.push_back({choice.isEmpty() ? name_of(function) : choice, share_of(channel, function.dmx_from),
                          share_of(channel, function.dmx_to)});
        does.push_back(unit.isEmpty() ? ranges.back().name
                                      : span_of(function.physical_from, function.physical_to, unit));
    }
    for (const ParameterRange& range : ranges)
        shares.push_back(span_of(100 * range.from, 100 * range.to, " %"));
    tell_apart(ranges, does);
    tell_apart(ranges, shares);
    return ranges;
}

QString meaning_of(const Channel& channel, std::uint32_t raw) {
    for (const ChannelFunction& function : channel.functions) {
        if (raw < function.dmx_from || raw > function.dmx_to) continue;
        for (const fixture::ChannelSet& set : function.sets)
            if (raw >= set.dmx_from && raw <= set.dmx_to && !set.name.empty())
                return QString::fromStdString(set.name);
        if (const QString choice = choice_of(function); !choice.isEmpty()) return choice;
        const double share =
            function.dmx_to > function.dmx_from
                ? static_cast<double>(raw - function.dmx_from) / (function.dmx_to - function.dmx_from)
                : 0.0;
        const QString unit = unit_of(function.meaning.role);
        if (unit.isEmpty()) return QString("%1 %").arg(std::lround(100 * share));
        const double physical = std::lerp(static_cast<double>(function.physical_from),
                                          static_cast<double>(function.physical_to), share);
        return QString::number(physical, 'f', std::abs(physical) < 10 ? 1 : 0) + unit;
    }
    return "";
}

// The fraction of a colour that a channel lets through or adds; nothing: it has no part in the mix.
std::optional<float> share_of_mix(const fixture::Attribute& meaning, const glm::vec3& colour) {
    switch (meaning.role) {
    case Role::color_sub_c:
        return 1 - colour.r;
    case Role::color_sub_m:
        return 1 - colour.g;
    case Role::color_sub_y:
        return 1 - colour.b;
    case Role::color_sub_r:
        return std::min(colour.r, 1 - std::max(colour.g, colour.b));
    case Role::color_sub_g:
        return std::min(colour.g, 1 - std::max(colour.r, colour.b));
    case Role::color_sub_b:
        return std::min(colour.b, 1 - std::max(colour.r, colour.g));
    case Role::color_add:
    case Role::color_rgb:
        switch (meaning.letter) {
        case 'R':
            return colour.r;
        case 'G':
            return colour.g;
        case 'B':
            return colour.b;
        case 'C':
            return meaning.role == Role::color_rgb ? 1 - colour.r : 0.0f;
        case 'M':
            return meaning.role == Role::color_rgb ? 1 - colour.g : 0.0f;
        case 'Y':
            return meaning.role == Role::color_rgb ? 1 - colour.b : 0.0f;
        default:
            return 0.0f;
        }
    case Role::cct: // out of the beam
        return meaning.letter == 'O' || meaning.letter == 'B' ? std::optional(0.0f) : std::nullopt;
    default:
        return std::nullopt;
    }
}

// In the middle of where a function has that slot of its wheel.
std::optional<float> share_of_slot(const Channel& channel, Role role, int wheel, int slot) {
    for (const ChannelFunction& function : channel.functions) {
        if (function.meaning.role != role || (wheel >= 0 && function.wheel != wheel)) continue;
        for (const fixture::ChannelSet& set : function.sets)
            if (set.slot == slot)
                return 0.5f * (share_of(channel, set.dmx_from) + share_of(channel, set.dmx_to));
    }
    return std::nullopt;
}

std::optional<float> share_when_open(const Channel& channel) {
    for (const ChannelFunction& function : channel.functions)
        if (function.meaning.role == Role::shutter && function.physical_to > 0.5f)
            return function.physical_from > 0.5f
                       ? 0.5f * (share_of(channel, function.dmx_from) + share_of(channel, function.dmx_to))
                       : share_of(channel, function.dmx_to);
    return std::nullopt;
}

} // namespace

// What desks call it; else the attribute with its words apart: "Gobo1PosRotate" -> "Gobo 1 Pos Rotate".
QString attribute_words(const std::string& attribute) {
    static const std::pair<QRegularExpression, const char*> kWords[] = {
        {QRegularExpression("^Shutter(\\d+)(Strobe.*)?$"), QT_TRANSLATE_NOOP("Parameter", "Shutter")},
        {QRegularExpression("^Gobo(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Gobo wheel \\1")},
        {QRegularExpression("^Gobo(\\d+)Pos(Rotate)?$"), QT_TRANSLATE_NOOP("Parameter", "Gobo \\1 turn")},
        {QRegularExpression("^Gobo(\\d+)WheelSpin$"), QT_TRANSLATE_NOOP("Parameter", "Gobo wheel \\1 spins")},
        {QRegularExpression("^Gobo(\\d+)WheelIndex$"), QT_TRANSLATE_NOOP("Parameter", "Gobo wheel \\1 turn")},
        {QRegularExpression("^Gobo(\\d+)WheelRandom$"),
         QT_TRANSLATE_NOOP("Parameter", "Gobo wheel \\1 at random")},
        {QRegularExpression("^Gobo(\\d+)SelectSpin$"), QT_TRANSLATE_NOOP("Parameter", "Gobo \\1, turning")},
        {QRegularExpression("^Gobo(\\d+)(Wheel|Select|Pos)Shake$"),
         QT_TRANSLATE_NOOP("Parameter", "Gobo \\1, shaking")},
        {QRegularExpression("^Prism(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Prism \\1")},
        {QRegularExpression("^Prism(\\d+)Pos(Rotate)?$"), QT_TRANSLATE_NOOP("Parameter", "Prism \\1 turn")},
        {QRegularExpression("^Color(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Colour wheel \\1")},
        {QRegularExpression("^Color(\\d+)WheelSpin$"),
         QT_TRANSLATE_NOOP("Parameter", "Colour wheel \\1 spins")},
        {QRegularExpression("^Color(\\d+)WheelIndex$"),
         QT_TRANSLATE_NOOP("Parameter", "Colour wheel \\1 turn")},
        {QRegularExpression("^Color(\\d+)WheelRandom$"),
         QT_TRANSLATE_NOOP("Parameter", "Colour wheel \\1 at random")},
        {QRegularExpression("^ColorSub_C$"), QT_TRANSLATE_NOOP("Parameter", "Cyan")},
        {QRegularExpression("^ColorSub_M$"), QT_TRANSLATE_NOOP("Parameter", "Magenta")},
        {QRegularExpression("^ColorSub_Y$"), QT_TRANSLATE_NOOP("Parameter", "Yellow")},
        {QRegularExpression("^Color(Add|RGB)_R(ed)?$"), QT_TRANSLATE_NOOP("Parameter", "Red")},
        {QRegularExpression("^Color(Add|RGB)_G(reen)?$"), QT_TRANSLATE_NOOP("Parameter", "Green")},
        {QRegularExpression("^Color(Add|RGB)_B(lue)?$"), QT_TRANSLATE_NOOP("Parameter", "Blue")},
        {QRegularExpression("^ColorAdd_W$"), QT_TRANSLATE_NOOP("Parameter", "White")},
        {QRegularExpression("^ColorAdd_WW$"), QT_TRANSLATE_NOOP("Parameter", "Warm white")},
        {QRegularExpression("^ColorAdd_CW$"), QT_TRANSLATE_NOOP("Parameter", "Cold white")},
        {QRegularExpression("^ColorAdd_RY$"), QT_TRANSLATE_NOOP("Parameter", "Amber")},
        {QRegularExpression("^ColorAdd_GY$"), QT_TRANSLATE_NOOP("Parameter", "Lime")},
        {QRegularExpression("^ColorAdd_UV$"), QT_TRANSLATE_NOOP("Parameter", "UV")},
        {QRegularExpression("^CTO$"), QT_TRANSLATE_NOOP("Parameter", "CTO")},
        {QRegularExpression("^CT[CB]$"), QT_TRANSLATE_NOOP("Parameter", "White (CCT)")},
        {QRegularExpression("^Frost(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Frost \\1")},
        {QRegularExpression("^Focus(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Focus")},
        {QRegularExpression("^AnimationWheel(\\d+)$"), QT_TRANSLATE_NOOP("Parameter", "Animation wheel")},
        {QRegularExpression("^AnimationWheel(\\d+)Pos(Rotate)?$"),
         QT_TRANSLATE_NOOP("Parameter", "Animation wheel turn")},
        {QRegularExpression("^NoFeature$"), QT_TRANSLATE_NOOP("Parameter", "No function")},
    };
    const QString name = QString::fromStdString(attribute);
    for (const auto& [pattern, words] : kWords)
        if (pattern.match(name).hasMatch())
            return QString(name).replace(pattern, translated("Parameter", words));
    static const auto kParts = QRegularExpression("(?<=[a-z])(?=[A-Z0-9])|(?<=[0-9])(?=[A-Z][a-z])");
    return QString(name).replace(kParts, " ").replace('_', ' ').replace("Color", "Colour");
}

int gobo_wheel_of(const scene::PatchedFixture& fixture) {
    if (!fixture.type) return -1;
    for (const fixture::Optics& optics : fixture::decode(fixture.patch(), {}).beams)
        if (!optics.gobo_wheels.empty() && optics.gobo_wheels.front().wheel >= 0)
            return optics.gobo_wheels.front().wheel;
    return -1;
}

std::string attribute_of(const Channel& channel) {
    return channel.logical.empty() ? channel.name : channel.logical.front().attribute;
}

Role role_of(const Channel& channel) {
    for (const ChannelFunction& function : channel.functions)
        if (function.meaning.role != Role::none) return function.meaning.role;
    return Role::none;
}

QString group_of(const Channel& channel) {
    return group_of_role(role_of(channel));
}

std::vector<HeadParameter> parameters_of(const scene::Show& show, const std::set<std::size_t>& selection) {
    std::vector<HeadParameter> parameters;
    std::set<std::string> known;
    std::set<std::pair<const fixture::Type*, int>> seen; // a mode is looked at once
    for (const std::size_t index : selection) {
        if (index >= show.fixtures.size() || !show.fixtures[index].type) continue;
        if (!seen.insert({show.fixtures[index].type.get(), show.fixtures[index].mode}).second) continue;
        const fixture::Patch patch = show.fixtures[index].patch(); // the mode is its
        for (const Channel& channel : patch.mode_of().channels) {
            const std::string attribute = attribute_of(channel);
            const Role role = role_of(channel);
            if (channel.offsets.empty() || has_own_row(role) || !known.insert(attribute).second) continue;
            parameters.push_back({attribute, group_of_role(role), attribute_words(attribute),
                                  ranges_of(channel), show.fixtures[index].type});
        }
    }
    std::stable_sort(parameters.begin(), parameters.end(), [](const auto& a, const auto& b) {
        return kGroups.indexOf(a.group) < kGroups.indexOf(b.group);
    });
    return parameters;
}

std::optional<float> share_by_value(const fixture::Programmer& programmer, const Channel& channel,
                                    int gobo_wheel) {
    const Role role = role_of(channel);
    if (programmer.colour && group_of_role(role) == "Colour") {
        if (const auto slot = share_of_slot(channel, Role::color_wheel, -1, 0)) return slot;
        for (const ChannelFunction& function : channel.functions)
            if (const auto share = share_of_mix(function.meaning, *programmer.colour))
                return std::clamp(*share, 0.0f, 1.0f);
    }
    if (programmer.gobo) {
        const bool is_first =
            std::any_of(channel.functions.begin(), channel.functions.end(),
                        [&](const ChannelFunction& one) { return one.wheel == gobo_wheel; });
        if (is_first || *programmer.gobo == 0) // the others are open with it
            if (const auto slot =
                    share_of_slot(channel, Role::gobo_wheel, is_first ? gobo_wheel : -1, *programmer.gobo))
                return slot;
    }
    if (programmer.intensity && group_of_role(role) == "Shutter") return share_when_open(channel);
    return std::nullopt;
}

std::vector<std::optional<ParameterValue>> values_of(const scene::PatchedFixture& fixture,
                                                     const fixture::Programmer& programmer,
                                                     const fixture::Levels& levels,
                                                     const std::vector<HeadParameter>& parameters) {
    std::vector<std::optional<ParameterValue>> values(parameters.size());
    if (!fixture.type) return values;
    const fixture::Patch patch = fixture.patch();
    const std::vector<Channel>& channels = patch.mode_of().channels;
    const std::vector<fixture::ChannelReading> readings =
        programmer.levels.empty() ? fixture::read_channels(patch, levels)
                                  : fixture::read_levels(patch, programmer.levels);
    const int gobo_wheel = programmer.gobo ? gobo_wheel_of(fixture) : -1;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& one) {
            return attribute_of(one) == parameters[i].attribute;
        });
        if (found == channels.end()) continue;
        const auto by_hand = programmer.channels.find(found->name);
        const bool is_by_hand = by_hand != programmer.channels.end();
        // A shutter by hand is moved whatever the intensity; all else gives way to what stands above it.
        const bool is_of_shutter = group_of(*found) == "Shutter";
        const std::optional<float> above =
            is_by_hand && is_of_shutter ? std::nullopt : share_by_value(programmer, *found, gobo_wheel);
        const std::uint32_t raw = above ? fixture::raw_of(*found, *above)
                                  : is_by_hand
                                      ? fixture::raw_of(*found, by_hand->second)
                                      : readings[static_cast<std::size_t>(found - channels.begin())].raw;
        values[i] = {share_of(*found, raw), is_by_hand || above, meaning_of(*found, raw),
                     above && is_of_shutter};
    }
    return values;
}

} // namespace ghost::ui
