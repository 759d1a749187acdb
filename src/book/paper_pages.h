#pragma once
// SPDX-License-Identifier: Apache-2.0
// Paper as files: a table as CSV (RFC 4180, UTF-8 with its mark, so that spreadsheets know it), all of them
// as one page. Pure, any thread.

#include "book/html.h"
#include "book/paper.h"

#include <string>

namespace ghost::scene {

// A text that a spreadsheet would take for a formula gets a ' before it: names come from outside.
std::string csv_of(const PaperTable& table);
std::string html_of(const Paper& paper, PaperSize size);

} // namespace ghost::scene
