// SPDX-License-Identifier: Apache-2.0
// Trusses and pipes as boxes whose undersides are known.
#include "show_folder/hang.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

std::vector<glm::vec3> box(const glm::vec3& half_m) {
    std::vector<glm::vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.push_back(half_m * glm::vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    return corners;
}

void expect_near(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::distance(a, b), 1e-3f) << a.x << " " << a.y << " " << a.z;
}

const glm::mat4 kUp = glm::translate(glm::mat4(1), {1, 8, 6});

TEST(Hang, the_underside_of_a_truss_is_where_things_hang) {
    const auto bar = bar_of(box({2, 0.2f, 0.25f}), kUp);
    ASSERT_TRUE(bar);
    expect_near(bar->from_m, {-1, 8, 5.75f});
    expect_near(bar->to_m, {3, 8, 5.75f});
    EXPECT_NEAR(bar->across_m, 0.5f, 1e-3f);
    EXPECT_TRUE(is_slender(*bar));
}

// Turned by its node, or with corners that are turned already.
TEST(Hang, a_truss_may_run_any_way_in_plan) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(30.0f), glm::vec3(0, 0, 1));
    const auto by_node = bar_of(box({2, 0.2f, 0.2f}), kUp * turn);
    std::vector<glm::vec3> corners = box({2, 0.2f, 0.2f});
    for (glm::vec3& corner : corners) corner = glm::vec3(turn * glm::vec4(corner, 1));
    const auto by_corners = bar_of(corners, kUp);
    ASSERT_TRUE(by_node && by_corners);
    expect_near(by_node->from_m, glm::vec3(1, 8, 5.8f) - 2.0f * glm::vec3(std::sqrt(3.0f) / 2, 0.5f, 0));
    expect_near(by_node->from_m, by_corners->from_m);
    expect_near(by_node->to_m, by_corners->to_m);
    // One that runs up-stage begins down-stage, whichever way it was drawn.
    const auto up_stage = bar_of(box({2, 0.2f, 0.2f}),
                                 kUp * glm::rotate(glm::mat4(1), glm::radians(-90.0f), glm::vec3(0, 0, 1)));
    ASSERT_TRUE(up_stage);
    expect_near(up_stage->from_m, {1, 6, 5.8f});
}

// Pieces of an arc round (0, -9): 8 m long, its middle 1 m up-stage of its ends.
TEST(Hang, under_a_bent_truss_it_is_the_bend_that_carries) {
    std::vector<glm::vec3> corners;
    for (int k = -20; k <= 20; ++k) {
        const float angle = std::asin(4.0f / 8.5f) * static_cast<float>(k) / 20;
        for (const float radius_m : {8.35f, 8.65f})
            for (const float z_m : {5.7f, 6.0f})
                corners.emplace_back(radius_m * std::sin(angle), radius_m * std::cos(angle) - 9, z_m);
    }
    const auto bar = bar_of(corners, glm::mat4(1));
    ASSERT_TRUE(bar);
    EXPECT_NEAR(bar->bow_m, 1, 0.05f);
    for (const float x_m : {-3.9f, -2.0f, 0.0f, 1.0f, 3.5f}) {
        const glm::vec3 place_m = places_under(*bar, std::array{glm::vec3(x_m, 3, 8)}).front();
        EXPECT_NEAR(place_m.x, x_m, 0.01f);
        EXPECT_NEAR(place_m.y, std::sqrt(8.5f * 8.5f - x_m * x_m) - 9, 0.08f) << x_m;
        EXPECT_NEAR(place_m.z, 5.7f, 1e-4f);
    }
    // Drawn the other way round, or turned, it is the same one.
    const glm::mat4 half_turn = glm::rotate(glm::mat4(1), glm::radians(180.0f), glm::vec3(0, 0, 1));
    const auto turned = bar_of(corners, half_turn);
    ASSERT_TRUE(turned);
    EXPECT_NEAR(turned->bow_m, -bar->bow_m, 1e-3f);
    EXPECT_EQ(bar_of(box({2, 0.2f, 0.25f}), kUp)->bow_m, 0);
}

TEST(Hang, what_stands_or_is_no_truss_is_told_apart) {
    EXPECT_FALSE(bar_of(box({0.2f, 0.2f, 2}), kUp)) << "a tower";
    EXPECT_FALSE(bar_of({}, kUp));
    EXPECT_FALSE(bar_of(std::array{glm::vec3(0)}, kUp));
    EXPECT_FALSE(is_slender(*bar_of(box({8, 6, 0.1f}), kUp))) << "a roof";
    EXPECT_FALSE(is_slender(*bar_of(box({7, 0.1f, 3}), kUp))) << "a curtain";
    EXPECT_FALSE(is_slender(*bar_of(box({3, 0.025f, 0.002f}), kUp))) << "a tape on the floor";
    EXPECT_TRUE(is_slender(*bar_of(box({3, 0.024f, 0.024f}), kUp))) << "a pipe";
}

TEST(Hang, what_is_above_is_meant_before_what_is_nearer_and_below) {
    const std::array all{Bar{{-4, 8, 0.1f}, {4, 8, 0.1f}, 0.4f}, Bar{{-4, 8, 6}, {4, 8, 6}, 0.4f}};
    EXPECT_EQ(nearest_bar(all, {0, 8, 2}), 1u);
    EXPECT_EQ(nearest_bar(all, {0, 8, 6.2f}), 1u) << "it hangs there, a hand's width too high";
    EXPECT_EQ(nearest_bar(std::array{all[0]}, {0, 8, 2}), 0u);
}

TEST(Hang, pieces_in_a_row_are_one_truss) {
    std::vector<Bar> all;
    for (const float x : {5.0f, -3.0f, 1.0f, 3.0f, -7.0f}) // from -8 to 6, with a gap of 2 m at -5
        all.push_back({{x - 1, 8, 6}, {x + 1, 8, 6}, 0.4f});
    all.push_back({{-2, 8, 6}, {0.02f, 8, 6}, 0.4f});   // overlaps a little
    all.push_back({{-8, 4, 6}, {6, 4, 6}, 0.4f});       // another truss
    all.push_back({{6, 8, 5}, {8, 8, 5}, 0.4f});        // lower
    all.push_back({{6.1f, 8, 6}, {6.1f, 12, 6}, 0.4f}); // round the corner
    const Bar whole = joined(all[2], all);
    expect_near(whole.from_m, {-4, 8, 6});
    expect_near(whole.to_m, {6, 8, 6});
    EXPECT_EQ(nearest_bar(all, {0, 4.5f, 3}), 6u);
    EXPECT_FALSE(nearest_bar({}, {0, 0, 0}));
}

TEST(Hang, one_goes_to_the_nearest_place_and_several_spread) {
    const Bar bar{{-4, 8, 6}, {4, 8, 6}, 0.4f};
    expect_near(places_under(bar, std::array{glm::vec3(1, 2, 3)})[0], {1, 8, 6});
    expect_near(places_under(bar, std::array{glm::vec3(9, 2, 3)})[0], {4, 8, 6});
    const auto four = places_under(bar, std::array<glm::vec3, 4>{});
    for (int i = 0; i < 4; ++i)
        expect_near(four[static_cast<std::size_t>(i)], {-3.0f + 2.0f * static_cast<float>(i), 8, 6});
}

// Middles of what hangs along X, with what was there, in order; none comes nearer to another than its width.
std::vector<float> beside(const std::vector<float>& wanted_m, const std::vector<float>& there_m,
                          float width_m) {
    const Bar bar{{-4, 8, 6}, {4, 8, 6}, 0.4f};
    std::vector<BarLoad> shall, there;
    for (const float x_m : wanted_m) shall.push_back({{x_m, 2, 3}, width_m});
    for (const float x_m : there_m) there.push_back({{x_m, 8, 6}, width_m});
    const auto places = places_beside(bar, shall, there);
    if (!places) return {};
    std::vector<float> made_m, all_m = there_m;
    for (const glm::vec3& place_m : *places) made_m.push_back(place_m.x);
    all_m.insert(all_m.end(), made_m.begin(), made_m.end());
    std::sort(all_m.begin(), all_m.end());
    for (std::size_t i = 1; i < all_m.size(); ++i) EXPECT_GE(all_m[i] - all_m[i - 1], width_m - 1e-3f) << i;
    EXPECT_TRUE(std::is_sorted(made_m.begin(), made_m.end()));
    return made_m;
}

TEST(Hang, what_hangs_there_is_left_room) {
    EXPECT_EQ(beside({1}, {}, 0.4f), std::vector<float>{1});
    EXPECT_EQ(beside({1}, {3}, 0.4f), std::vector<float>{1}) << "nothing is in its way";
    EXPECT_NEAR(beside({1}, {1.1f}, 0.4f).at(0), 0.68f, 1e-3f) << "on the side where it is";
    EXPECT_NEAR(beside({9}, {4}, 0.4f).at(0), 3.58f, 1e-3f);
    EXPECT_EQ(beside({0, 0, 0, 0}, {-3, -1, 1, 3}, 0.4f).size(), 4u);
    EXPECT_EQ(beside({0, 0, 0}, {0}, 2.5f).size(), 0u) << "two fit, three do not";
    EXPECT_EQ(beside({0, 0}, {0}, 2.5f).size(), 2u);
    EXPECT_EQ(beside({0, 0, 0, 0, 0, 0}, {-3.4f}, 1.15f).size(), 0u);
    EXPECT_EQ(beside({0, 0, 0, 0, 0, 0}, {-3.4f}, 1.0f).size(), 6u) << "one behind the other";
    EXPECT_EQ(beside({0}, {-3, -2, -1, 0, 1, 2, 3}, 1.0f).size(), 0u);
}

} // namespace
} // namespace ghost::scene
