#pragma once
// SPDX-License-Identifier: Apache-2.0
// Palette values: what hands set of a head as a palette keeps it (show/palettes.h), and the way back. Pure.

#include "link/link.h"
#include "show/palettes.h"

#include <QStringList>

namespace ghost::scene {
struct PatchedFixture;
} // namespace ghost::scene

namespace ghost::ui {

// Of that kind; empty: hands set nothing of it.
scene::PaletteValues palette_values_of(scene::PaletteKind kind, const scene::PatchedFixture& fixture,
                                       const fixture::Programmer& by_hand);
// What `now` does not say is as it was before.
scene::PaletteValues merged(const scene::PaletteValues& before, const scene::PaletteValues& now);
// What the fixture has of them. False: it has nothing of them.
bool give_values(const scene::PaletteValues& values, const scene::PatchedFixture& fixture,
                 fixture::Programmer& programmer);
// "pan 12.5, tilt 40, Iris 50 %"
QString words_of(const scene::PaletteValues& values);
// "pan, tilt, Iris": what they are of.
QStringList names_of(const scene::PaletteValues& values);

} // namespace ghost::ui
