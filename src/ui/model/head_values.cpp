// SPDX-License-Identifier: Apache-2.0
#include "ui/model/head_values.h"

#include "show/show.h"
#include "ui/model/head_parameters.h"

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

using fixture::Channel;
using fixture::Programmer;
using fixture::Role;

// What has a row of its own in the panel.
struct Number {
    const char* word;
    Role role;
    std::optional<float> Programmer::*value;
    float FixtureNow::*now;
};
constexpr Number kNumbers[] = {
    {"intensity", Role::dimmer, &Programmer::intensity, &FixtureNow::dimmer},
    {"zoom", Role::zoom, &Programmer::zoom_deg, &FixtureNow::zoom_deg},
    {"pan", Role::pan, &Programmer::pan_deg, &FixtureNow::pan_deg},
    {"tilt", Role::tilt, &Programmer::tilt_deg, &FixtureNow::tilt_deg},
};

const Number* number_called(const std::string& word) {
    const auto* const found = std::find_if(std::begin(kNumbers), std::end(kNumbers),
                                           [&](const Number& one) { return word == one.word; });
    return found == std::end(kNumbers) ? nullptr : found;
}

template <class F>
bool has_channel(const scene::PatchedFixture& fixture, F&& f) {
    if (!fixture.type) return false;
    const fixture::Patch patch = fixture.patch();
    const std::vector<Channel>& channels = patch.mode_of().channels;
    return std::any_of(channels.begin(), channels.end(), f);
}

// Those that a desk can move.
template <class F>
void for_channels(const scene::PatchedFixture& fixture, F&& f) {
    if (!fixture.type) return;
    const fixture::Patch patch = fixture.patch();
    for (const Channel& channel : patch.mode_of().channels)
        if (!channel.offsets.empty()) f(channel);
}

float in_reach(const scene::PatchedFixture& fixture, const Number& row, float number) {
    if (row.role == Role::dimmer) return std::clamp(number, 0.0f, 1.0f);
    const auto reach = fixture.type ? fixture::reach_of(fixture.patch(), row.role) : std::nullopt;
    return reach ? std::clamp(number, reach->low, reach->high) : number;
}

// What a colour or a gobo stood for goes on by its channels, when one of these is moved.
void to_channels(const fixture::Patch& patch, const QString& group, int gobo_wheel, Programmer& programmer) {
    for (const Channel& channel : patch.mode_of().channels)
        if (!channel.offsets.empty() && group_of(channel) == group)
            if (const auto share = share_by_value(programmer, channel, gobo_wheel))
                programmer.channels[channel.name] = *share;
}

} // namespace

bool has_value(const scene::PatchedFixture& fixture, const std::string& word) {
    if (word == "intensity" || word == "colour") return true;
    if (const Number* const number = number_called(word))
        return has_channel(fixture, [&](const Channel& one) { return role_of(one) == number->role; });
    if (word == "gobo") return fixture.type && !fixture::gobo_names(fixture.patch()).empty();
    return has_channel(fixture, [&](const Channel& one) { return attribute_of(one) == word; });
}

HeadReader::HeadReader(const scene::Show& show, const Look& look, const RigNow& rig)
    : show_(show), look_(look), rig_(rig), levels_(levels_of(rig.universes)) {}

std::optional<HeadValue> HeadReader::value(std::size_t fixture, const std::string& word) const {
    if (fixture >= show_.fixtures.size() || fixture >= rig_.fixtures.size()) return std::nullopt;
    const scene::PatchedFixture& patched = show_.fixtures[fixture];
    if (!has_value(patched, word)) return std::nullopt;
    const auto by_hand = look_.fixtures.find(fixture);
    const Programmer programmer = by_hand == look_.fixtures.end() ? Programmer{} : by_hand->second;
    const FixtureNow& now = rig_.fixtures[fixture];
    if (const Number* const number = number_called(word)) {
        if (programmer.*number->value) return *(programmer.*number->value);
        const bool is_held = !programmer.levels.empty() || holds(patched, number->role, programmer);
        return is_held ? now.*number->now : (now.asked.*number->value).value_or(now.*number->now);
    }
    if (word == "colour") {
        if (programmer.colour) return *programmer.colour;
        return now.colour == glm::vec3(0) ? std::nullopt : std::optional<HeadValue>(now.colour);
    }
    if (word == "gobo") {
        const std::optional<int> slot = programmer.gobo ? programmer.gobo : now.gobo;
        return slot ? std::optional<HeadValue>(static_cast<float>(*slot)) : std::nullopt;
    }
    const auto values = values_of(patched, programmer, levels_, {{word, {}, {}, {}}});
    return values.front() ? std::optional<HeadValue>(values.front()->share) : std::nullopt;
}

void set_value(const scene::PatchedFixture& fixture, const std::string& word, const HeadValue& value,
               Programmer& programmer) {
    if (!has_value(fixture, word)) return;
    if (const auto* const colour = std::get_if<glm::vec3>(&value)) {
        if (word == "colour") programmer.colour = *colour;
        return;
    }
    const float number = std::get<float>(value);
    if (const Number* const row = number_called(word))
        programmer.*row->value = in_reach(fixture, *row, number);
    else if (word == "gobo")
        programmer.gobo = static_cast<int>(std::lround(std::max(number, 0.0f)));
    else if (word != "colour")
        set_parameter(fixture, word, std::clamp(number, 0.0f, 1.0f), programmer);
}

void set_parameter(const scene::PatchedFixture& fixture, const std::string& attribute,
                   std::optional<float> share, Programmer& programmer) {
    if (!fixture.type) return;
    const fixture::Patch patch = fixture.patch();
    const int gobo_wheel = programmer.gobo ? gobo_wheel_of(fixture) : -1;
    for (const Channel& channel : patch.mode_of().channels) {
        if (attribute_of(channel) != attribute) continue;
        const QString group = group_of(channel);
        const bool goes = share || share_by_value(programmer, channel, gobo_wheel);
        if (goes && group == "Colour" && programmer.colour) {
            if (share) to_channels(patch, group, gobo_wheel, programmer);
            programmer.colour.reset();
        }
        if (goes && group == "Gobo" && programmer.gobo) {
            if (share) to_channels(patch, group, gobo_wheel, programmer);
            programmer.gobo.reset();
        }
        if (!share) {
            programmer.channels.erase(channel.name);
            continue;
        }
        programmer.channels[channel.name] = *share;
        for (const Number& number : kNumbers)
            if (role_of(channel) == number.role) (programmer.*number.value).reset();
    }
}

void hold(const scene::PatchedFixture& fixture, const fixture::Levels& levels, Programmer& programmer) {
    if (!fixture.type) return;
    const fixture::Patch patch = fixture.patch();
    const std::vector<fixture::ChannelReading> readings =
        programmer.levels.empty() ? fixture::read_channels(patch, levels)
                                  : fixture::read_levels(patch, programmer.levels);
    programmer.levels.clear();
    const std::vector<Channel>& channels = patch.mode_of().channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const Channel& channel = channels[i];
        const auto stands_above = [&](const Number& number) {
            return number.role == role_of(channel) && (programmer.*number.value).has_value();
        };
        if (channel.offsets.empty() || std::any_of(std::begin(kNumbers), std::end(kNumbers), stands_above))
            continue;
        if (programmer.intensity && group_of(channel) == "Shutter") continue; // it has opened it
        programmer.channels.try_emplace(channel.name,
                                        static_cast<float>(static_cast<double>(readings[i].raw) /
                                                           std::max(static_cast<double>(channel.max), 1.0)));
    }
}

Programmer in_channels(const scene::PatchedFixture& fixture, Programmer programmer) {
    if (!programmer.levels.empty()) hold(fixture, {}, programmer);
    return programmer;
}

bool holds(const scene::PatchedFixture& fixture, Role role, const Programmer& programmer) {
    if (programmer.channels.empty()) return false;
    bool found = false;
    for_channels(fixture, [&](const Channel& channel) {
        found = found || (role_of(channel) == role && programmer.channels.contains(channel.name));
    });
    return found;
}

void give_back(const scene::PatchedFixture& fixture, Role role, Programmer& programmer) {
    for_channels(fixture, [&](const Channel& channel) {
        if (role_of(channel) == role) programmer.channels.erase(channel.name);
    });
}

fixture::Levels levels_of(const dmx::Universes& universes) {
    fixture::Levels levels;
    for (const dmx::Universe& universe : universes.list) levels.set(universe.number, *universe.levels);
    return levels;
}

} // namespace ghost::ui
