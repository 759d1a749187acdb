#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sheet: paper with a frame, a title block and a legend beside the place where a drawing goes; and how a
// drawing is spread over sheets. Points, from the upper left corner. One thread.

#include "drawings/drawings.h"
#include "drawings/private/file_symbols.h"
#include "drawings/private/symbols.h"
#include "drawings/private/view.h"
#include "print/pdf_writer.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct LegendLine {
    SymbolKind kind = SymbolKind::other;
    std::string type; // "Vari-Lite VL2500 Spot"
    std::size_t count = 0;
    std::vector<FlatLine> lines; // metres: as its own file draws it; empty: as kind
};

struct TitleBlock {
    std::string show, title, remark;
    std::string scale; // "1:50"
    std::string sheet; // "1 of 3"
    std::string paper, date;
};

struct SheetRoom {
    Extent2 drawing; // within grid numbers
    Extent2 column;  // of legend and title block
};
SheetRoom room_on(const PdfWriter& pdf);

// Legend from its first line on, as many as fit above the notes, which all have room. How many lines it has
// drawn.
std::size_t draw_column(PdfWriter& pdf, const SheetRoom& room, const PrintStyle& style,
                        const TitleBlock& title, const std::vector<LegendLine>& legend,
                        const std::vector<std::string>& notes);
// Lines that found no room, on a sheet of their own.
void draw_legend_sheet(PdfWriter& pdf, const PrintStyle& style, const std::vector<LegendLine>& legend,
                       std::size_t from, const TitleBlock& title);

// "1:48 (1/4" = 1'-0")".
std::string scale_text(int scale);
// Points of paper for a metre.
inline double points_of_metre(int scale) {
    return 1000.0 / scale * kPointsOfMm;
}
// The largest usual scale at which so many metres fit into that room. Nothing: none down to 1:50000.
std::optional<int> fitting_scale(const glm::dvec2& size_m, const glm::dvec2& room_pt, Units units);

} // namespace ghost::scene
