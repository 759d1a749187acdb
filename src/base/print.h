#pragma once
// SPDX-License-Identifier: Apache-2.0
// What reaches a terminal or a page. Names come from files and networks: what a terminal would obey in them
// (escapes, C0, DEL, C1) and what turns the order of the letters behind them is shown instead, written as JSON
// does, so that this may be JSON, too. Any thread.

#include <string>
#include <string_view>

namespace ghost {

// Newlines and tabs stay; bytes that are not UTF-8 become U+FFFD.
std::string printable(std::string_view text);
// Newlines and tabs are shown, too: a name that somebody else chose, within a line of ours.
std::string one_line(std::string_view text);

// printf, printable.
[[gnu::format(printf, 1, 2)]] void print_text(const char* format, ...);

} // namespace ghost
