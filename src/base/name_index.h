#pragma once
// SPDX-License-Identifier: Apache-2.0
// NameIndex: things by their names, for patterns of them. A name without * and ? is found at once; a pattern
// is compared with each name, whatever number of things has it. Who looks for the patterns of a file in the
// names of another gives all of them one number of steps, kMostMatchSteps: about a second. Pure.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace ghost {

inline constexpr std::uint64_t kMostMatchSteps = 500'000'000; // letters compared with patterns of one file
// To be said once where they are used up.
inline constexpr const char* kMatchStepsSpent =
    "has more patterns with * and ? than can be compared with so many and so long names (500 million "
    "letters): "
    "this one and those after it match nothing; write names out, or shorter patterns";

class NameIndex {
public:
    // Views: names must outlive it.
    void add(std::string_view name, std::size_t thing) { things_[name].push_back(thing); }
    // In order. Nothing where steps are 0, which they become on the way.
    std::vector<std::size_t> find(std::string_view pattern, std::uint64_t& steps) const;

private:
    std::map<std::string_view, std::vector<std::size_t>> things_;
};

} // namespace ghost
