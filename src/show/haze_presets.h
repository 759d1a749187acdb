#pragma once
// SPDX-License-Identifier: Apache-2.0
// How thick haze is, by the names a stagehand uses. Droplets in mg/m^3, extinction in 1/m, for a fluid of
// glycol, glycerine or oil in droplets of 1 to 2 um: 3 to 6 m^2/g by Mie's theory
// (docs/reference/show-file.md says what each name means). Their scattering is the default of HazeMedium.
// Pure.

#include "base/suggest.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

inline constexpr double kExtinctionPerMilligram = 0.0045; // 1/m per mg/m^3

struct HazePreset {
    std::string_view name;
    double milligrams_per_m3 = 0;

    double extinction_per_m() const { return milligrams_per_m3 * kExtinctionPerMilligram; }
};

// From none to fog, each thicker than the one before. 10 and 40 mg/m^3 are what ANSI E1.5 recommends for
// glycols at most: as a mean of eight hours, and as a peak.
inline constexpr HazePreset kHazePresets[] = {
    {"none", 0}, {"hint", 1}, {"light haze", 2.5}, {"haze", 5}, {"heavy haze", 10}, {"fog", 40},
};

// Null where there is none of that name.
inline const HazePreset* find_haze_preset(std::string_view name) {
    const auto* found = std::find_if(std::begin(kHazePresets), std::end(kHazePresets),
                                     [&](const HazePreset& preset) { return preset.name == name; });
    return found == std::end(kHazePresets) ? nullptr : found;
}

// "is 'fogs', expected one of "none", ..., did you mean 'fog'?"
inline std::string no_such_haze_preset(std::string_view name) {
    std::vector<std::string> names;
    std::string text = "is '" + std::string(name.substr(0, 40)) + "', expected one of";
    for (const HazePreset& preset : kHazePresets) {
        text += (names.empty() ? " \"" : ", \"") + std::string(preset.name) + "\"";
        names.emplace_back(preset.name);
    }
    return text + did_you_mean(name, names);
}

} // namespace ghost::scene
