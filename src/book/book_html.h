#pragma once
// SPDX-License-Identifier: Apache-2.0
// The page of a cue book: every entry with its pictures and what changed; before them, where there is an
// older book, what became of it, with a slider between old and new. Pure, any thread.

#include "book/book.h"
#include "book/difference.h"
#include "print/html.h"
#include "print/print_style.h"

#include <string>

namespace ghost::scene {

// difference: null, or from an older book.
std::string html_of(const Book& book, const BookDifference* difference, PaperSize paper,
                    const PrintStyle& style = {}, BookLayout layout = BookLayout::list);

} // namespace ghost::scene
