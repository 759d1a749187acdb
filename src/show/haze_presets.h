#pragma once
// SPDX-License-Identifier: Apache-2.0
// How thick haze is, by the names a stagehand uses. Droplets in mg/m^3, extinction in 1/m, for a fluid of
// glycol, glycerine or oil in droplets of 1 to 2 um: 3 to 6 m^2/g by Mie's theory
// (docs/reference/show-file.md says what each name means). Their scattering is the default of HazeMedium.
// Pure.

#include <span>
#include <string>
#include <string_view>

namespace ghost::scene {

inline constexpr double kExtinctionPerMilligram = 0.0045; // 1/m per mg/m^3

struct HazePreset {
    std::string_view name;
    double milligrams_per_m3 = 0;

    double extinction_per_m() const { return milligrams_per_m3 * kExtinctionPerMilligram; }
};

// From none to fog, each thicker than the one before.
std::span<const HazePreset> haze_presets();

// Null where there is none of that name.
const HazePreset* find_haze_preset(std::string_view name);

// "is 'fogs', expected one of "none", ..., did you mean 'fog'?"
std::string no_such_haze_preset(std::string_view name);

} // namespace ghost::scene
