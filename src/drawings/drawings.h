#pragma once
// SPDX-License-Identifier: Apache-2.0
// Plan and section of a show to scale, as vector PDF: stage and trusses as lines, fixtures as symbols with
// number, channel and address, a grid, a legend. What is not known is said on the sheet. Equal input gives
// equal bytes. Any thread.

#include "base/result.h"
#include "print/paper_size.h"
#include "print/print_style.h"

#include <optional>
#include <string>

namespace ghost::scene {

struct Show;
struct Stage;

inline constexpr std::size_t kMostSheets = 64; // of one drawing

struct DrawingOptions {
    PrintStyle style;
    PaperSize paper = PaperSize::a3;
    std::optional<int> scale;          // 50: 1:50; nothing: the largest usual one that fits on a sheet
    std::optional<double> section_x_m; // what is to the right of it, seen from the house, is cut away
    std::string date;                  // as it is printed; "": none
};

struct Drawings {
    std::string pdf;
    int plan_scale = 1, section_scale = 1;
    std::size_t sheets = 0;
    std::string boxes; // what the sheets say of letters that no font has; "": all are there
};

// stage: with the bodies of fixtures (light/bodies.h). Error: more sheets than kMostSheets, with a scale that
// fits; no memory.
Result<Drawings> drawings_of(const Show& show, const Stage& stage, const DrawingOptions& options);

} // namespace ghost::scene
