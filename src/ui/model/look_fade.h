#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is between two looks: a crossfade, and what solo leaves of a look. Pure.

#include "link/link.h"

#include <cstddef>

namespace ghost::ui {

// share: 0 from .. 1 to. What only one of them sets comes from, or goes to, what the desk asks for now; so
// nothing jumps when a value is let go. Levels go along where they are quantities (fixture/programmer.h);
// movers go along. Gobos, shadows and attenuation change half-way, objects and surfaces at once.
Look faded(const Look& from, const Look& to, const scene::Show& show, const RigNow& now, float share);

// A hand changed `before` to `after` while a fade from `from` goes on: what it changed is at its end in
// `from`, too, and so does not fade.
void keep_changes(Look& from, const Look& before, const Look& after);

// Fixtures that are not solo are dark.
void leave_solo(Look& look, std::size_t fixture_count);

} // namespace ghost::ui
