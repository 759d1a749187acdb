// SPDX-License-Identifier: Apache-2.0
// Which fixture is which in another text or version of a show.
#include "show/same_fixtures.h"
#include "show/show.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

using Same = std::vector<std::optional<std::size_t>>;

struct Named {
    const char* name;
    int address;
    const char* uuid = "";
    const char* file = "spot.gdtf";
};

Show show_of(const std::vector<Named>& fixtures) {
    Show show;
    for (const Named& one : fixtures) {
        PatchedFixture& fixture = show.fixtures.emplace_back();
        fixture.name = one.name;
        fixture.address = one.address;
        fixture.uuid = one.uuid;
        fixture.gdtf = one.file;
    }
    return show;
}

constexpr auto kComes = std::nullopt;

TEST(SameFixtures, are_those_of_one_name_whatever_their_number_and_address) {
    const Show before = show_of({{"A", 1}, {"B", 2}, {"C", 3}});
    EXPECT_EQ(same_fixtures(before, show_of({{"C", 4}, {"A", 1}, {"New", 9}})), (Same{2, 0, kComes}));
    EXPECT_EQ(same_fixtures(before, show_of({{"B", 1}, {"A", 2}, {"C", 3}})), (Same{1, 0, 2}))
        << "two that changed names have changed places";
}

TEST(SameFixtures, of_a_plot_are_those_of_one_object) {
    const Show before = show_of({{"A", 1, "u1"}, {"B", 2, "u2"}, {"C", 3}});
    const Show now = show_of({{"A", 2, "u2"}, {"Front", 1, "u1"}, {"B", 7, "u3"}, {"C", 3}});
    EXPECT_EQ(same_fixtures(before, now), (Same{1, 0, kComes, 2}));
    EXPECT_EQ(renamed_fixtures(before, show_of({{"Front", 5, "u1"}, {"B", 2, "u2"}})),
              (FixtureNames{{"A", "Front"}}));
    EXPECT_TRUE(renamed_fixtures(before, now).empty()) << "A and B are names of others now";
}

TEST(SameFixtures, that_were_renamed_have_the_number_and_the_file) {
    const Show before = show_of({{"A", 1}, {"B", 2}, {"C", 3}});
    const Show now = show_of({{"A", 1}, {"Front", 7}, {"C", 3}});
    EXPECT_EQ(same_fixtures(before, now), (Same{0, 1, 2}));
    EXPECT_EQ(renamed_fixtures(before, now), (FixtureNames{{"B", "Front"}}));
    const Show other = show_of({{"A", 1}, {"Front", 7, "", "wash.gdtf"}, {"C", 3}});
    EXPECT_EQ(same_fixtures(before, other), (Same{0, kComes, 2}));
    const Show of_plot = show_of({{"A", 1}, {"Front", 2, "u1"}, {"C", 3}});
    EXPECT_EQ(same_fixtures(before, of_plot), (Same{0, kComes, 2}));
}

TEST(SameFixtures, that_were_renamed_beside_others_that_came_have_the_address_and_place_for_themselves) {
    const Show before = show_of({{"A", 1}, {"B", 2}, {"C", 2}});
    const Show now = show_of({{"New", 9}, {"Front", 1}, {"B", 2}, {"C", 2}});
    EXPECT_EQ(same_fixtures(before, now), (Same{kComes, 0, 1, 2}));
    EXPECT_EQ(renamed_fixtures(before, now), (FixtureNames{{"A", "Front"}}));
    const Show unsure = show_of({{"A", 1}, {"Left", 2}, {"Right", 2}, {"New", 9}});
    EXPECT_EQ(same_fixtures(before, unsure), (Same{0, kComes, kComes, kComes})) << "nobody knows which";
}

TEST(SameFixtures, each_is_one_s_alone) {
    const Show before = show_of({{"A", 1}});
    EXPECT_EQ(same_fixtures(before, show_of({{"A", 1}, {"A", 1}})), (Same{0, kComes}));
    EXPECT_EQ(same_fixtures(show_of({{"A", 1}, {"A", 1}}), before), (Same{0}));
    EXPECT_TRUE(same_fixtures(before, Show{}).empty());
    EXPECT_EQ(same_fixtures(Show{}, before), (Same{kComes}));
}

} // namespace
} // namespace ghost::scene
