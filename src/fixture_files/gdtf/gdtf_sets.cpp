// SPDX-License-Identifier: Apache-2.0
// Physical values of channel sets that the file leaves open; what sets say together.
#include "base/text.h"
#include "fixture_files/gdtf/private/gdtf_channel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace ghost::fixture {
namespace {

bool name_says(const std::string& name, const char* word) {
    return lower(name).find(word) != std::string::npos;
}

// Straight from end to end of the function.
float on_line(const ChannelFunction& function, std::uint32_t value) {
    const double span = static_cast<double>(function.dmx_to) - static_cast<double>(function.dmx_from);
    const double share =
        span <= 0.0 ? 0.0 : (static_cast<double>(value) - static_cast<double>(function.dmx_from)) / span;
    return static_cast<float>(
        static_cast<double>(function.physical_from) +
        share * (static_cast<double>(function.physical_to) - static_cast<double>(function.physical_from)));
}

bool has_default_range(const ChannelFunction& function) {
    return function.physical_from == 0.0f && function.physical_to == 1.0f;
}

bool says_open(const ChannelSet& set) {
    return (name_says(set.name, "open") && !name_says(set.name, "opening")) ||
           name_says(set.name, "led on") || name_says(set.name, "light on") ||
           name_says(set.name, "shutter on");
}

bool says_closed(const ChannelSet& set) {
    return name_says(set.name, "clos") || name_says(set.name, "led off") ||
           name_says(set.name, "light off") || name_says(set.name, "shutter off") ||
           name_says(set.name, "blackout");
}

// A shutter with a set for each of both is open or closed there, not on its way; and one whose sets all say
// the same of both is nothing else.
void believe_shutter(ChannelFunction& function) {
    std::vector<ChannelSet>& sets = function.sets;
    if (function.meaning.role != Role::shutter) return;
    const bool has_both = std::any_of(sets.begin(), sets.end(), says_open) &&
                          std::any_of(sets.begin(), sets.end(), says_closed);
    const bool is_one =
        has_default_range(function) && std::all_of(sets.begin(), sets.end(), [&](const ChannelSet& set) {
            return !set.is_stated && says_open(set) != says_closed(set) &&
                   says_open(set) == says_open(sets.front());
        });
    if (!has_both && !is_one) return;
    for (ChannelSet& set : sets) {
        if (set.is_stated || says_open(set) == says_closed(set)) continue;
        set.physical_from = set.physical_to = says_open(set) ? 1.0f : 0.0f;
        set.is_stated = true;
    }
    if (is_one) function.physical_from = function.physical_to = sets.front().physical_from;
}

// Where a function has GDTF's default range, which says nothing, and its sets state other values, these are
// its range. false: it has not.
bool take_range_of_sets(ChannelFunction& function) {
    constexpr float kOffTheLine = 0.02f;
    if (!has_default_range(function) || function.dmx_profile >= 0) return false;
    const ChannelSet* first = nullptr;
    const ChannelSet* last = nullptr;
    float low = 0.0f, high = 0.0f;
    bool is_other = false;
    for (const ChannelSet& set : function.sets) {
        if (set.slot >= 0) return false;
        if (!set.is_stated) continue;
        const auto [least, most] = std::minmax(set.physical_from, set.physical_to);
        low = first ? std::min(low, least) : least;
        high = first ? std::max(high, most) : most;
        is_other = is_other || std::abs(set.physical_from - on_line(function, set.dmx_from)) > kOffTheLine ||
                   std::abs(set.physical_to - on_line(function, set.dmx_to)) > kOffTheLine;
        if (!first) first = &set;
        last = &set;
    }
    if (!is_other || first == last) return false;
    const bool falls = first->physical_from > last->physical_to;
    if (low == 0.0f && high == 1.0f && !falls) return false;
    if (low == high && low >= 0.0f && high <= 1.0f) return false;
    function.physical_from = falls ? high : low;
    function.physical_to = falls ? low : high;
    return true;
}

// Sets that leave their values open between two that state them lead from one to the other: what lies
// between two places is not outside of both. Turning either way, and names between two of one value, say
// more than the way from one to the other.
void lead_between(ChannelFunction& function) {
    std::vector<ChannelSet>& sets = function.sets;
    const auto states = [&](std::size_t i) { return sets[i].is_stated && sets[i].slot < 0; };
    for (std::size_t i = 1; i < sets.size(); ++i) {
        if (sets[i].is_stated || !states(i - 1)) continue;
        const std::size_t begin = i;
        bool has_name = false;
        for (; i < sets.size() && !sets[i].is_stated && sets[i].slot < 0; ++i)
            has_name = has_name || !trimmed(sets[i].name).empty();
        if (i == sets.size()) return;
        const ChannelSet& before = sets[begin - 1];
        const ChannelSet& after = sets[i];
        if (!states(i)) continue;
        if (before.physical_to == after.physical_from && has_name) continue;
        if (is_turning(function.meaning.role) && !(before.physical_to * after.physical_from > 0.0f)) continue;
        const auto between = [&](std::uint32_t value) {
            const double share = (static_cast<double>(value) - before.dmx_to) /
                                 (static_cast<double>(after.dmx_from) - before.dmx_to);
            return static_cast<float>(
                static_cast<double>(before.physical_to) +
                share * (static_cast<double>(after.physical_from) - static_cast<double>(before.physical_to)));
        };
        for (std::size_t k = begin; k < i; ++k) {
            sets[k].physical_from = between(sets[k].dmx_from);
            sets[k].physical_to = between(sets[k].dmx_to);
        }
    }
}

// Before the first and behind the last set that states values, where nothing else does.
void hold_at_ends(ChannelFunction& function) {
    const auto is_stated = [](const ChannelSet& set) { return set.is_stated; };
    const auto first = std::find_if(function.sets.begin(), function.sets.end(), is_stated);
    const auto last = std::find_if(function.sets.rbegin(), function.sets.rend(), is_stated).base();
    if (first == function.sets.end()) return;
    for (auto set = function.sets.begin(); set != first; ++set)
        set->physical_from = set->physical_to = first->physical_from;
    for (auto set = last; set != function.sets.end(); ++set)
        set->physical_from = set->physical_to = std::prev(last)->physical_to;
}

// "Open 0..0.5, Blue -0.5..0.5, Green -0.5..0.5": half a slot of one meets half a slot of the next. Steps
// from slot to slot have 0..0, and shakes, which go by Hz, nothing below 0. Files also have -0.5..0.5 for
// steps, and for sets that begin at their slots (Robe BMFL Spot): then the first one begins below 0, or is
// as wide as the others.
bool says_places_beside_slots(const ChannelFunction& function) {
    constexpr float kMostBeside = 0.501f;
    constexpr double kMostOfAWay = 0.75;
    const Role role = function.meaning.role;
    if (role != Role::color_wheel && role != Role::color_wheel_index && role != Role::gobo_wheel &&
        role != Role::gobo_wheel_index)
        return false;
    const ChannelSet* first = nullptr;
    const ChannelSet* way = nullptr; // the first one all of whose slot goes by
    for (const ChannelSet& set : function.sets) {
        if (set.slot < 0) continue;
        const auto [least, most] = std::minmax(set.physical_from, set.physical_to);
        if (!set.is_stated || least < -kMostBeside || most > kMostBeside) return false;
        if (!first) first = &set;
        if (!way && least < 0.0f) way = &set;
    }
    if (!way || first->physical_from < 0.0f) return false;
    const auto width = [](const ChannelSet& set) {
        return static_cast<double>(set.dmx_to) - set.dmx_from + 1.0;
    };
    return first->physical_to > first->physical_from || width(*first) <= kMostOfAWay * width(*way);
}

} // namespace

void settle_sets(ChannelFunction& function) {
    believe_shutter(function);
    const bool is_unsaid = !take_range_of_sets(function);
    for (ChannelSet& set : function.sets) {
        if (set.is_stated) continue;
        set.physical_from = on_line(function, set.dmx_from);
        set.physical_to = on_line(function, set.dmx_to);
    }
    lead_between(function);
    if (!is_unsaid) hold_at_ends(function);
    function.is_beside_slots = says_places_beside_slots(function);
}

} // namespace ghost::fixture
