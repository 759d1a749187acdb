#pragma once
// SPDX-License-Identifier: Apache-2.0
// Symbols of fixtures on a plan, after USITT RP-2 (2006): which one follows from what a type does, not from
// its name. Pure; any thread.

#include "print/pdf_writer.h"
#include "print/words.h"

#include <glm/glm.hpp>

namespace ghost::scene {

struct PatchedFixture; // show/show.h

enum class SymbolKind {
    moving_profile,
    moving_wash,
    moving_beam,
    profile,
    wash,
    strobe,
    bar,
    blinder,
    laser,
    projector,
    wall,
    other,     // it gives no light
    not_known, // its file could not be read, or says neither light nor channels
};

SymbolKind symbol_of(const PatchedFixture& fixture);
Word word_of(SymbolKind kind);

// Where it is drawn, in points of the page.
struct SymbolPlace {
    glm::dvec2 at{0};
    glm::dvec2 right{1, 0};  // unit: the fixture's own X
    glm::dvec2 front{0, -1}; // unit: where it looks, or its own Y
    glm::dvec2 size_pt{10};  // along them
};
void draw_symbol(PdfWriter& pdf, SymbolKind kind, const SymbolPlace& place);

} // namespace ghost::scene
