#pragma once
// SPDX-License-Identifier: Apache-2.0
// Symbols that fixtures' own files draw (GDTF's 2D symbols), as they hang and from where the view looks. Pure
// but for what is kept between calls; one thread.

#include "drawings/private/view.h"
#include "fixture/type.h"
#include "print/pdf_writer.h"

#include <glm/glm.hpp>
#include <map>
#include <tuple>
#include <vector>

namespace ghost::scene {

struct PatchedFixture; // show/show.h

struct FlatLine {
    std::vector<glm::dvec2> points;
    bool is_closed = false, is_filled = false;
};

class FileSymbols {
public:
    // Metres of the view about the fixture's place. Empty: its file has none for the side that is seen.
    std::vector<FlatLine> seen(const PatchedFixture& fixture, const glm::mat4& to_world, const View& view);
    // From above, as it hangs straight, for a legend.
    std::vector<FlatLine> from_above(const PatchedFixture& fixture);

private:
    // Fixture's frame.
    struct Line {
        std::vector<glm::vec3> points_m;
        bool is_closed = false, is_filled = false;
    };
    const std::vector<Line>& lines_of(const PatchedFixture& fixture, fixture::SymbolSide side);

    std::map<std::tuple<const fixture::Type*, int, fixture::SymbolSide>, std::vector<Line>> known_;
};

// Points of a page. What is finer than print shows is left out.
void draw_lines(PdfWriter& pdf, const std::vector<FlatLine>& lines);

} // namespace ghost::scene
