#pragma once
// SPDX-License-Identifier: Apache-2.0
// How large the distance maps of a live picture are (passes/distance_maps.h), and what a device that holds
// fewer of them leaves out; both say so in the report.

#include "base/report.h"
#include "passes/distance_maps.h"

#include <cstddef>

namespace ghost::app {

// Texels a side.
int map_size(const scene::Show& show, Report& report);

// Lights whose map the device does not hold have none.
void leave_out_maps(scene::DistanceMaps& maps, std::size_t held, Report& report);

} // namespace ghost::app
