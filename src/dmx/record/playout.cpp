// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/playout.h"

#include <algorithm>

namespace ghost::dmx {

bool Playout::step(double t_s) {
    const bool goes_on = every_look_ && at_s_ && *at_s_ <= t_s && t_s - *at_s_ <= kMostCaughtUp_s;
    const std::optional<double> next = goes_on ? player_.next_after(*at_s_) : std::nullopt;
    const bool more = next && *next <= t_s;
    at_s_ = more ? *next : t_s;
    return more;
}

Universes Playout::take_due(std::chrono::nanoseconds now) {
    Universes all = player_.at(*at_s_);
    std::erase_if(sent_, [&](const auto& one) { return !all.find(one.first); });
    std::erase_if(all.list, [&](const Universe& universe) {
        const auto [place, added] = sent_.try_emplace(universe.number);
        Sent& sent = place->second;
        const bool changed = added || sent.slot_count != universe.slot_count ||
                             (sent.levels != universe.levels && *sent.levels != *universe.levels);
        if (!changed && now < sent.again) return true;
        const auto again = changed ? now + (every_look_ ? 2 : 1) * period_
                                   : std::max(sent.again + period_, now + period_ / 2);
        sent = {universe.levels, universe.slot_count, again};
        return false;
    });
    return all;
}

Universes Playout::due(double t_s, std::chrono::nanoseconds now) {
    for (;;) {
        const bool more = step(t_s);
        Universes universes = take_due(now);
        if (!more || !universes.list.empty()) return universes;
    }
}

std::optional<double> Playout::next_look_s() const {
    return at_s_ ? player_.next_after(*at_s_) : std::nullopt;
}

std::optional<std::chrono::nanoseconds> Playout::next_repeat() const {
    std::optional<std::chrono::nanoseconds> first;
    for (const auto& [number, sent] : sent_) first = std::min(first.value_or(sent.again), sent.again);
    return first;
}

} // namespace ghost::dmx
