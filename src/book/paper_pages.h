#pragma once
// SPDX-License-Identifier: Apache-2.0
// Paper as files: a table as CSV (RFC 4180, UTF-8 with its mark, so that spreadsheets know it), all of them
// as one page. Pure, any thread.

#include "book/paper.h"
#include "print/html.h"

#include <string>
#include <vector>

namespace ghost::scene {

// A text that a spreadsheet would take for a formula gets a ' before it: names come from outside.
std::string csv_of(const PaperTable& table);
std::string csv_rows_of(const PaperTable& table); // without mark and titles, to be put behind others

// A PDF that lies beside the page.
struct PaperDrawing {
    std::string file; // "plan.pdf"
    std::string title;
};
std::string html_of(const Paper& paper, PaperSize size, const std::vector<PaperDrawing>& drawings = {});

} // namespace ghost::scene
