#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which universes are joined for a show. Any thread.

#include "diagnose/patch_map.h"

#include <cstdint>
#include <vector>

namespace ghost::app {

// What to join for a show: the universes that are patched, and those of --universes; at most
// dmx::kMaxUniverses.
std::vector<std::uint16_t> joined_universes(std::vector<std::uint16_t> asked_for,
                                            const scene::PatchMap& patch);

} // namespace ghost::app
