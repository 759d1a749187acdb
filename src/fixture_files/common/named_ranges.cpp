// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/named_ranges.h"

#include "base/text.h"
#include "fixture/slot_meanings.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr int kLeast_k = 1000;
constexpr int kMost_k = 20000;

bool says(const std::string& name, std::initializer_list<std::string_view> words) {
    const std::string small = lower(name);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

float middle(const ChannelSet& set) {
    return 0.5f * (set.physical_from + set.physical_to);
}

// What the sets with one of these words, and none of the others, have in the mean.
std::optional<float> named(const ChannelFunction& function, std::initializer_list<std::string_view> words,
                           std::initializer_list<std::string_view> others) {
    float sum = 0.0f;
    int count = 0;
    for (const ChannelSet& set : function.sets)
        if (says(set.name, words) && !says(set.name, others)) {
            sum += middle(set);
            ++count;
        }
    if (count == 0) return std::nullopt;
    return sum / static_cast<float>(count);
}

// high: words of the end that has the larger number here.
bool turn_round(ChannelFunction& function, std::initializer_list<std::string_view> high,
                std::initializer_list<std::string_view> low) {
    const std::optional<float> at_high = named(function, high, low), at_low = named(function, low, high);
    if (!at_high || !at_low || *at_high >= *at_low) return false;
    const float sum = function.physical_from + function.physical_to;
    const auto turned = [sum](float& value) { value = sum - value; };
    turned(function.physical_from);
    turned(function.physical_to);
    for (ChannelSet& set : function.sets) {
        turned(set.physical_from);
        turned(set.physical_to);
    }
    return true;
}

// A function that is nothing but "Open".
bool open_up(ChannelFunction& function) {
    bool changed = false;
    const bool is_open = !function.sets.empty() &&
                         std::all_of(function.sets.begin(), function.sets.end(), [](const ChannelSet& set) {
                             return lower(trimmed(set.name)) == "open";
                         });
    if (!is_open) return false;
    for (ChannelSet& set : function.sets)
        if (set.physical_from < 1.0f || set.physical_to < 1.0f) {
            set.physical_from = set.physical_to = 1.0f;
            changed = true;
        }
    return changed;
}

// "8000 K", "7978 K -> 6622 K", "2020-3180K": the first and the last number.
struct Kelvin {
    float from = 0.0f, to = 0.0f;
};
std::optional<Kelvin> kelvin_of(const std::string& name) {
    std::vector<int> numbers;
    bool has_unit = false;
    for (std::size_t i = 0; i < name.size();) {
        if (std::isdigit(static_cast<unsigned char>(name[i])) == 0) {
            ++i;
            continue;
        }
        int number = 0;
        for (; i < name.size() && std::isdigit(static_cast<unsigned char>(name[i])) != 0; ++i)
            number = std::min(10 * number + (name[i] - '0'), 10 * kMost_k);
        if (number < kLeast_k || number > kMost_k) continue;
        numbers.push_back(number);
        std::size_t next = i;
        while (next < name.size() && name[next] == ' ') ++next;
        has_unit =
            has_unit || (next < name.size() && std::toupper(static_cast<unsigned char>(name[next])) == 'K');
    }
    if (numbers.empty() || !has_unit) return std::nullopt;
    return Kelvin{static_cast<float>(numbers.front()), static_cast<float>(numbers.back())};
}

// A range in kelvin whose sets have two temperatures or more in their names and state none: settings, not a
// way. A last set of one value is the end of a way.
bool take_settings(ChannelFunction& function) {
    std::vector<std::optional<Kelvin>> known;
    int count = 0;
    for (const ChannelSet& set : function.sets) {
        if (set.slot >= 0 || set.is_stated) return false;
        known.push_back(kelvin_of(set.name));
        count += known.back().has_value();
    }
    if (count < 2 || function.sets.back().dmx_from == function.sets.back().dmx_to) return false;
    for (std::size_t k = 0; k < known.size(); ++k)
        if (known[k]) {
            function.sets[k].physical_from = known[k]->from;
            function.sets[k].physical_to = known[k]->to;
            function.sets[k].is_stated = true;
        }
    return true;
}

bool take_kelvin(ChannelFunction& function) {
    if (std::max(std::abs(function.physical_from), std::abs(function.physical_to)) > kNoKelvin)
        return take_settings(function);
    std::vector<std::optional<Kelvin>> known;
    for (const ChannelSet& set : function.sets) {
        if (set.slot >= 0 || std::max(set.physical_from, set.physical_to) > kNoKelvin) return false;
        known.push_back(kelvin_of(set.name));
    }
    const auto is_known = [](const std::optional<Kelvin>& kelvin) { return kelvin.has_value(); };
    if (std::count_if(known.begin(), known.end(), is_known) < 2) return false;
    const auto first = std::find_if(known.begin(), known.end(), is_known);
    const auto last = std::find_if(known.rbegin(), known.rend(), is_known);
    function.physical_from = (*first)->from;
    function.physical_to = (*last)->to;
    for (std::size_t k = 0; k < known.size(); ++k) {
        ChannelSet& set = function.sets[k];
        if (known[k]) {
            set.physical_from = known[k]->from;
            set.physical_to = known[k]->to;
            set.is_stated = true;
        } else if (const bool between = k > 0 && k + 1 < known.size() && known[k - 1] && known[k + 1];
                   between && trimmed(set.name).empty()) {
            set.physical_from = known[k - 1]->to;
            set.physical_to = known[k + 1]->from;
        } else {
            set.physical_from = set.physical_to = 0.0f; // no correction
        }
    }
    return true;
}

// From its first to its last set called proportional the wheel moves into the beam; these sets name a slot,
// which would put it in altogether.
bool move_in(ChannelFunction& function) {
    const auto moves = [](const ChannelSet& set) { return says(set.name, {"proportional"}); };
    const auto begin = std::find_if(function.sets.begin(), function.sets.end(), moves);
    const auto last = std::find_if(function.sets.rbegin(), function.sets.rend(), moves);
    if (begin == function.sets.end() || &*begin == &*last) return false;
    if (!says(begin->name, {"min"}) || !says(last->name, {"max"})) return false;
    const double from = begin->dmx_from;
    const double span = std::max(static_cast<double>(last->dmx_to) - from, 1.0);
    for (auto set = begin; set != last.base(); ++set) {
        set->slot = -1;
        set->physical_from = static_cast<float>((static_cast<double>(set->dmx_from) - from) / span);
        set->physical_to = static_cast<float>((static_cast<double>(set->dmx_to) - from) / span);
    }
    function.meaning.role = Role::animation_wheel;
    return true;
}

bool is_bare(const ChannelSet& set) {
    return trimmed(set.name).empty();
}

// "from 0% to 100%", "100% light frost": the first and the last number before a per cent sign.
std::optional<std::pair<float, float>> percent_of(const std::string& name) {
    std::optional<std::pair<float, float>> share;
    for (std::size_t sign = name.find('%'); sign != std::string::npos; sign = name.find('%', sign + 1)) {
        std::size_t end = sign;
        while (end > 0 && name[end - 1] == ' ') --end;
        std::size_t begin = end;
        while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
        if (begin == end || end - begin > 3) continue;
        const float value =
            std::min(static_cast<float>(std::stoi(name.substr(begin, end - begin))) / 100.0f, 1.0f);
        if (!share) share = {value, value};
        share->second = value;
    }
    return share;
}

// A frost of 0..1 none of whose sets states a value and some of which have per cents in their names. What
// pulses is in for half of the time.
bool take_percents(ChannelFunction& function) {
    constexpr float kPulsing = 0.5f;
    std::vector<ChannelSet>& sets = function.sets;
    if (function.physical_from != 0.0f || function.physical_to != 1.0f) return false;
    bool has_percents = false;
    for (const ChannelSet& set : sets) {
        if (set.is_stated || set.slot >= 0) return false;
        has_percents = has_percents || percent_of(set.name);
    }
    if (!has_percents) return false;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        ChannelSet& set = sets[k];
        set.is_stated = !is_bare(set);
        if (const auto share = percent_of(set.name)) {
            set.physical_from = share->first;
            set.physical_to = share->second;
        } else if (says(set.name, {"pulse", "pulsing", "ramp"})) {
            set.physical_from = set.physical_to = kPulsing;
        } else if (says(set.name, {"open", "no frost", "off"})) {
            set.physical_from = set.physical_to = 0.0f;
        } else if (is_bare(set)) {
            const float before = k > 0 ? sets[k - 1].physical_to : 0.0f;
            const auto share_behind = k + 1 < sets.size() ? percent_of(sets[k + 1].name) : std::nullopt;
            set.physical_from = before;
            set.physical_to = share_behind ? share_behind->first : before;
        }
    }
    return true;
}

// "No rotation" of a function that turns either way, where the file leaves its speed open or has what lies
// straight from end to end there.
bool stand_still(ChannelFunction& function) {
    const double span = std::max(static_cast<double>(function.dmx_to) - function.dmx_from, 1.0);
    const double range =
        static_cast<double>(function.physical_to) - static_cast<double>(function.physical_from);
    const auto is_on_line = [&](float value, std::uint32_t dmx) {
        const double there = static_cast<double>(function.physical_from) +
                             range * (static_cast<double>(dmx) - function.dmx_from) / span;
        return std::abs(static_cast<double>(value) - there) <= 0.002 * std::abs(range);
    };
    bool changed = false;
    for (ChannelSet& set : function.sets) {
        if (!says(set.name, {"no rotation", "no rotate", "no spin", "stop"}) || says(set.name, {"non"}))
            continue;
        const bool says_no_speed = !set.is_stated || (is_on_line(set.physical_from, set.dmx_from) &&
                                                      is_on_line(set.physical_to, set.dmx_to));
        if (!says_no_speed || (set.physical_from == 0.0f && set.physical_to == 0.0f)) continue;
        set.physical_from = set.physical_to = 0.0f;
        set.is_stated = changed = true;
    }
    return changed;
}

// Rates that rise from "fast to slow", or fall from "slow to fast", are the seconds of a pulse.
bool take_seconds(ChannelFunction& function) {
    const ChannelSet* first = nullptr;
    const ChannelSet* last = nullptr;
    for (const ChannelSet& set : function.sets) {
        if (!set.is_stated) continue;
        if (!(set.physical_from > 0.0f && set.physical_to > 0.0f)) return false;
        if (!first) first = &set;
        last = &set;
    }
    if (!first || first->physical_from == last->physical_to) return false;
    const bool rises = last->physical_to > first->physical_from;
    if (!says(first->name, {rises ? "fast to slow" : "slow to fast"})) return false;
    const auto in_hertz = [](float seconds) { return 1.0f / seconds; };
    for (ChannelSet& set : function.sets) {
        if (!(set.physical_from > 0.0f && set.physical_to > 0.0f)) continue;
        set.physical_from = in_hertz(set.physical_from);
        set.physical_to = in_hertz(set.physical_to);
    }
    function.physical_from = first->physical_from;
    function.physical_to = last->physical_to;
    return true;
}

// An iris is a share: what lies beyond closed and open can only be these.
bool leaves_fraction(const ChannelFunction& function) {
    const auto outside = [](float value) { return !(std::abs(value - 0.5f) < 0.501f); };
    return outside(function.physical_from) || outside(function.physical_to) ||
           std::any_of(function.sets.begin(), function.sets.end(), [&](const ChannelSet& set) {
               return outside(set.physical_from) || outside(set.physical_to);
           });
}

void say(int count, const std::string& what, std::vector<std::string>& sentences) {
    if (count == 0) return;
    sentences.push_back(what + " (" + std::to_string(count) + (count == 1 ? " function)" : " functions)"));
}

} // namespace

std::vector<std::string> believe_names(Type& type) {
    int irises = 0, shares = 0, focuses = 0, corrections = 0, ways = 0, frosts = 0, stops = 0, pulses = 0;
    for (Mode& mode : type.modes)
        for (Channel& channel : mode.channels)
            for (ChannelFunction& function : channel.functions) {
                if (function.dmx_profile >= 0) continue;
                switch (function.meaning.role) {
                case Role::iris:
                    irises += turn_round(function, {"open"}, {"clos"}) || open_up(function);
                    shares += leaves_fraction(function);
                    break;
                case Role::focus:
                    focuses += turn_round(function, {"far", "distant", "infinit"}, {"near", "close"});
                    break;
                case Role::cct:
                    corrections += take_kelvin(function);
                    break;
                case Role::animation_wheel:
                case Role::animation_index:
                    ways += move_in(function);
                    break;
                case Role::frost:
                    frosts += take_percents(function);
                    break;
                case Role::iris_pulse:
                case Role::iris_strobe:
                    pulses += take_seconds(function);
                    break;
                default:
                    if (is_turning(function.meaning.role)) stops += stand_still(function);
                    break;
                }
            }
    std::vector<std::string> sentences;
    say(irises, "the iris is named open where its number says closed; the names are believed", sentences);
    say(shares,
        "an iris goes below 0 or above 1, expected 0 (closed) to 1 (open); below it is closed, above it is "
        "open",
        sentences);
    say(focuses, "the focus is named far at its low end, which is near here; the names are believed",
        sentences);
    say(corrections,
        "a colour temperature whose sets are named in kelvin and state no value; the names are believed",
        sentences);
    say(ways,
        "an animation wheel whose sets are named as a way into the beam moves in; the names are believed",
        sentences);
    say(frosts,
        "a frost whose sets are named in per cent and state no value; the names are believed, and what "
        "pulses is drawn half in",
        sentences);
    say(stops, "a rotation has a speed where its name says that there is none; the names are believed",
        sentences);
    say(pulses,
        "the rate of a pulsing iris falls where its name says that it gets faster; taken for the seconds of "
        "a pulse",
        sentences);
    return sentences;
}

} // namespace ghost::fixture
