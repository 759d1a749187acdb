#pragma once
// SPDX-License-Identifier: Apache-2.0
// "did you mean": the nearest of the known names. Pure.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace ghost {

// In the words of every message that says of a key in a file that it is ignored, before its name.
inline constexpr const char* kUnknownKey = "unknown key";

// ", did you mean 'x'?" for the candidate nearest to word (at most a third of its letters apart), else "".
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

// The same for many words of one file: all of them together take a fraction of a second, however many there
// are; those after that get no suggestion.
class Suggestions {
public:
    std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

private:
    std::size_t left_ = std::size_t{100} << 20; // letters that are compared with one
};

// Letters to change, add or leave out (Levenshtein); upper and lower case are the same. Time grows with the
// product of the lengths, so who calls it with words from outside cuts them.
std::size_t edit_distance(std::string_view a, std::string_view b);

} // namespace ghost
