#pragma once
// SPDX-License-Identifier: Apache-2.0
// How the columns of a table share the width of a page. Pure.

#include "book/paper.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

// Of a column the cells with the most bytes, at most so many: the widest is among them, but for letters of
// very different widths.
std::vector<const std::string*> longest_cells(const PaperTable& table, std::size_t column, std::size_t most);

// wanted: of each column. Where that is more than the page has, columns of text give way, the widest first;
// numbers and codes only where there is no text left to cut: a cut number reads as another one.
std::vector<double> shared_widths(const std::vector<PaperColumn>& columns, std::vector<double> wanted,
                                  double page, double least);

} // namespace ghost::scene
