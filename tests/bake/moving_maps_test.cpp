// SPDX-License-Identifier: Apache-2.0
// Distance maps of what moves all the time: as those made from nothing, traced only where a beam looks.
#include "bake/moving_maps.h"
#include "passes/distance_maps.h"
#include "shared/brdf.h"
#include "shared/octahedral.h"
#include "support/test_stage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ghost::bake {
namespace {

constexpr int kMovingSize = 512;

glm::mat4 moved_to(const glm::vec3& place_m) {
    return glm::translate(glm::mat4(1.0f), place_m);
}

// A room of 8 x 6 x 4 m with a crate.
scene::Stage room() {
    scene::Stage stage;
    const int grey = add_material(stage, {0.5f, 0.5f, 0.5f});
    place(stage, add_mesh(stage, box_mesh({4, 3, 2}), grey), moved_to({0, 0, 2}));
    place(stage, add_mesh(stage, box_mesh({0.3f, 0.3f, 0.3f}), grey), moved_to({2, 0, 1}));
    return stage;
}

shared::Light spot(const glm::vec3& axis, float half_deg) {
    shared::Light light{};
    light.axis_w = glm::normalize(axis);
    light.tan_field = std::tan(glm::radians(half_deg));
    light.cut_radius = 1;
    light.intensity_cd = glm::vec3(100);
    light.map = 1;
    return light;
}

shared::Light all_round() {
    shared::Light light = spot({0, 0, -1}, 20);
    light.panel_m = 1;
    return light;
}

TEST(MovingMaps, after_a_way_they_are_those_made_from_nothing) {
    const scene::Stage stage = room();
    MovingMaps moving(stage, kMovingSize, {{0, 0, 3}});
    EXPECT_TRUE(moving.update({}).maps.empty());
    for (int step = 0; step <= 4; ++step) {
        const auto along = static_cast<float>(step);
        moving.hang(0, {0.3f * along, 0, 3});
        moving.move(1, moved_to({2 - 0.7f * along, 0.2f * along, 1}));
        EXPECT_EQ(moving.update({all_round()}).maps.size(), 1u);
    }
    // The lamp rests; the crate goes on and is hidden.
    moving.move(1, moved_to({-2, 1, 1.5f}));
    const MovingMaps::News news = moving.update({all_round()});
    EXPECT_TRUE(news.is_seen_by_resting);
    EXPECT_LT(news.rays, kMovingSize * kMovingSize / 3u) << "only where it was and where it is";
    scene::Stage there = room();
    there.instances[1].world = moved_to({-2, 1, 1.5f});
    MovingMaps fresh(there, kMovingSize, {{1.2f, 0, 3}});
    fresh.update({all_round()});
    EXPECT_TRUE(moving.distance(0) == fresh.distance(0));
    moving.show(1, false);
    moving.update({all_round()});
    there.instances[1].shown = false;
    MovingMaps empty(there, kMovingSize, {{1.2f, 0, 3}});
    empty.update({all_round()});
    EXPECT_TRUE(moving.distance(0) == empty.distance(0));
    EXPECT_FALSE(moving.distance(0) == fresh.distance(0));
}

TEST(MovingMaps, a_beam_asks_for_what_it_sees_and_no_more) {
    constexpr int kFine = 1024; // blocks of about 6 degrees
    const scene::Stage stage = room();
    const shared::Light down = spot({0, 0, -1}, 3);
    MovingMaps moving(stage, kFine, {{0, 0, 3}});
    shared::Light dark = down;
    dark.intensity_cd = glm::vec3(0);
    EXPECT_EQ(moving.update({dark}).rays, 0u);
    moving.move(1, moved_to({3.4f, 0, 2.6f}));
    const MovingMaps::News first = moving.update({down});
    EXPECT_FALSE(first.is_seen_by_resting);
    EXPECT_GT(first.rays, 0u);
    EXPECT_LT(first.rays, kFine * kFine / 10u);
    EXPECT_EQ(moving.update({down}).rays, 0u) << "nothing is new";
    moving.move(1, moved_to({3.3f, 0, 2.2f}));
    EXPECT_EQ(moving.update({down}).rays, 0u) << "far beside the beam";
    moving.move(1, moved_to({0, 0, 1}));
    EXPECT_TRUE(moving.update({down}).is_seen_by_resting);
    // It turns to where it has not looked yet.
    const MovingMaps::News turned = moving.update({spot({1, 0, -1}, 3)});
    EXPECT_GT(turned.rays, 0u);
    EXPECT_FALSE(turned.is_seen_by_resting);
}

// Of a lens that is ahead of the map's place, as a moving head's, beside it, as a bar's cell, or behind it.
TEST(MovingMaps, all_that_a_beam_lights_a_metre_away_is_there) {
    const scene::Stage stage = room();
    for (const glm::vec3& lens_m :
         {glm::vec3(0, 0, -0.25f), glm::vec3(0.4f, 0, 0), glm::vec3(0.2f, 0.1f, 0.3f)})
        for (const float half_deg : {3.0f, 12.0f, 35.0f}) {
            shared::Light light = spot({0, 0, -1}, half_deg);
            light.axis_u = {1, 0, 0};
            light.axis_v = {0, -1, 0};
            light.disc_radius_m = 0.07f;
            light.lens_m = light.disc_radius_m / light.tan_field;
            light.off_map_m = lens_m - light.lens_m * light.axis_w;
            MovingMaps moving(stage, kMovingSize, {{0, 0, 3}});
            moving.update({light});
            for (float from_lens_m = 1; from_lens_m < 12; from_lens_m *= 1.3f)
                for (int around = 0; around < 16; ++around) {
                    const float angle = 2 * shared::kPi * static_cast<float>(around) / 16;
                    const float radius_m =
                        (light.lens_m + from_lens_m) * light.tan_field + light.disc_radius_m;
                    const glm::vec3 way = lens_m + glm::vec3(radius_m * std::cos(angle),
                                                             radius_m * std::sin(angle), -from_lens_m);
                    const glm::ivec2 texel(shared::octahedral_from(way) * static_cast<float>(kMovingSize));
                    const auto index = static_cast<std::size_t>(texel.y * kMovingSize + texel.x);
                    ASSERT_NE(moving.distance(0)[index], scene::kNoSurface)
                        << half_deg << " degrees, " << from_lens_m << " m, " << around;
                }
        }
}

TEST(MovingMaps, a_head_whose_lens_is_ahead_asks_for_little) {
    constexpr int kFine = 1024;
    const scene::Stage stage = room();
    shared::Light head = spot({0, 0, -1}, 6.5f); // as a Vari-Lite VL2500 Wash
    head.cut_radius = 1.46f;
    head.lens_m = 0.887f;
    head.disc_radius_m = 0.1f;
    head.off_map_m = {0, 0, 0.632f};
    MovingMaps moving(stage, kFine, {{0, 0, 3}});
    EXPECT_LT(moving.update({head}).rays, kFine * kFine / 9u);
}

TEST(MovingMaps, a_matrix_that_is_no_place_takes_the_object_away) {
    const scene::Stage stage = room();
    MovingMaps moving(stage, kMovingSize, {{0, 0, 3}});
    moving.move(1, glm::mat4(std::nanf("")));
    moving.update({all_round()});
    for (const std::uint16_t distance : moving.distance(0)) ASSERT_LT(distance, scene::kNoSurface);
}

} // namespace
} // namespace ghost::bake
