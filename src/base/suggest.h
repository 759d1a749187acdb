#pragma once
// SPDX-License-Identifier: Apache-2.0
// "did you mean": the nearest of the known names. Pure.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace ghost {

// ", did you mean 'x'?" for the candidate nearest to word (at most a third of its letters apart), else "".
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

// Letters to change, add or leave out (Levenshtein); upper and lower case are the same. Time grows with the
// product of the lengths, so who calls it with words from outside cuts them.
std::size_t edit_distance(std::string_view a, std::string_view b);

} // namespace ghost
