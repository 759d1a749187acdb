// SPDX-License-Identifier: Apache-2.0
// Heads that follow a point, and what the show file says of trackers.
#include "light/aim.h"
#include "light/rig.h"
#include "show_file/show_toml.h"
#include "show_folder/load_show.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ghost::scene {
namespace {

glm::vec3 beam_of(const PanTilt& at) {
    const float p = glm::radians(at.pan_deg), t = glm::radians(at.tilt_deg);
    return {-std::sin(p) * std::sin(t), std::cos(p) * std::sin(t), -std::cos(t)};
}

TEST(Aim, the_beam_goes_there) {
    for (const glm::vec3& way :
         {glm::vec3(1, 0, -1), glm::vec3(-3, 2, -0.5f), glm::vec3(0, -1, 0.2f), glm::vec3(0.3f, 0.4f, 5)})
        for (const PanTilt& now : {PanTilt{0, 0}, PanTilt{-200, 100}, PanTilt{250, -30}}) {
            const PanTilt aimed = aim(way, now);
            EXPECT_LT(glm::distance(beam_of(aimed), glm::normalize(way)), 1e-5f);
            EXPECT_LE(std::abs(aimed.pan_deg), 270);
        }
}

TEST(Aim, the_nearer_way_is_taken) {
    const PanTilt front = aim({0, 1, -1}, {0, 0});
    EXPECT_NEAR(front.pan_deg, 0, 1e-4f);
    EXPECT_NEAR(front.tilt_deg, 45, 1e-4f);
    const PanTilt flipped = aim({0, 1, -1}, {170, -40});
    EXPECT_NEAR(flipped.pan_deg, 180, 1e-4f);
    EXPECT_NEAR(flipped.tilt_deg, -45, 1e-4f);
    // Past the border of atan2 the pan goes on.
    EXPECT_NEAR(aim({0.1f, -1, -1}, {170, 45}).pan_deg, 185.71f, 0.01f);
    EXPECT_NEAR(aim({-0.1f, -1, -1}, {170, 45}).pan_deg, 174.29f, 0.01f);
}

TEST(Aim, straight_down_and_nowhere_keep_the_pan) {
    EXPECT_FLOAT_EQ(aim({0, 0, -2}, {33, 20}).pan_deg, 33);
    EXPECT_FLOAT_EQ(aim({0, 0, -2}, {33, 20}).tilt_deg, 0);
    EXPECT_FLOAT_EQ(aim({0, 0, 0}, {33, 20}).tilt_deg, 20);
}

Show demo(Report& report) {
    Show show = must(load_show(std::filesystem::path(GHOST_SOURCE_DIR) / "assets/demo", false, report));
    show.motion = fixture::Motion::as_commanded;
    return show;
}

TEST(RigAim, every_head_of_the_demo_hits_the_point) {
    Report report;
    const Show show = demo(report);
    Rig rig(show);
    const glm::vec3 point_m{1.0f, 2.5f, 1.7f};
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) rig.aim_at(i, point_m);
    rig.step({}, 0.1);
    rig.step({}, 0.1);
    const auto lights = rig.lights(GoboStack{}, DistanceMaps{});
    ASSERT_EQ(lights.size(), show.fixtures.size());
    for (const shared::Light& light : lights) {
        const glm::vec3 way = glm::normalize(point_m - light.position_m);
        EXPECT_GT(glm::dot(way, light.axis_w), std::cos(glm::radians(0.05f)));
    }
    // Let go, the desk has them again.
    Rig other(show);
    other.step({}, 0.1);
    rig.aim_at(0, std::nullopt);
    rig.step({}, 0.1);
    EXPECT_EQ(rig.states()[0].pan_deg, other.states()[0].pan_deg);
    EXPECT_NE(rig.states()[1].tilt_deg, other.states()[1].tilt_deg);
}

TEST(RigAim, a_head_takes_the_time_that_it_needs) {
    Report report;
    Show show = demo(report);
    show.motion = fixture::Motion::as_the_machine;
    Rig rig(show);
    rig.step({}, 0.1);
    const float before = rig.states()[0].tilt_deg;
    rig.aim_at(0, glm::vec3(20, -20, 1));
    rig.step({}, 0.02);
    const float soon = rig.states()[0].tilt_deg;
    for (int i = 0; i < 500; ++i) rig.step({}, 0.02);
    const float late = rig.states()[0].tilt_deg;
    EXPECT_GT(std::abs(late - before), 10);
    EXPECT_LT(std::abs(soon - before), 0.2f * std::abs(late - before));
}

const char* const kShow = "[show]\nname = \"t\"\nstage = \"s.glb\"\n[[camera]]\nname = \"c\"\nposition_m = "
                          "[0, 0, 0]\ntarget_m = [0, 1, 0]\n";

TEST(TrackingToml, axes_origin_and_uses) {
    Report report;
    const auto show =
        parse_show(std::string(kShow) +
                       "[tracking]\naxes = [\"-y\", \"z\", \"x\"]\norigin_m = [10, 0, 0]\n[[tracker]]\nid = "
                       "3\ncamera = \"c\"\n"
                       "offset_m = [0, 0, 0.5]\n[[tracker]]\nname = \"Singer\"\nfixtures = [\"Spot\"]\n",
                   "show.toml", report);
    ASSERT_TRUE(show.ok());
    const Tracking& tracking = show->show.tracking;
    EXPECT_EQ(tracking.to_world({1, 2, 3}), glm::vec3(8, 3, 1));
    ASSERT_EQ(tracking.uses.size(), 2u);
    EXPECT_EQ(tracking.uses[0].id, 3);
    EXPECT_EQ(tracking.uses[0].camera, "c");
    EXPECT_EQ(tracking.uses[0].offset_m, glm::vec3(0, 0, 0.5f));
    EXPECT_EQ(tracking.uses[1].id, -1);
    EXPECT_EQ(tracking.uses[1].name, "Singer");
    const std::size_t before = report.messages.size();
    check_tracking(show->show, report);
    ASSERT_EQ(report.messages.size(), before + 1);
    EXPECT_NE(report.messages.back().what.find("fixture 'Spot'"), std::string::npos);
}

// Unless told otherwise y is up and z comes towards the audience.
TEST(TrackingToml, usual_axes) {
    EXPECT_EQ(Tracking{}.to_world({1, 1.7f, -4}), glm::vec3(1, 4, 1.7f));
}

TEST(TrackingToml, what_is_wrong_is_said_and_left_out) {
    for (const char* wrong :
         {"[tracking]\naxes = [\"x\", \"x\", \"y\"]\n", "[tracking]\naxes = [\"x\", \"y\"]\n",
          "[tracking]\naxes = [\"x\", \"y\", \"up\"]\n", "[[tracker]]\ncamera = \"c\"\n",
          "[[tracker]]\nid = 70000\ncamera = \"c\"\n", "[[tracker]]\nid = 1\n", "[tracking]\nport = 1\n"}) {
        Report fine, report;
        (void)parse_show(kShow, "show.toml", fine);
        const auto show = parse_show(std::string(kShow) + wrong, "show.toml", report);
        ASSERT_TRUE(show.ok());
        EXPECT_GT(report.messages.size(), fine.messages.size()) << wrong;
        EXPECT_EQ(show->show.tracking.axes, glm::ivec3(0, 2, 1));
    }
}

constexpr const char* kWithHouse = R"(
[show]
name = "x"
stage = "x.glb"
[[camera]]
name = "house"
position_m = [0, -9, 2]
target_m = [0, 0, 1]
)";

TEST(TrackingInShow, objects_go_with_a_tracker) {
    Report report;
    const auto parsed = parse_show(std::string(kWithHouse) + R"(
[[tracker]]
id = 4
objects = ["riser_*", "piano"]
home_m = [1, 2, 0]
[[tracker]]
id = 5
camera = "house"
home_m = [0, 0, 0]
[[tracker]]
id = 6
)",
                                   "show.toml", report);
    ASSERT_TRUE(parsed.ok());
    ASSERT_EQ(parsed->show.tracking.uses.size(), 3u);
    EXPECT_EQ(parsed->show.tracking.uses[0].objects, (std::vector<std::string>{"riser_*", "piano"}));
    EXPECT_EQ(parsed->show.tracking.uses[0].home_m, glm::vec3(1, 2, 0));
    ASSERT_EQ(report.messages.size(), 2u);
    EXPECT_NE(report.messages[0].what.find("home_m"), std::string::npos) << report.messages[0].what;
    EXPECT_NE(report.messages[1].what.find("what follows it"), std::string::npos) << report.messages[1].what;
}

TEST(CuesInShow, have_a_name_and_somewhere_to_go) {
    Report report;
    auto parsed = parse_show(std::string(kWithHouse) + R"(
[[cue]]
name = "Walk-in"
at_s = 0
[[cue]]
name = "Solo"
at_s = 61.5
camera = "hose"
flight_s = 2
[[cue]]
name = "Solo"
at_s = 9
[[cue]]
name = "Nothing"
[[cue]]
camera = "house"
)",
                             "show.toml", report);
    ASSERT_TRUE(parsed.ok());
    const std::vector<Cue>& cues = parsed->show.cues;
    ASSERT_EQ(cues.size(), 3u);
    EXPECT_EQ(cues[0].at_s, 0.0);
    EXPECT_EQ(cues[1].at_s, 61.5);
    EXPECT_FLOAT_EQ(cues[1].flight_s, 2);
    EXPECT_EQ(cues[2].name, "Nothing");
    ASSERT_EQ(report.messages.size(), 3u);
    check_cues(parsed->show, report);
    ASSERT_EQ(report.messages.size(), 4u);
    EXPECT_NE(report.messages[3].what.find("did you mean 'house'"), std::string::npos)
        << report.messages[3].what;
}

} // namespace
} // namespace ghost::scene
