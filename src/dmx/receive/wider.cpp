// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/private/wider.h"

#include <set>

namespace ghost::dmx {

namespace {

constexpr int kFirst = 64; // what a small rig uses

} // namespace

std::vector<std::uint16_t> wider_universes(const std::vector<std::uint16_t>& silent,
                                           const std::vector<DiscoveredSource>& discovered) {
    std::set<std::uint16_t> chosen;
    const auto add = [&](int universe) {
        if (universe >= 1 && universe <= kMaxUniverse && chosen.size() < kMostWider)
            chosen.insert(static_cast<std::uint16_t>(universe));
    };
    for (const int universe : silent) {
        // Half of the budget, where hundreds are silent.
        if (chosen.size() >= kMostWider / 2) break;
        add(universe - 1);
        add(universe + 1);
    }
    for (int universe = 1; universe <= kFirst / 2; ++universe) add(universe);
    for (const DiscoveredSource& source : discovered)
        if (source.protocol == Protocol::sacn)
            for (const int universe : *source.universes) add(universe);
    for (int universe = 1; universe <= kFirst; ++universe) add(universe);
    return {chosen.begin(), chosen.end()};
}

void Wider::update(const std::vector<std::uint16_t>& silent, const std::vector<DiscoveredSource>& discovered,
                   std::chrono::nanoseconds now) {
    if (silent.empty()) {
        silent_since_.reset();
        if (!well_since_) well_since_ = now;
        if (now - *well_since_ >= kWiderRests) universes_.clear();
        return;
    }
    well_since_.reset();
    if (!silent_since_) silent_since_ = now;
    if (!universes_.empty() || now - *silent_since_ >= kWiderAfter)
        universes_ = wider_universes(silent, discovered);
}

} // namespace ghost::dmx
