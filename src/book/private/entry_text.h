#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a page says of an entry of a book, whatever it is printed by. Pure.

#include "book/book.h"
#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

// Before its name, "47. ". Where no entry of the book has a number that of its place, which counts from 0;
// where others have one "".
std::string entry_number(const Book& book, std::size_t place);
// "0:36", "0:25.5": to a hundredth, never later than it is.
std::string moment_text(double at_s, const PrintStyle& style);
// "at 0:36, page 12, look Blue, fade 2 s".
std::string times_text(const BookEntry& entry, const PrintStyle& style);
// Lines of what changes, as many as a page takes, and how many more there are.
std::vector<std::string> change_lines(const BookEntry& entry, const PrintStyle& style);

} // namespace ghost::scene
