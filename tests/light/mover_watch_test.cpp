// SPDX-License-Identifier: Apache-2.0
// Meetings on the way of movers: named whatever else a report holds, and as many as anybody reads.
#include "light/mover_watch.h"
#include "show/show.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ghost::scene {
namespace {

// A lift, 1 m high, and boxes that hang in a row 3 m above it.
struct World {
    explicit World(std::size_t boxes) {
        show.motion = fixture::Motion::as_commanded;
        Mover& mover = show.movers.emplace_back();
        mover.name = "lift";
        mover.where = "show.toml:7";
        mover.objects = {"platform"};
        mover.axes.emplace_back().high = 10;
        Mesh& mesh = stage.meshes.emplace_back();
        mesh.positions = {{0, 0, 0}, {1, 1, 1}};
        Mesh& wide = stage.meshes.emplace_back();
        wide.positions = {{0, 0, 0}, {100, 1, 1}};
        stage.instances.push_back({.name = "platform", .mesh = 1});
        for (std::size_t k = 0; k < boxes; ++k) {
            Instance& box = stage.instances.emplace_back();
            box.name = "box " + std::to_string(k);
            box.world[3] = glm::vec4(static_cast<float>(k), 0, 3, 1);
        }
    }

    void look_at(float height_m, Report& report, std::uint64_t most_pairs = kMostComparedBodies) {
        MoverWatch watch(show, stage, most_pairs);
        Rig rig(show);
        rig.movers().drive(0, {height_m});
        rig.step({}, 0.1);
        watch.look(rig, 4, report);
        watch.look(rig, 5, report);
    }

    Show show;
    Stage stage;
};

std::size_t count(const Report& report, const std::string& part) {
    return static_cast<std::size_t>(
        std::count_if(report.messages.begin(), report.messages.end(),
                      [&](const Message& message) { return message.what.find(part) != std::string::npos; }));
}

TEST(MoverWatch, names_meetings_whatever_the_report_holds_already) {
    Report report;
    for (int k = 0; k < 60; ++k) report.add(Severity::warning, "show.toml", "another trouble");
    World(1).look_at(2.5f, report);
    ASSERT_EQ(report.messages.size(), 61u);
    EXPECT_EQ(report.messages.back().what,
              "at 4.00 s 'platform' of mover 'lift' meets 'box 0' at [0.50, 0.50, 3.25]");
    EXPECT_EQ(report.messages.back().where, "show.toml:7");
}

TEST(MoverWatch, says_once_that_it_does_not_name_them_all) {
    Report report;
    World(80).look_at(2.5f, report);
    EXPECT_EQ(count(report, "' meets '"), 50u);
    EXPECT_EQ(count(report, "more bodies of movers meet; they are not named"), 1u);
    Report apart;
    World(80).look_at(1.5f, apart);
    EXPECT_TRUE(apart.messages.empty());
}

TEST(MoverWatch, compares_no_more_bodies_than_it_may) {
    const std::string words = "it is not looked at whether bodies of movers meet: they are too many";
    Report enough, short_by_one;
    World(80).look_at(2.5f, enough, 80 * 2); // where they stand, and once on their way; then 50 were named
    EXPECT_EQ(count(enough, "' meets '"), 50u);
    World(30).look_at(2.5f, short_by_one, 30 * 2 - 1);
    EXPECT_EQ(count(short_by_one, "' meets '"), 0u);
    EXPECT_EQ(count(short_by_one, words), 1u);
    EXPECT_EQ(short_by_one.messages.back().what.substr(0, 9), "at 4.00 s");
}

TEST(MoverWatch, where_too_many_meet_already_none_is_looked_for) {
    World world(110'000);
    for (Instance& instance : world.stage.instances) instance.world[3] = glm::vec4(0, 0, 0, 1);
    Report report;
    world.look_at(0.5f, report);
    EXPECT_EQ(count(report, "they are too many"), 1u);
}

TEST(MoverWatch, what_meets_where_the_model_has_it_may) {
    World world(80);
    for (Instance& instance : world.stage.instances) instance.world[3].z = 3;
    Report report;
    world.look_at(0.5f, report);
    EXPECT_TRUE(report.messages.empty());
}

} // namespace
} // namespace ghost::scene
