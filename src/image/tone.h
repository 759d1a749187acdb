#pragma once
// SPDX-License-Identifier: Apache-2.0
// Tone: the curves from scene light to the display (shared/develop.h has the formulas), by the names that
// options and scripts give them. Pure.

#include "base/result.h"

#include <array>
#include <cstdint>
#include <string>

namespace ghost::image {

enum class Tone : std::uint32_t {
    agx,    // film: bright colours go to white
    aces,   // more contrast, bright colours stay saturated for longer
    linear, // none: what is brighter than the display is clipped
};

inline constexpr std::array<Tone, 3> kTones{Tone::agx, Tone::aces, Tone::linear};

std::string name_of(Tone tone);
Result<Tone> tone_from(const std::string& name);

} // namespace ghost::image
