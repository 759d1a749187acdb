// SPDX-License-Identifier: Apache-2.0
// Yokes and heads that follow a rig: which instances move, and that they point where the light goes.
#include "light/bodies.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/show.h"
#include "support/must.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace ghost::scene {
namespace {

std::shared_ptr<const fixture::Type> vl2500() {
    static const auto type = [] {
        return std::make_shared<const fixture::Type>(
            must(fixture::load_gdtf("assets/fixtures/Vari-Lite@VL2500_Spot.gdtf")).type);
    }();
    return type;
}

Show show_of(std::size_t count) {
    Show show;
    for (std::size_t k = 0; k < count; ++k) {
        PatchedFixture fixture;
        fixture.name = "Spot " + std::to_string(k + 1);
        fixture.type = vl2500();
        fixture.address = 1 + 22 * static_cast<int>(k);
        fixture.position_m = {3.0f * static_cast<float>(k), 2, 6};
        show.fixtures.push_back(fixture);
    }
    return show;
}

// 16 bit pan and tilt of the first fixture, 540 and 270 degrees about the middle.
dmx::Universes levels(float pan_deg, float tilt_deg, int track = 0) {
    dmx::Levels values{};
    const auto put = [&](std::size_t channel, float fraction) {
        const auto value = static_cast<int>(std::lround(fraction * 65535.0f));
        values[channel - 1] = static_cast<std::uint8_t>(value / 256);
        values[channel] = static_cast<std::uint8_t>(value % 256);
    };
    put(2, 0.5f + pan_deg / 540.0f);
    put(4, 0.5f + tilt_deg / 270.0f);
    values[499] = static_cast<std::uint8_t>(track / 256);
    values[500] = static_cast<std::uint8_t>(track % 256);
    dmx::Universes universes;
    universes.at(1).levels = std::make_shared<const dmx::Levels>(values);
    return universes;
}

std::string node_of(const Show& show, const Instance& instance) {
    const fixture::Mode& mode = show.fixtures[0].type->modes[0];
    EXPECT_NE(instance.part, kNone);
    const int node = mode.parts[static_cast<std::size_t>(instance.part)];
    return mode.nodes[static_cast<std::size_t>(node)].name;
}

float most_difference(const glm::mat4& a, const glm::mat4& b) {
    float most = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
    return most;
}

TEST(bodies, YokesAndHeadsMoveBasesDoNot) {
    const Show show = show_of(2);
    Report report;
    const Stage stage = stage_with_bodies(show, report);
    const std::vector<std::size_t> moving = moving_instances(show, stage);
    std::set<std::string> names;
    for (const std::size_t k : moving) names.insert(node_of(show, stage.instances[k]));
    EXPECT_EQ(names, (std::set<std::string>{"Yoke", "Head"}));
    for (std::size_t k = 0; k < stage.instances.size(); ++k)
        EXPECT_EQ(std::find(moving.begin(), moving.end(), k) == moving.end(),
                  node_of(show, stage.instances[k]) == "Base");
}

TEST(bodies, HeadsPointWhereTheLightGoes) {
    const Show show = show_of(2);
    Report report;
    const Stage stage = stage_with_bodies(show, report);
    const GoboStack gobos;
    Rig rig(show);
    for (const auto& [pan_deg, tilt_deg] :
         {std::pair(0.0f, 0.0f), {90.0f, 0.0f}, {-200.0f, 60.0f}, {37.0f, -110.0f}}) {
        rig.step(levels(pan_deg, tilt_deg), 3600);
        rig.step(levels(pan_deg, tilt_deg), 3600);
        Stage turned = stage;
        pose_bodies(show, rig, turned);
        const shared::Light light = rig.lights(gobos, DistanceMaps{})[0];
        EXPECT_NEAR(light.axis_w.z, -std::cos(glm::radians(tilt_deg)), 1e-3f);
        for (const std::size_t k : moving_instances(show, stage)) {
            const Instance& instance = turned.instances[k];
            EXPECT_EQ(instance.world, body_to_world(show, rig, stage.instances[k]));
            if (instance.fixture != 0) continue;
            const glm::mat4 part = instance.world * glm::inverse(instance.to_part);
            const glm::vec3 down = -glm::normalize(glm::vec3(part[2]));
            const glm::vec3 side = glm::normalize(glm::vec3(part[0]));
            const bool is_head = node_of(show, instance) == "Head";
            const glm::vec3 expected = is_head ? light.axis_w : glm::vec3(0, 0, -1);
            EXPECT_LT(glm::length(down - expected), 1e-3f) << instance.name << " " << pan_deg;
            // Pan turns the yoke about the vertical, the tilt axis is its X.
            EXPECT_NEAR(side.x, std::cos(glm::radians(pan_deg)), 1e-3f);
            EXPECT_NEAR(side.y, std::sin(glm::radians(pan_deg)), 1e-3f);
            EXPECT_NEAR(side.z, 0.0f, 1e-3f);
            if (is_head) {
                const glm::vec3 pivot_m = light.position_m - light.off_map_m;
                EXPECT_LT(glm::length(glm::vec3(part[3]) - pivot_m), 1e-3f)
                    << "the head turns about where the light's map is made";
            }
        }
    }
}

TEST(bodies, AtHomeTheyStandAsTheStageHasThem) {
    Show show = show_of(1);
    show.fixtures[0].home_pan_deg = 45;
    show.fixtures[0].home_tilt_deg = -30;
    Report report;
    const Stage stage = stage_with_bodies(show, report);
    Rig rig(show);
    rig.step(levels(45, -30), 3600);
    rig.step(levels(45, -30), 3600);
    Stage turned = stage;
    pose_bodies(show, rig, turned);
    for (std::size_t k = 0; k < stage.instances.size(); ++k)
        EXPECT_LT(most_difference(turned.instances[k].world, stage.instances[k].world), 2e-3f)
            << stage.instances[k].name;
}

TEST(bodies, OnATrackAllOfTheFixtureTravels) {
    Show show = show_of(1);
    show.fixtures[0].track = Track{{{0, 0, 6}, {4, 0, 6}, {4, 8, 6}}, 1, 500};
    Report report;
    const Stage stage = stage_with_bodies(show, report);
    const std::vector<std::size_t> moving = moving_instances(show, stage);
    EXPECT_EQ(moving.size(), stage.instances.size()) << "the base too";
    Rig rig(show);
    for (const auto& [value, place_m] : {std::pair(0, glm::vec3(0, 0, 6)),
                                         {16384, glm::vec3(2, 0, 6)},
                                         {49151, glm::vec3(4, 4, 6)},
                                         {65535, glm::vec3(4, 8, 6)}}) {
        rig.step(levels(0, 0, value), 3600);
        for (const Instance& instance : stage.instances) {
            if (node_of(show, instance) != "Base") continue;
            const glm::mat4 part = body_to_world(show, rig, instance) * glm::inverse(instance.to_part);
            EXPECT_LT(glm::length(glm::vec3(part[3]) - place_m), 2e-3f) << value;
        }
    }
}

} // namespace
} // namespace ghost::scene
