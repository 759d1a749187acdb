// SPDX-License-Identifier: Apache-2.0
// Where movers put their load, how fast, and what a show file may say of them.
#include "light/rig.h"
#include "show/mover_motion.h"
#include "show/mover_pose.h"
#include "show_file/show_toml.h"
#include "show_folder/load_show.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace ghost::scene {
namespace {

using fixture::Motion;

constexpr double kTight = 1e-9;

Mover mover_of(MoverKind kind, std::size_t axes, float low = -100, float high = 100) {
    Mover mover;
    mover.name = "it";
    mover.kind = kind;
    for (std::size_t k = 0; k < axes; ++k) {
        MoverAxis& axis = mover.axes.emplace_back();
        axis.from = axis.low = low;
        axis.to = axis.high = high;
    }
    return mover;
}

glm::dvec3 at(const Mover& mover, const std::vector<double>& values, const glm::dvec3& drawn_m) {
    return glm::dvec3(pose_of(mover, values) * glm::dvec4(drawn_m, 1));
}

void expect_at(const glm::dvec3& is_m, const glm::dvec3& wanted_m, double within = kTight) {
    EXPECT_LT(glm::distance(is_m, wanted_m), within)
        << is_m.x << ", " << is_m.y << ", " << is_m.z << " is not " << wanted_m.x << ", " << wanted_m.y
        << ", " << wanted_m.z;
}

TEST(MoverPose, two_hoists_tilt_a_truss_about_its_middle) {
    Mover truss = mover_of(MoverKind::hoists, 2);
    truss.axes[0].point_m = {-3, 0, 5};
    truss.axes[1].point_m = {3, 0, 5};
    expect_at(at(truss, {-2, -2}, {1, 0.5, 4}), {1, 0.5, 2});
    // 1 m over 6 m: both hooks are at their heights, and as far apart as before.
    const glm::dvec3 left = at(truss, {0, 1}, {-3, 0, 5}), right = at(truss, {0, 1}, {3, 0, 5});
    EXPECT_NEAR(left.z, 5, kTight);
    EXPECT_NEAR(right.z, 6, kTight);
    EXPECT_NEAR(glm::distance(left, right), 6, kTight);
    EXPECT_NEAR(0.5 * (left.x + right.x), 0, kTight);
    // What lies across the line of the hooks does not turn.
    expect_at(at(truss, {0, 1}, {0, 2, 5}), {0, 2, 5.5});
    // Higher than it is long: it stands steep, and is rigid all the same.
    const glm::dmat4 steep = pose_of(truss, std::vector<double>{0, 90});
    EXPECT_NEAR(glm::determinant(glm::dmat3(steep)), 1, kTight);
}

TEST(MoverPose, three_hoists_lie_in_a_plane_and_four_in_the_best_one) {
    Mover truss = mover_of(MoverKind::hoists, 3);
    truss.axes[0].point_m = {0, 0, 6};
    truss.axes[1].point_m = {4, 0, 6};
    truss.axes[2].point_m = {0, 4, 6};
    for (int k = 0; k < 3; ++k) {
        std::vector<double> values{0.0, 0.3, -0.2};
        const glm::dvec3 hook(truss.axes[static_cast<std::size_t>(k)].point_m);
        EXPECT_NEAR(at(truss, values, hook).z, 6 + values[static_cast<std::size_t>(k)], kTight);
    }
    // A square whose corners are twisted: it cannot follow and stays level.
    Mover square = mover_of(MoverKind::hoists, 4);
    const glm::vec3 corners[] = {{-1, -1, 6}, {1, -1, 6}, {1, 1, 6}, {-1, 1, 6}};
    for (std::size_t k = 0; k < 4; ++k) square.axes[k].point_m = corners[k];
    expect_at(at(square, {0.1, -0.1, 0.1, -0.1}, {1, 1, 6}), {1, 1, 6});
}

TEST(MoverPose, one_hoist_lifts_and_hoists_at_one_point_do_not_tilt) {
    Mover winch = mover_of(MoverKind::hoists, 1);
    winch.axes[0].point_m = {1, 1, 8};
    expect_at(at(winch, {-3}, {1, 1, 7}), {1, 1, 4});
    Mover both = mover_of(MoverKind::hoists, 2);
    expect_at(at(both, {0, 2}, {1, 0, 0}), {1, 0, 1});
}

TEST(MoverPose, a_revolve_turns_about_its_axis_and_a_lift_goes_along_its_way) {
    Mover revolve = mover_of(MoverKind::revolve, 1);
    revolve.centre_m = {1, 0, 0};
    expect_at(at(revolve, {90}, {3, 0, 2}), {1, 2, 2});
    Mover ramp = mover_of(MoverKind::linear, 1);
    ramp.direction = glm::normalize(glm::vec3(3, 0, 4));
    expect_at(at(ramp, {5}, {0, 0, 0}), {3, 0, 4}, 1e-6);
}

TEST(MoverPose, both_axles_of_a_wagon_stay_on_its_path) {
    Mover wagon = mover_of(MoverKind::path, 1);
    wagon.path_m = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
    EXPECT_NEAR(length_m(wagon.path_m), 20, kTight);
    // Without a wheelbase it goes sideways.
    expect_at(at(wagon, {15}, {0.5, 0, 1}), {10.5, 5, 1});
    wagon.wheelbase_m = 2;
    expect_at(at(wagon, {0}, {1, 0.3, 1}), {1, 0.3, 1});
    expect_at(at(wagon, {4}, {1, 0, 1}), {5, 0, 1});
    expect_at(at(wagon, {15}, {1, 0, 0}), {10, 6, 0}); // turned by 90 degrees
    expect_at(at(wagon, {10}, {1, 0, 0}) * 1.0 + at(wagon, {10}, {-1, 0, 0}), glm::dvec3(19, 1, 0), 0.6);
    const glm::dvec3 middle = at(wagon, {10}, {0, 0, 0});
    expect_at(middle, {9.5, 0.5, 0}); // in the corner, between its axles
}

TEST(MoverPose, a_flown_piece_turns_about_its_centre_in_the_order_of_fixtures) {
    Mover flown = mover_of(MoverKind::flown, 3);
    flown.axes[0].degree = Degree::y;
    flown.axes[1].degree = Degree::turn_z;
    flown.axes[2].degree = Degree::turn_x;
    flown.centre_m = {0, 0, 4};
    // Turned about X first: up becomes -Y; about Z then: -Y becomes X.
    expect_at(at(flown, {2, 90, 90}, {0, 0, 5}), {1, 2, 4});
}

std::vector<Mover> read(const std::string& text, Report& report) {
    const auto parsed = must(parse_show("[show]\nstage = \"s.glb\"\n[[camera]]\nposition_m = [0, -9, 2]\n"
                                        "target_m = [0, 0, 2]\n" +
                                            text,
                                        "a/show.toml", report));
    Show show = parsed.show;
    check_movers(show, report);
    return show.movers;
}

bool says(const Report& report, const std::string& part) {
    for (const Message& message : report.messages)
        if (message.what.find(part) != std::string::npos &&
            message.where.find("show.toml:") != std::string::npos)
            return true;
    return false;
}

std::string lift(const std::string& name, const std::string& more, const std::string& axis) {
    return "[[mover]]\nname = \"" + name + "\"\nkind = \"linear\"\nobjects = [\"x\"]\n" + more +
           "\n[[mover.axis]]\n" + axis + "\n";
}

constexpr const char* kRange = "range_m = [0, 10]";

TEST(MoverMotion, channels_of_8_16_and_24_bits_span_the_range) {
    Report report;
    const std::vector<Mover> movers =
        read(lift("a", "", "range_m = [0, 10]\nuniverse = 2\naddress = 1\nbits = 8") +
                 lift("b", "", "range_m = [0, -6]\nuniverse = 2\naddress = 2") +
                 lift("c", "", "range_m = [1, 3]\nuniverse = 2\naddress = 4\nbits = 24"),
             report);
    EXPECT_TRUE(report.messages.empty() || !report.lost_anything());
    ASSERT_EQ(movers.size(), 3u);
    MoverMotion motion(movers);
    dmx::Universes universes;
    motion.step(universes, {}, 0.1, Motion::as_commanded);
    EXPECT_EQ(motion.values(0)[0], 0.0f) << "nobody has spoken";
    auto levels = std::make_shared<dmx::Levels>();
    const std::uint8_t bytes[] = {51, 0x80, 0x00, 0x40, 0x00, 0x00};
    for (std::size_t k = 0; k < 6; ++k) (*levels)[k] = bytes[k];
    universes.at(2).levels = levels;
    motion.step(universes, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 2.0f);
    EXPECT_FLOAT_EQ(motion.values(1)[0], -6.0f * 32768.0f / 65535.0f);
    EXPECT_FLOAT_EQ(motion.values(2)[0], 1.0f + 2.0f * 4194304.0f / 16777215.0f);
}

TEST(MoverMotion, the_machine_keeps_its_limits_and_its_end_stops) {
    Report report;
    const std::vector<Mover> movers = read(
        lift("a", "", "range_m = [0, 10]\nlimits_m = [1, 9]\nspeed_m_s = 2\nacceleration_m_s2 = 1"), report);
    MoverMotion motion(movers);
    motion.step({}, {}, 0.1, Motion::as_the_machine);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 1.0f) << "the lower end stop";
    motion.drive(0, {12});
    for (int k = 0; k < 20; ++k) motion.step({}, {}, 0.1, Motion::as_the_machine);
    EXPECT_NEAR(motion.values(0)[0], 3.0f, 1e-4) << "2 s of speeding up at 1 m/s2";
    for (int k = 0; k < 10; ++k) motion.step({}, {}, 0.1, Motion::as_the_machine);
    EXPECT_NEAR(motion.values(0)[0], 5.0f, 1e-4) << "1 s at 2 m/s";
    for (int k = 0; k < 50; ++k) motion.step({}, {}, 0.1, Motion::as_the_machine);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 9.0f) << "the upper end stop";
    EXPECT_DOUBLE_EQ(motion.asked(0, 0), 12.0);
    motion.drive(0, {3});
    motion.step({}, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 3.0f);
    motion.drive(0, {std::numeric_limits<float>::quiet_NaN()});
    motion.step({}, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 3.0f) << "no number: the last good place is held";
    motion.drive(0, {1, 2});
    motion.step({}, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 3.0f) << "of another number of axes";
}

TEST(MoverMotion, what_a_hand_let_go_goes_where_it_would_be_without_it) {
    Report report;
    const std::vector<Mover> movers =
        read(lift("a", "", "range_m = [0, 10]\nuniverse = 2\naddress = 1\nbits = 8") +
                 lift("b", "", "range_m = [0, 10]\nspeed_m_s = 1\nacceleration_m_s2 = 1"),
             report);
    MoverMotion motion(movers);
    dmx::Universes universes;
    auto levels = std::make_shared<dmx::Levels>();
    (*levels)[0] = 51;
    universes.at(2).levels = levels;
    motion.drive({{0, {7}}, {1, {12}}});
    motion.step(universes, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 7.0f);
    EXPECT_FLOAT_EQ(motion.goals(1)[0], 10.0f) << "its end stop";
    EXPECT_FLOAT_EQ(motion.goals_without_hand(0)[0], 2.0f);
    EXPECT_FLOAT_EQ(motion.goals_without_hand(1)[0], 0.0f);
    motion.drive(std::map<std::size_t, std::vector<float>>{});
    motion.step(universes, {}, 0.1, Motion::as_commanded);
    EXPECT_FLOAT_EQ(motion.values(0)[0], 2.0f);
    EXPECT_FLOAT_EQ(motion.values(1)[0], 0.0f) << "nobody has spoken: where it is drawn";
}

TEST(MoverMotion, keys_go_by_the_time_of_the_recording) {
    Report report;
    const std::vector<Mover> movers = read(
        lift("a", "[[mover.key]]\nat_s = 2\nvalues = [1]\n[[mover.key]]\nat_s = 6\nvalues = [5]", kRange),
        report);
    ASSERT_EQ(movers.size(), 1u);
    MoverMotion motion(movers);
    const auto value_at = [&](std::optional<double> at_s) {
        motion.step({}, at_s, 0.1, Motion::as_commanded);
        return motion.values(0)[0];
    };
    EXPECT_FLOAT_EQ(value_at(std::nullopt), 0.0f);
    EXPECT_FLOAT_EQ(value_at(0), 1.0f);
    EXPECT_FLOAT_EQ(value_at(3), 2.0f);
    EXPECT_FLOAT_EQ(value_at(99), 5.0f);
}

TEST(MoverMotion, what_hangs_on_a_mover_goes_with_it) {
    Report report;
    const std::vector<Mover> movers = read(
        lift("on it", "parent = \"disc\"", kRange) +
            "[[mover]]\nname = \"disc\"\nkind = \"revolve\"\ncentre_m = [0, 0, 0]\nobjects = [\"disc\"]\n"
            "[[mover.axis]]\nrange_deg = [0, 360]\n",
        report);
    ASSERT_EQ(movers.size(), 2u);
    EXPECT_EQ(parents_first(movers), (std::vector<std::size_t>{1, 0}));
    MoverMotion motion(movers);
    motion.drive(0, {2});
    motion.drive(1, {90});
    motion.step({}, {}, 0.1, Motion::as_commanded);
    expect_at(glm::dvec3(motion.moved(std::size_t{0}) * glm::vec4(1, 0, 0, 1)), {0, 1, 2}, 1e-6);
}

TEST(MoverMotion, trackers_that_jump_or_go_nowhere_are_held_at_the_last_place) {
    Report report;
    const std::vector<Mover> movers = read(lift("a", "tracker = 3\nhome_m = [0, 0, 1]", kRange), report);
    ASSERT_EQ(movers.size(), 1u);
    MoverMotion motion(movers);
    const auto value_at = [&](const glm::vec3& place_m) {
        motion.follow(0, place_m);
        motion.step({}, {}, 0.1, Motion::as_commanded);
        return motion.values(0)[0];
    };
    EXPECT_FLOAT_EQ(value_at({5, 5, 3}), 2.0f);
    EXPECT_TRUE(motion.take_messages().empty());
    EXPECT_FLOAT_EQ(value_at({0, std::nanf(""), 3}), 2.0f);
    EXPECT_FLOAT_EQ(value_at({0, 0, 10'000}), 2.0f);
    const std::vector<Message> far = motion.take_messages();
    ASSERT_EQ(far.size(), 1u) << "once";
    EXPECT_TRUE(far[0].what.starts_with("tracker 3 of mover 'a' tells a place that is no number"))
        << far[0].what;
    EXPECT_FLOAT_EQ(value_at({5, 5, 8}), 2.0f) << "a jump";
    EXPECT_EQ(motion.take_messages().size(), 1u);
    EXPECT_FLOAT_EQ(value_at({5, 5, 3.5f}), 2.5f) << "back again";
    for (int k = 0; k < 20; ++k) value_at({5, 5, 8});
    EXPECT_FLOAT_EQ(motion.values(0)[0], 7.0f) << "it stays there";
    motion.step({}, {}, 60, Motion::as_commanded); // it vanishes
    EXPECT_FLOAT_EQ(motion.values(0)[0], 7.0f);
    EXPECT_EQ(motion.take_messages().size(), 1u) << "it is not heard any more";
}

TEST(MoverFile, what_is_wrong_is_said_with_its_line_and_the_rest_is_kept) {
    Report report;
    const std::vector<Mover> movers = read(
        lift("a", "parent = \"b\"", kRange) + lift("b", "parent = \"c\"", kRange) +
            lift("c", "parent = \"a\"", kRange) +
            lift("d", "parent = \"nobody\"\nfixtures = [\"spot*\"]", "range_m = [4, 4]") +
            "[[mover]]\nname = \"empty\"\nkind = \"hoists\"\n[[mover.axis]]\npoint_m = [0, 0, 5]\nrange_m = "
            "[0, 1]\n" +
            lift("e", "tracker = 1", "range_m = [0, 5]\nlimits_m = [5, 0]\nuniverse = 1\naddress = 512") +
            lift("f", "", "range_m = [0, nan]\nfixture = \"hoist 1\"\nattribute = \"XYZ_Z\"") +
            "[[mover]]\nname = \"g\"\nkind = \"wagon\"\n" + lift("a", "", kRange) +
            "[[mover]]\nname = \"far\"\nkind = \"revolve\"\nobjects = [\"x\"]\ncentre_m = [0, 0, "
            "10000]\n[[mover.axis]]\nrange_deg = [0, 90]\n",
        report);
    EXPECT_TRUE(says(report, "'a' drives itself: 'a' on 'b' on 'c' on itself"));
    EXPECT_TRUE(says(report, "hangs on 'nobody', which is no mover"));
    EXPECT_TRUE(says(report, "carries fixture 'spot*', which the show does not have"));
    EXPECT_TRUE(says(report, "is empty [4, 4]"));
    EXPECT_TRUE(says(report, "'empty' has no truss"));
    EXPECT_TRUE(says(report, "is reversed [5, 0]"));
    EXPECT_TRUE(says(report, "has no room for 'linear'"));
    EXPECT_TRUE(says(report, "names fixture 'hoist 1'"));
    EXPECT_TRUE(says(report, "is 'wagon', expected hoists, linear"));
    EXPECT_TRUE(says(report, "'a' is that of another mover"));
    EXPECT_TRUE(says(report, "where the tracker is"));
    EXPECT_TRUE(says(report, "[[mover]] 'far' centre_m"));
    EXPECT_EQ(movers.size(), 8u);
    MoverMotion motion(movers);
    motion.step({}, 1.0, 0.1, Motion::as_the_machine);
    for (std::size_t k = 0; k < movers.size(); ++k)
        for (int column = 0; column < 4; ++column)
            EXPECT_TRUE(std::isfinite(glm::dot(motion.moved(k)[column], glm::vec4(1)))) << k;
}

std::size_t count(const Report& report, const std::string& part) {
    return static_cast<std::size_t>(
        std::count_if(report.messages.begin(), report.messages.end(),
                      [&](const Message& message) { return message.what.find(part) != std::string::npos; }));
}

// A show with two movers, of names of no use otherwise.
Show with_movers() {
    Show show;
    show.movers = {mover_of(MoverKind::linear, 1), mover_of(MoverKind::linear, 1)};
    show.movers[0].name = "first";
    show.movers[1].name = "second";
    return show;
}

TEST(MoverFile, a_channel_past_512_is_in_the_next_universe) {
    auto type = std::make_shared<fixture::Type>();
    fixture::Mode& mode = type->modes.emplace_back();
    fixture::Channel& channel = mode.channels.emplace_back();
    channel.dmx_break = 1;
    channel.offsets = {1, 2};
    channel.functions.emplace_back().attribute = "XYZ_Z";
    Show show = with_movers();
    PatchedFixture& hoist = show.fixtures.emplace_back();
    hoist.name = "hoist";
    hoist.type = type;
    hoist.universe = 3;
    hoist.address = 511;
    MoverAxis& axis = show.movers[0].axes[0];
    axis.fixture = "hoist";
    axis.attribute = "XYZ_Z";
    Report report;
    check_movers(show, report);
    const std::vector<fixture::Address>& levels = show.movers[0].axes[0].levels;
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0].universe, 3);
    EXPECT_EQ(levels[0].channel, 512);
    EXPECT_EQ(levels[1].universe, 4);
    EXPECT_EQ(levels[1].channel, 1);
}

TEST(MoverFile, what_two_movers_carry_is_said_once) {
    Show show = with_movers();
    for (const char* name : {"spot 1", "spot 2"}) show.fixtures.emplace_back().name = name;
    show.movers[0].fixtures = {"spot*"};
    show.movers[1].fixtures = {"spot*", "spot ?", "spot 2"};
    show.movers[0].objects = {"truss"};
    show.movers[1].objects = {"truss*", "truss", "tr*", "lost"};
    show.tracking.uses.push_back({.id = 1, .objects = {"tru*", "mic"}});
    Stage stage;
    for (const char* name : {"truss", "truss", "mic"}) stage.instances.push_back({.name = name, .mesh = -1});
    Report report;
    check_movers(show, report);
    EXPECT_EQ(count(report, "carries fixture 'spot 1', which 'first' carries already"), 1u);
    EXPECT_EQ(count(report, "carries already"), 2u);
    Report of_stage;
    check_moved_objects(show, stage, of_stage);
    EXPECT_EQ(count(of_stage,
                    "'second' carries object 'truss', which 'first' carries already; it goes with that one"),
              1u);
    EXPECT_EQ(count(of_stage, "carries object 'lost', which the stage does not have"), 1u);
    EXPECT_EQ(count(of_stage, "object 'truss' goes with mover 'first'; the tracker does not move it"), 1u);
    EXPECT_EQ(of_stage.messages.size(), 3u);
    EXPECT_EQ(movers_of_instances(show, stage), (std::vector<int>{0, 0, kNoMover}));
}

TEST(MoverFile, thousands_of_wrong_names_are_counted) {
    Show show = with_movers();
    for (int k = 0; k < 2000; ++k) {
        show.fixtures.emplace_back().name = "spot " + std::to_string(k);
        show.movers[0].fixtures.push_back("wash " + std::to_string(k));
        show.movers[1].fixtures.push_back("spot*");
    }
    show.movers[0].fixtures.push_back("spot*");
    Report report;
    check_movers(show, report);
    EXPECT_EQ(report.messages.size(), 201u);
    EXPECT_EQ(report.messages.back().what,
              "3800 more names of [[mover]] entries are wrong; they are not listed");
}

TEST(MoverFile, patterns_that_nearly_match_have_an_end_which_is_said) {
    Show show = with_movers();
    Stage stage;
    for (int k = 0; k < 200; ++k) {
        const std::string name = std::string(4090, 'a') + std::to_string(k);
        show.fixtures.emplace_back().name = name;
        stage.instances.push_back({.name = name, .mesh = -1});
    }
    const std::string nearly = "*" + std::string(998, 'a') + "b";
    show.movers[0].fixtures = {"*aa7", nearly, nearly, nearly};
    show.movers[1].fixtures = {"*aa8"};
    show.movers[0].objects = {"*aa7", nearly, nearly, nearly};
    show.movers[1].objects = {"*aa8"};
    show.tracking.uses.push_back({.id = 1, .objects = {nearly, nearly, nearly}});
    Report report;
    check_movers(show, report);
    EXPECT_EQ(show.fixtures[7].mover, 0);
    EXPECT_EQ(count(report, "has more patterns with * and ? than can be compared"), 1u);
    Report of_stage;
    check_moved_objects(show, stage, of_stage);
    EXPECT_EQ(count(of_stage, "has more patterns with * and ? than can be compared"), 1u);
    const std::vector<int> movers = movers_of_instances(show, stage);
    EXPECT_EQ(movers[7], 0);
    EXPECT_EQ(movers[8], kNoMover) << "as is said of those after it";
}

TEST(MoverFile, names_are_kept_once_and_end_at_the_limit_of_all) {
    std::string names = "objects = [";
    for (int k = 0; k < 9000; ++k) names += "\"x" + std::to_string(k) + "\", ";
    names += "\"x0\"]";
    const auto table = [&](const char* name) {
        return "[[mover]]\nname = \"" + std::string(name) + "\"\nkind = \"linear\"\n" + names +
               "\n[[mover.axis]]\nrange_m = [0, 1]\n";
    };
    Report report;
    const std::vector<Mover> movers = read(table("a") + table("b") + table("c"), report);
    ASSERT_EQ(movers.size(), 3u);
    EXPECT_EQ(movers[0].objects.size(), 9000u);
    EXPECT_EQ(movers[2].objects.size(), 2000u);
    EXPECT_TRUE(says(report, "20000 names that all movers together may carry"));
}

TEST(MoverFile, a_file_that_ends_anywhere_is_no_harm) {
    const std::string whole = "[[mover]]\nname = \"t\"\nkind = \"hoists\"\nobjects = "
                              "[\"truss*\"]\n[[mover.axis]]\npoint_m = [-3, 0, 5]\n"
                              "range_m = [0, -4]\nuniverse = 1\naddress = 9\nspeed_m_s = "
                              "0.5\n[[mover.key]]\nat_s = 1\nvalues = [2]\n"
                              "[[mover]]\nname = \"w\"\nkind = \"path\"\nparent = \"t\"\npath_m = [[0, 0, "
                              "0], [1, 0, 0]]\nwheelbase_m = 2\n"
                              "tracker = \"w\"\nhome_m = [0, 0, 0]\n[[mover.axis]]\nlimits_m = [0, 1]\n";
    int read_whole = 0;
    for (std::size_t end = 0; end <= whole.size(); ++end) {
        Report report;
        auto parsed = parse_show(std::string_view(whole).substr(0, end), "show.toml", report);
        if (!parsed.ok()) continue;
        ++read_whole;
        check_movers(parsed->show, report);
        MoverMotion motion(parsed->show.movers);
        motion.step({}, 1.0, 0.1, Motion::as_the_machine);
        for (std::size_t k = 0; k < parsed->show.movers.size(); ++k)
            EXPECT_TRUE(std::isfinite(motion.moved(k)[3].z));
    }
    EXPECT_GT(read_whole, 20);
}

Show demo_on_a_lift() {
    Report report;
    Show show = must(load_show(std::filesystem::path(GHOST_SOURCE_DIR) / "assets/demo", false, report));
    show.motion = Motion::as_commanded;
    show.movers = {mover_of(MoverKind::revolve, 1, -360, 360)};
    show.movers[0].centre_m = {0, 2, 0};
    show.movers[0].direction = {0, 0, 1};
    show.fixtures[0].mover = 0;
    show.cameras[0].mover = 0;
    return show;
}

TEST(MoverRig, lamps_and_cameras_go_along_and_heads_aim_from_where_they_are) {
    const Show show = demo_on_a_lift();
    Rig rig(show);
    rig.step({}, 0.1);
    const std::vector<shared::Light> before = rig.lights(GoboStack{}, DistanceMaps{});
    const glm::vec3 aim_m(1, -2, 1);
    rig.aim_at(0, aim_m);
    rig.movers().drive(0, {180});
    rig.step({}, 0.1);
    const std::vector<shared::Light> after = rig.lights(GoboStack{}, DistanceMaps{});
    ASSERT_EQ(before.size(), after.size());
    expect_at(glm::dvec3(rig.moved(0) * glm::vec4(1, 3, 5, 1)), {-1, 1, 5}, 1e-5);
    const glm::vec3 way = glm::normalize(aim_m - after[0].position_m);
    EXPECT_GT(glm::dot(way, after[0].axis_w), std::cos(glm::radians(0.05f)));
    EXPECT_LT(
        glm::length(after[0].position_m + before[0].position_m - glm::vec3(0, 4, 2 * before[0].position_m.z)),
        0.5f)
        << "half round, but for the way of its head";
    EXPECT_EQ(after[1].position_m, before[1].position_m);
    const Camera& stands = show.cameras[0];
    const Camera rides = riding(stands, rig);
    expect_at(glm::dvec3(rides.position_m),
              {-stands.position_m.x, 4 - stands.position_m.y, stands.position_m.z}, 1e-4);
    EXPECT_EQ(riding(show.cameras[1], rig).position_m, show.cameras[1].position_m);
}

} // namespace
} // namespace ghost::scene
