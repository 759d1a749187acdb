#pragma once
// SPDX-License-Identifier: Apache-2.0
// Wider: which sACN universes are listened for besides, while one that was asked for is silent, so that it
// can be said what comes instead: neighbours of the silent ones, what sources announce (E1.31-2018 section 8)
// and 1 to 64. Within a budget of groups, for each is a membership on each interface; none while all is well.
// No clock.

#include "dmx/merge/discovery.h"

#include <chrono>
#include <optional>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMostWider = 128;
inline constexpr std::chrono::seconds kWiderAfter{2}; // of silence
inline constexpr std::chrono::seconds kWiderRests{5}; // after the last silence

// The universes themselves, sorted: at most kMostWider, neighbours first, then what is announced.
std::vector<std::uint16_t> wider_universes(const std::vector<std::uint16_t>& silent,
                                           const std::vector<DiscoveredSource>& discovered);

class Wider {
public:
    // silent: of those that were asked for, sorted.
    void update(const std::vector<std::uint16_t>& silent, const std::vector<DiscoveredSource>& discovered,
                std::chrono::nanoseconds now);
    const std::vector<std::uint16_t>& universes() const { return universes_; } // empty: not needed

private:
    std::optional<std::chrono::nanoseconds> silent_since_, well_since_;
    std::vector<std::uint16_t> universes_;
};

} // namespace ghost::dmx
