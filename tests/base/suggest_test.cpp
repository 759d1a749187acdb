// SPDX-License-Identifier: Apache-2.0
#include "base/suggest.h"

#include <ctime>
#include <gtest/gtest.h>
#include <vector>

namespace ghost {
namespace {

TEST(Suggest, the_nearest_is_named) {
    const std::vector<std::string> names{"pan", "tilt", "position"};
    EXPECT_EQ(did_you_mean("postion", names), ", did you mean 'position'?");
    EXPECT_EQ(did_you_mean("TILT", names), ", did you mean 'tilt'?");
    EXPECT_EQ(did_you_mean("gobo wheel", names), "");
}

TEST(Suggest, many_words_for_many_names_take_no_time) {
    std::vector<std::string> names;
    for (int k = 0; k < 60'000; ++k) names.push_back(std::string(55, 'a') + std::to_string(k) + ".gdtf");
    const std::string wanted(60, 'b');
    Suggestions suggestions;
    const std::clock_t begun = std::clock(); // of the processor: without a budget it is hours
    EXPECT_NE(suggestions.did_you_mean(names[7] + "x", std::span(names).first(100)), "");
    for (int k = 0; k < 60'000; ++k) EXPECT_EQ(suggestions.did_you_mean(wanted, names), "");
    EXPECT_LT(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC, 30.0);
}

} // namespace
} // namespace ghost
