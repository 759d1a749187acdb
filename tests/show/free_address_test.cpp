// SPDX-License-Identifier: Apache-2.0
#include "show/free_address.h"

#include <gtest/gtest.h>

namespace ghost::fixture {
namespace {

Type type_of(int channels) {
    Type type;
    type.modes.emplace_back();
    type.modes.back().footprint = {channels};
    return type;
}

bool operator==(const Address& a, const std::pair<int, int>& b) {
    return a.universe == b.first && a.channel == b.second;
}

TEST(FreeAddress, gaps_are_taken_if_they_are_large_enough) {
    const Type ten = type_of(10);
    const std::vector<Patch> patches{
        {"a", &ten, 0, {{1, 1}}}, {"b", &ten, 0, {{1, 16}}}, {"c", &ten, 0, {{1, 26}}}};
    EXPECT_TRUE(*find_free_address(patches, 5, {1, 1}) == std::pair(1, 11));
    EXPECT_TRUE(*find_free_address(patches, 6, {1, 1}) == std::pair(1, 36));
    EXPECT_TRUE(*find_free_address(patches, 6, {1, 200}) == std::pair(1, 200));
    EXPECT_TRUE(*find_free_address(patches, 512, {1, 1}) == std::pair(2, 1));
    EXPECT_TRUE(*find_free_address({}, 10, {3, 510}) == std::pair(4, 1))
        << "not across the end of a universe";
}

TEST(FreeAddress, fixtures_that_stand_across_the_end_are_seen_in_the_next_universe) {
    const Type ten = type_of(10);
    const std::vector<Patch> patches{{"a", &ten, 0, {{1, 510}}}};
    EXPECT_TRUE(*find_free_address(patches, 10, {1, 505}) == std::pair(2, 8));
}

TEST(FreeAddress, after_the_last_universe_there_is_none) {
    const Type all = type_of(512);
    const std::vector<Patch> patches{{"a", &all, 0, {{63999, 1}}}};
    EXPECT_FALSE(find_free_address(patches, 1, {63999, 1}));
}

TEST(FreeAddress, the_next_one_starts_where_the_one_before_ends) {
    EXPECT_TRUE(next_address({1, 1}, 20, 20) == std::pair(1, 21));
    EXPECT_TRUE(next_address({1, 490}, 20, 20) == std::pair(2, 1));
    EXPECT_TRUE(next_address({1, 500}, 20, 3) == std::pair(2, 8));
}

} // namespace
} // namespace ghost::fixture
