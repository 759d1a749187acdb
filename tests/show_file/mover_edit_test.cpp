// SPDX-License-Identifier: Apache-2.0
// A truss on hoists written into a show, its channels changed, and all else byte for byte as it was.
#include "show_file/mover_edit.h"

#include "show_file/show_toml.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

const std::string kShowHead = "[show]\nstage = \"s.glb\" # mine\n[[camera]]\nposition_m = [0, -9, 2]\n"
                              "target_m = [0, 0, 2]\n";

Mover truss() {
    Mover mover;
    mover.name = "Front \"truss\"";
    mover.kind = MoverKind::hoists;
    mover.objects = {"Front 1", "Front 2"};
    mover.fixtures = {"Spot 1"};
    for (const float x_m : {-3.0f, 3.0f}) {
        MoverAxis& hoist = mover.axes.emplace_back();
        hoist.name = x_m < 0 ? "left" : "right";
        hoist.point_m = {x_m, 1, 6.5f};
        hoist.to = -5;
        hoist.speed = hoist.acceleration = 0.25f;
    }
    return mover;
}

std::vector<Mover> movers_in(const std::string& text) {
    Report report;
    auto parsed = must(parse_show(text, "show.toml", report));
    EXPECT_FALSE(report.lost_anything());
    return parsed.show.movers;
}

TEST(MoverEdit, what_is_added_is_read_as_it_was_meant) {
    const std::string text = must(add_mover(kShowHead, truss()));
    EXPECT_TRUE(text.starts_with(kShowHead));
    const std::vector<Mover> movers = movers_in(text);
    ASSERT_EQ(movers.size(), 1u);
    EXPECT_EQ(movers[0].name, "Front \"truss\"");
    EXPECT_EQ(movers[0].objects, truss().objects);
    EXPECT_EQ(movers[0].fixtures, truss().fixtures);
    ASSERT_EQ(movers[0].axes.size(), 2u);
    EXPECT_EQ(movers[0].axes[1].name, "right");
    EXPECT_EQ(movers[0].axes[1].point_m, glm::vec3(3, 1, 6.5f));
    EXPECT_EQ(movers[0].axes[1].low, -5);
    EXPECT_EQ(movers[0].axes[1].speed, 0.25f);
    EXPECT_TRUE(movers[0].axes[1].levels.empty());
}

TEST(MoverEdit, channels_of_all_axes_follow_the_first) {
    const std::string before = must(add_mover(kShowHead, truss()));
    const std::string text = must(set_mover_address(before, truss(), {4, 101}, 24));
    const std::vector<Mover> movers = movers_in(text);
    ASSERT_EQ(movers[0].axes[1].levels.size(), 3u);
    EXPECT_EQ(movers[0].axes[0].levels[0].universe, 4);
    EXPECT_EQ(movers[0].axes[0].levels[0].channel, 101);
    EXPECT_EQ(movers[0].axes[1].levels[0].channel, 104);
    EXPECT_EQ(movers_in(must(set_mover_address(text, truss(), {1, 1}, 8)))[0].axes[1].levels.size(), 1u);
}

TEST(MoverEdit, what_hangs_elsewhere_goes_with_that_mover_and_with_no_other) {
    Mover back = truss();
    back.name = "Back";
    back.fixtures = {"Wash *"};
    const std::string before = must(add_mover(must(add_mover(kShowHead, truss())), back));
    const std::string to_back = must(hang_on_mover(before, "Back", {"Spot 1", "Wash 3"}));
    EXPECT_EQ(movers_in(to_back)[0].fixtures, std::vector<std::string>{});
    EXPECT_EQ(movers_in(to_back)[1].fixtures, (std::vector<std::string>{"Wash *", "Spot 1"}));
    const std::string free = must(hang_on_mover(to_back, "", {"Spot 1", "Wash 3"}));
    EXPECT_EQ(movers_in(free)[1].fixtures, std::vector<std::string>{"Wash *"}) << "a pattern stays";
    EXPECT_EQ(must(hang_on_mover(before, "Back", {"Wash 1"})), before);
    EXPECT_EQ(must(hang_on_mover(kShowHead, "", {"Spot 1"})), kShowHead);
}

TEST(MoverEdit, what_cannot_be_is_said_and_changes_nothing) {
    const std::string text = must(add_mover(kShowHead, truss()));
    const auto past = set_mover_address(text, truss(), {1, 510}, 16);
    ASSERT_FALSE(past.ok());
    EXPECT_NE(past.error().what.find("would end at channel 513"), std::string::npos);
    Mover other = truss();
    other.name = "Back";
    EXPECT_FALSE(set_mover_address(text, other, {1, 1}, 16).ok());
    Mover longer = truss();
    longer.axes.emplace_back();
    EXPECT_FALSE(set_mover_address(text, longer, {1, 1}, 16).ok()) << "an axis that could not be read";
}

} // namespace
} // namespace ghost::scene
