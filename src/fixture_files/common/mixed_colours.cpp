// SPDX-License-Identifier: Apache-2.0
// Colours of a mode whose channels come from different parts of a file: what is an emitter, what a filter.
#include "fixture_files/common/type_builder.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

bool meets(const std::vector<int>& a, const std::vector<int>& b) {
    if (a.empty() || b.empty()) return true;
    return std::any_of(a.begin(), a.end(),
                       [&](int cell) { return std::find(b.begin(), b.end(), cell) != b.end(); });
}

bool is_primary(const ChannelDraft& draft) {
    return std::any_of(draft.channel.functions.begin(), draft.channel.functions.end(),
                       [](const ChannelFunction& function) {
                           const char letter = function.meaning.letter;
                           return function.meaning.role == Role::color_add && function.emitter < 0 &&
                                  (letter == 'R' || letter == 'G' || letter == 'B');
                       });
}

bool is_flag(const ChannelFunction& function) {
    const Role role = function.meaning.role;
    return role == Role::color_sub_c || role == Role::color_sub_m || role == Role::color_sub_y;
}

ChannelFunction rest_of(const ChannelFunction& function, std::uint32_t low, std::uint32_t high) {
    ChannelFunction rest = make_function("NoFeature", low, high, 0, 1);
    rest.name = function.name;
    return rest;
}

// The macro's functions as emitters of their own; rests: somewhere the other emitters keep their values.
std::vector<ChannelFunction> as_emitters(const Type& type, TypeBuilder& builder, const Channel& channel,
                                         bool& rests) {
    std::vector<ChannelFunction> functions;
    for (const ChannelFunction& function : channel.functions) {
        const Wheel* wheel =
            function.wheel >= 0 ? &type.wheels[static_cast<std::size_t>(function.wheel)] : nullptr;
        std::vector<ChannelSet> sets = function.sets;
        if (wheel && !wheel->slots.empty() && function.meaning.role == Role::color_wheel_index &&
            sets.empty()) {
            const float turns = std::clamp(function.physical_from / 360.0f, 0.0f, 0.9999f);
            const float place = turns * static_cast<float>(wheel->slots.size());
            sets.push_back(
                {function.name, function.dmx_from, function.dmx_to, 0, 0, static_cast<int>(place)});
        }
        if (!wheel || sets.empty()) {
            if (function.meaning.role == Role::none || function.meaning.role == Role::color_wheel_spin)
                functions.push_back(rest_of(function, function.dmx_from, function.dmx_to));
            else
                functions.push_back(function);
            rests = true;
            continue;
        }
        for (const ChannelSet& set : sets) {
            const Slot& slot = wheel->slots[static_cast<std::size_t>(std::max(set.slot, 0))];
            // White or black at 0: the macro is at rest.
            if (set.dmx_from == 0 && (slot.color.Y > 99.0f || slot.color.Y < 0.01f)) {
                functions.push_back(rest_of(function, set.dmx_from, set.dmx_to));
                rests = true;
                continue;
            }
            ChannelFunction made = make_function("ColorMacro1", set.dmx_from, set.dmx_to, 1, 1);
            made.name = set.name;
            made.meaning = {Role::color_add, 1, 'M'};
            made.emitter = builder.add_emitter(set.name, slot.color);
            made.master_channel = function.master_channel;
            made.master_from = function.master_from;
            made.master_to = function.master_to;
            functions.push_back(std::move(made));
        }
    }
    return functions;
}

} // namespace

void mix_colours(const Type& type, TypeBuilder& builder, std::vector<ChannelDraft>& drafts,
                 const std::vector<std::size_t>& macros) {
    std::vector<std::vector<int>> primaries; // the cells of each
    for (const ChannelDraft& draft : drafts)
        if (is_primary(draft)) primaries.push_back(draft.cells);
    const auto has_primary = [&](const std::vector<int>& cells) {
        return std::any_of(primaries.begin(), primaries.end(),
                           [&](const std::vector<int>& primary) { return meets(primary, cells); });
    };
    for (ChannelDraft& draft : drafts) {
        if (std::none_of(draft.channel.functions.begin(), draft.channel.functions.end(), is_flag)) continue;
        if (!has_primary(draft.cells)) continue;
        for (ChannelFunction& function : draft.channel.functions) {
            if (!is_flag(function)) continue;
            function.attribute.replace(0, 9, "ColorAdd_");
            function.meaning = attribute_from(function.attribute);
        }
    }
    for (const std::size_t macro : macros) {
        if (!has_primary(drafts[macro].cells)) continue;
        bool rests = false;
        std::vector<ChannelFunction> functions = as_emitters(type, builder, drafts[macro].channel, rests);
        if (!rests) continue; // it never lets the emitters have their way: it stays a wheel before them
        drafts[macro].channel.functions = std::move(functions);
    }
}

} // namespace ghost::fixture
