#pragma once
// SPDX-License-Identifier: Apache-2.0
// Activity: how much a recording does when, to find one's way in it. Reads all of it.

#include "dmx/record/player.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace ghost::dmx {

// Of `parts` equal parts of its time: the sum of all changes of levels in each, as a share of the largest.
// stop: asked between parts; true: the result is empty.
std::vector<float> activity_of(Player& player, std::size_t parts, const std::function<bool()>& stop = {});

} // namespace ghost::dmx
