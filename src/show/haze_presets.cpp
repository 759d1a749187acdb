// SPDX-License-Identifier: Apache-2.0
#include "show/haze_presets.h"

#include "base/suggest.h"

#include <algorithm>
#include <vector>

namespace ghost::scene {
namespace {

// 10 and 40 mg/m^3 are what ANSI E1.5 recommends for glycols at most: as a mean of eight hours, and as a
// peak.
constexpr HazePreset kPresets[] = {
    {"none", 0}, {"hint", 1}, {"light haze", 2.5}, {"haze", 5}, {"heavy haze", 10}, {"fog", 40},
};

} // namespace

std::span<const HazePreset> haze_presets() {
    return kPresets;
}

const HazePreset* find_haze_preset(std::string_view name) {
    const auto* found = std::find_if(std::begin(kPresets), std::end(kPresets),
                                     [&](const HazePreset& preset) { return preset.name == name; });
    return found == std::end(kPresets) ? nullptr : found;
}

std::string no_such_haze_preset(std::string_view name) {
    std::vector<std::string> names;
    std::string text = "is '" + std::string(name.substr(0, 40)) + "', expected one of";
    for (const HazePreset& preset : kPresets) {
        text += (names.empty() ? " \"" : ", \"") + std::string(preset.name) + "\"";
        names.emplace_back(preset.name);
    }
    return text + did_you_mean(name, names);
}

} // namespace ghost::scene
