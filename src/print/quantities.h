#pragma once
// SPDX-License-Identifier: Apache-2.0
// Numbers and names as people read them on paper. Pure, any thread.

#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

// At most so many decimals, and none that are 0: "12", "12.5". -0 is "0".
std::string number_text(float value, int decimals);

// A space between a number and its unit breaks no line: "12 s", "0 to 80 %".
std::string with_whole_quantities(const std::string& text);

// "Spot 1-8, Wash 3 and 5 more": names that count on are one piece. In the order they come.
std::string names_text(const std::vector<std::string>& names, const PrintStyle& style = {});

// As names_text, without a limit: for tables that people work by.
std::string all_names_text(const std::vector<std::string>& names);

// Bytes at the end of a name that are digits, at most 9.
std::size_t digits_at_end(const std::string& name);

// "3.101" of universe and channel; "not patched" where there is none.
std::string address_text(int universe, int channel);

} // namespace ghost::scene
