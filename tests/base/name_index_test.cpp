// SPDX-License-Identifier: Apache-2.0
#include "base/name_index.h"

#include "base/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ghost {
namespace {

using Things = std::vector<std::size_t>;

TEST(NameIndex, what_a_pattern_finds_is_what_matches) {
    const std::vector<std::string> names{"Spot 2",
                                         "Spot 1",
                                         "Wash",
                                         "Spot 1",
                                         "",
                                         "Stra\xc3\x9f"
                                         "e",
                                         "*"};
    NameIndex index;
    for (std::size_t k = 0; k < names.size(); ++k) index.add(names[k], k);
    for (const std::string pattern : {"Spot 1", "Spot ?", "*", "", "*a*", "Stra?e", "?", "nothing", "W*h*"}) {
        Things expected;
        for (std::size_t k = 0; k < names.size(); ++k)
            if (matches(pattern, names[k])) expected.push_back(k);
        std::uint64_t steps = kMostMatchSteps;
        EXPECT_EQ(index.find(pattern, steps), expected) << pattern;
        EXPECT_GT(steps, 0u);
    }
}

// A star for each of a thousand long names that nearly match costs the product of both lengths.
TEST(NameIndex, patterns_that_nearly_match_take_no_time) {
    const std::string pattern = "*" + std::string(998, 'a') + "b";
    std::vector<std::string> names;
    for (int k = 0; k < 1000; ++k) names.push_back(std::string(4090, 'a') + std::to_string(1000 + k));
    NameIndex index;
    for (std::size_t k = 0; k < names.size(); ++k) index.add(names[k], k);
    std::uint64_t steps = kMostMatchSteps;
    EXPECT_TRUE(index.find(pattern, steps).empty());
    EXPECT_EQ(steps, 0u);
    EXPECT_TRUE(index.find(names[3], steps).empty()) << "nothing is found any more, as is said";
    EXPECT_FALSE(matches("a", "a", steps));
}

// A large show: each of 10,000 lamps by its name, and ten patterns.
TEST(NameIndex, names_that_are_written_out_cost_next_to_nothing) {
    std::vector<std::string> names;
    for (int k = 0; k < 10'000; ++k) names.push_back("Lamp " + std::to_string(k));
    NameIndex index;
    for (std::size_t k = 0; k < names.size(); ++k) index.add(names[k], k);
    std::uint64_t steps = kMostMatchSteps;
    for (std::size_t k = 0; k < names.size(); ++k) ASSERT_EQ(index.find(names[k], steps), Things{k});
    for (int k = 1; k < 10; ++k)
        EXPECT_EQ(index.find("*Lamp " + std::to_string(k) + "*", steps).size(), 1111u);
    EXPECT_GT(steps, kMostMatchSteps / 100 * 95);
}

} // namespace
} // namespace ghost
