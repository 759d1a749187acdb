#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a page says of an entry of a book, whatever it is printed by. Pure.

#include "book/book.h"
#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

// As it is called, "47"; without a number of its own that of its place, which counts from 0.
std::string entry_number(const BookEntry& entry, std::size_t place);
// "at 0:36, page 12, look Blue, fade 2 s".
std::string times_text(const BookEntry& entry, const PrintStyle& style);
// Lines of what changes, as many as a page takes, and how many more there are.
std::vector<std::string> change_lines(const BookEntry& entry, const PrintStyle& style);

} // namespace ghost::scene
