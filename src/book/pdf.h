#pragma once
// SPDX-License-Identifier: Apache-2.0
// Book and paperwork as PDF, for printers: what changed since an older book, then four entries on a page or
// twelve; tables with their heads on each page. Text can be searched, fonts are embedded. Equal input gives
// equal bytes. Any thread.

#include "base/report.h"
#include "base/result.h"
#include "book/book.h"
#include "book/difference.h"
#include "book/paper.h"
#include "print/html.h"

#include <filesystem>
#include <string>

namespace ghost::scene {

// difference: null where there is no older book. folder: of the book, where its pictures are. report: gets
// what the pages say of letters that no font has. Error: a picture cannot be read.
Result<std::string> pdf_of(const Book& book, const BookDifference* difference,
                           const std::filesystem::path& folder, PaperSize size, Report& report,
                           const PrintStyle& style = {}, BookLayout layout = BookLayout::list);
Result<std::string> pdf_of(const Paper& paper, PaperSize size, Report& report);

} // namespace ghost::scene
