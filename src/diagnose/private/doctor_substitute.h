#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which fixture file could stand in for one that a plot lacks: by maker and name, and by the mode whose
// length the patch shows. Pure but for the loading of the few files that come nearest; any thread.

#include "fixture/type.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace ghost::scene {

// 0: nothing in common, 1: the same words. Order, case, punctuation and endings do not count; words that say
// little ("lighting", "LED") count little.
double likeness(const std::string& wanted, const std::string& offered);

struct WantedFixture {
    std::string name; // "Robe Lighting@Robin Spiider.gdtf"
    std::string mode; // as the plot names it
    int channels = 0; // that the patch leaves for one; 0: not known
};

struct Suggestion {
    std::size_t offer = 0; // into the names
    double likeness = 0;
    std::string mode;
    int channels = 0;       // of the mode
    bool by_length = false; // the mode was chosen by the patch; else by its name
};

inline constexpr double kSameFixture = 0.75; // from here on the names mean one fixture
inline constexpr double kLikeFixture = 0.35; // below, nothing is suggested

// The likest of the named files that load can read; one with a mode of the right length comes before one
// that is hardly more alike. load: null where it cannot; asked for at most 3.
std::optional<Suggestion>
suggest_substitute(const WantedFixture& wanted, std::span<const std::string> names,
                   const std::function<std::shared_ptr<const fixture::Type>(std::size_t)>& load);

} // namespace ghost::scene
