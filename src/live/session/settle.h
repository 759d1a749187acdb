#pragma once
// SPDX-License-Identifier: Apache-2.0
// A look at rest: what a sheet or a book draws of levels that stay. Main thread.

#include "dmx/wire/universes.h"
#include "fixture/programmer.h"
#include "light/rig.h"

#include <cstddef>
#include <map>

namespace ghost::app {

// Moves the rig on until wheels and filaments have arrived, and whatever turns has gone on for a while.
void settle(scene::Rig& rig, const dmx::Universes& levels,
            const std::map<std::size_t, fixture::Programmer>& programmer);

} // namespace ghost::app
