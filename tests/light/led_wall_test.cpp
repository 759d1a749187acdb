// SPDX-License-Identifier: Apache-2.0
// LED walls: the light that they throw is that of their pictures, and the camera sees them where they are.
#include "light/led_wall_light.h"

#include "fixture_files/common/wall_type.h"
#include "image/pyramid.h"
#include "light/bodies.h"
#include "light/frame_lights.h"
#include "light/gobos.h"
#include "light/illuminance.h"
#include "light/rig.h"
#include "shared/beam.h"
#include "show_file/show_toml.h"
#include "support/plot_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

// A stack whose only medium is this picture.
GoboStack showing(int width, int height, const std::function<vec3(int, int)>& colour) {
    image::Image8 picture(width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c)
                picture.at(x, y)[c] = static_cast<std::uint8_t>(255.0f * colour(x, y)[c]);
            picture.at(x, y)[3] = 255;
        }
    const image::Pyramid pyramid = image::make_pyramid(picture, 256);
    GoboStack stack;
    stack.images.slides.push_back({pyramid.side, pyramid.levels});
    stack.showing.push_back({1, pyramid.extent, pyramid.mean, pyramid.side});
    return stack;
}

GoboStack white(int width = 256, int height = 144) {
    return showing(width, height, [](int, int) { return vec3(1.0f); });
}

// A wall at the origin that looks to -Y.
Show wall_show(LedWall wall = {}, const vec2& size_m = {8, 4.5f}) {
    Show show;
    wall.size_m = size_m;
    wall.nits = 1000;
    show.media.emplace_back();
    PatchedFixture fixture;
    fixture.name = "Wall";
    fixture.wall = wall;
    fixture.type = fixture::led_wall_type(wall.size_m, cells_of(wall), wall.nits);
    show.fixtures.push_back(std::move(fixture));
    return show;
}

double lumens_of(const shared::Light& light, const GoboStack& stack) {
    constexpr int kSteps = 4000;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) { // round about its axis
        const double angle = (k + 0.5) / kSteps * 0.5 * std::numbers::pi;
        const vec3 way(static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle)));
        sum +=
            static_cast<double>(shared::beam_candela(light, 100.0f * way, stack.images).y) * std::sin(angle);
    }
    return sum * 2.0 * std::numbers::pi * 0.5 * std::numbers::pi / kSteps;
}

TEST(LedWall, ThrowsTheLumensOfItsPixels) {
    const Show show = wall_show();
    const GoboStack stack = white();
    Rig rig(show);
    rig.step({}, 0);
    const FrameLights lit = rig.lit(stack, DistanceMaps{});
    EXPECT_EQ(lit.lights.size(), 6u); // 3 x 2 cells
    double lumens = 0;
    for (const shared::Light& light : lit.lights) {
        lumens += lumens_of(light, stack);
        EXPECT_NEAR(light.panel_m, std::sqrt(6.0f / std::numbers::pi_v<float>), 1e-3f)
            << "no bright spot in the air before it";
    }
    EXPECT_NEAR(lumens / (std::numbers::pi * 1000.0 * 8.0 * 4.5), 1.0, 5e-3);
    ASSERT_EQ(lit.walls.size(), 1u);
    EXPECT_FLOAT_EQ(lit.walls[0].radiance.y, 1000.0f);
    for (const LensFace& face : lit.faces) EXPECT_TRUE(face.of_wall);
}

// Of what a surface that is equally bright from all sides throws there, by the integral over its area.
double share_of_lambert(const FrameLights& lit, const GoboStack& stack, const vec2& size_m, const vec3& at,
                        const vec3& normal) {
    double lux = 0, expected = 0;
    for (const shared::Light& light : lit.lights)
        lux += static_cast<double>(illuminance(light, at, normal, stack.images, LitAir{}).y);
    constexpr int kSteps = 100;
    for (int k = 0; k < kSteps * kSteps; ++k) {
        const vec3 from(size_m.x * ((static_cast<float>(k % kSteps) + 0.5f) / kSteps - 0.5f), 0,
                        size_m.y * ((static_cast<float>(k / kSteps) + 0.5f) / kSteps - 0.5f));
        const vec3 way = at - from;
        const float d2 = glm::dot(way, way);
        expected +=
            static_cast<double>(1000.0f * -way.y * std::max(glm::dot(normal, -way), 0.0f) / (d2 * d2));
    }
    return lux / (expected * static_cast<double>(size_m.x * size_m.y) / (kSteps * kSteps));
}

// Onto a wall across the stage and a floor before it, from as near as a cell is wide.
TEST(LedWall, LightsAsItsAreaDoes) {
    struct Size {
        vec2 size_m;
        glm::ivec2 cells; // 0: as many as it has unless told
    };
    for (const Size& size : {Size{{8, 4.5f}, {8, 8}}, Size{{8, 4.5f}, {0, 0}}, Size{{4, 2.25f}, {0, 0}},
                             Size{{3, 3}, {0, 0}}, Size{{16, 9}, {8, 8}}}) {
        LedWall wall;
        wall.cells = size.cells;
        wall.fit = Fit::stretch;
        const Show show = wall_show(wall, size.size_m);
        const GoboStack stack = white();
        Rig rig(show);
        rig.step({}, 0);
        const FrameLights lit = rig.lit(stack, DistanceMaps{});
        const float floor_z = -0.5f * size.size_m.y - 1.0f;
        const vec3 to_wall(0, 1, 0), up(0, 0, 1);
        for (const auto& [at, normal] :
             {std::pair{vec3(0, -4, 0), to_wall}, std::pair{vec3(0, -8, 0), to_wall},
              std::pair{vec3(0, -15, 0), to_wall}, std::pair{vec3(3, -6, -1), to_wall},
              std::pair{vec3(0, -3, floor_z), up}, std::pair{vec3(0, -6, floor_z), up},
              std::pair{vec3(4, -9, floor_z), up}})
            EXPECT_NEAR(share_of_lambert(lit, stack, size.size_m, at, normal), 1.0, 0.1)
                << size.size_m.x << " m wide at " << at.x << " " << at.y << " " << at.z;
    }
}

// Red above left, blue below right, the rest black: cells are red and blue there, and add up to the picture's
// mean.
TEST(LedWall, CellsHaveTheColoursOfThePicture) {
    const GoboStack stack = showing(256, 144, [](int x, int y) {
        return x < 128 && y < 72 ? vec3(1, 0, 0) : (x >= 128 && y >= 72 ? vec3(0, 0, 1) : vec3(0));
    });
    LedWall wall;
    wall.size_m = {8, 4.5f};
    wall.cells = {4, 2};
    vec3 sum(0.0f);
    for (int cell = 0; cell < 8; ++cell) {
        const vec3 fraction = cell_fraction(wall, cell, stack.showing[0], stack.images.slides[0]);
        sum += fraction / 8.0f;
        const bool red = cell == 0 || cell == 1, blue = cell == 6 || cell == 7;
        if (red) {
            EXPECT_GT(fraction.x, 8.0f * fraction.z) << cell;
        }
        if (blue) {
            EXPECT_GT(fraction.z, 8.0f * fraction.y) << cell;
        }
        if (!red && !blue) {
            EXPECT_LT(glm::length(fraction), 0.02f) << cell;
        }
    }
    EXPECT_NEAR(sum.x, (0.627404f + 0.043313f) / 4.0f, 2e-3f);
    EXPECT_NEAR(sum.z, (0.016391f + 0.895595f) / 4.0f, 2e-3f);
}

// A square picture on a wide wall leaves its sides dark, unless it covers or is stretched.
TEST(LedWall, FitsThePicture) {
    const GoboStack stack = white(128, 128);
    for (const auto& [fit, fraction] :
         {std::pair{Fit::contain, 4.5f / 8.0f}, {Fit::cover, 1.0f}, {Fit::stretch, 1.0f}}) {
        LedWall wall;
        wall.size_m = {8, 4.5f};
        wall.cells = {8, 1};
        wall.fit = fit;
        vec3 sum(0.0f);
        for (int cell = 0; cell < 8; ++cell)
            sum += cell_fraction(wall, cell, stack.showing[0], stack.images.slides[0]) / 8.0f;
        EXPECT_NEAR(sum.y, fraction, 2e-3f);
        const shared::LedWall seen = seen_wall(wall, glm::mat4(1.0f), stack.showing[0], vec3(1));
        EXPECT_NEAR(seen.shown.x, fit == Fit::contain ? 4.5f / 8.0f : 1.0f, 1e-4f);
    }
}

TEST(LedWall, IsSeenFromItsFrontOnly) {
    LedWall wall;
    wall.size_m = {8, 4.5f};
    const shared::LedWall seen = seen_wall(wall, glm::mat4(1.0f), white().showing[0], vec3(1));
    const vec3 before(0, -10, 0);
    EXPECT_EQ(shared::place_on_wall(seen, {2, 0, 1.125f}, before), vec3(0.5f, 0.5f, 1));
    EXPECT_EQ(shared::place_on_wall(seen, {2, 0, 1}, {0, 10, 0}).z, 0.0f);
    EXPECT_EQ(shared::place_on_wall(seen, {2, -0.3f, 1}, before).z, 0.0f); // somebody stands before it
    EXPECT_EQ(shared::place_on_wall(seen, {4.1f, 0, 1}, before).z, 0.0f);
    // Near to it an LED is one colour over its width, from far away it is where one looks.
    wall.pitch_m = 0.1f;
    const shared::LedWall coarse = seen_wall(wall, glm::mat4(1.0f), white().showing[0], vec3(1));
    const vec2 here = shared::led_place(coarse, {0.301f, 0.2f}, 1e-4f),
               beside = shared::led_place(coarse, {0.311f, 0.2f}, 1e-4f);
    EXPECT_NEAR(here.x, beside.x, 1e-6f);
    EXPECT_NEAR(shared::led_place(coarse, {0.311f, 0.2f}, 1.0f).x, 0.311f, 1e-5f);
}

TEST(LedWall, TheDeskDimsItAndChoosesItsPicture) {
    LedWall wall;
    wall.universe = 1;
    wall.address = 2;
    Show show = wall_show(wall);
    show.media.emplace_back();
    show.fixtures[0].address = 1;
    Rig rig(show);
    dmx::Levels levels{};
    levels[0] = 51;
    levels[1] = 2;
    dmx::Universes universes;
    universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
    rig.step(universes, 0);
    GoboStack stack = white();
    stack.images.slides.push_back(stack.images.slides[0]);
    stack.showing.push_back(stack.showing[0]);
    const FrameLights lit = rig.lit(stack, DistanceMaps{});
    ASSERT_EQ(lit.walls.size(), 1u);
    EXPECT_NEAR(lit.walls[0].radiance.y, 200.0f, 1.0f);
    EXPECT_EQ(lit.walls[0].layer, 2u);
}

// Its panel is part of the stage, behind the picture: it stops the light of others, not its own.
TEST(LedWall, ItsPanelStandsBehindItsFront) {
    Report report;
    const Stage stage = stage_with_bodies(wall_show(), report);
    ASSERT_EQ(stage.instances.size(), 1u);
    EXPECT_EQ(stage.instances[0].fixture, kNone);
    vec3 low(1e9f), high(-1e9f);
    for (const vec3& position : stage.meshes[static_cast<std::size_t>(stage.instances[0].mesh)].positions) {
        const vec3 world(stage.instances[0].world * glm::vec4(position, 1));
        low = glm::min(low, world);
        high = glm::max(high, world);
    }
    expect_near(low, {-4, 0, -2.25f});
    expect_near(high, {4, kWallDepth_m, 2.25f});
}

TEST(LedWall, BadKeysAreNamed) {
    Report report;
    const auto parsed = parse_show(R"([show]
stage = "s.glb"
[[camera]]
position_m = [0, -9, 2]
target_m = [0, 0, 2]
[[media]]
name = "sea"
card = "bars"
[[fixture]]
name = "A"
position_m = [0, 0, 3]
gdtf = "x.gdtf"
wall = { media = "see", nits = 0, cells = [9, 1], pich_mm = 3 }
[[wall]]
name = "*"
)",
                                   "show.toml", report);
    ASSERT_TRUE(parsed.ok());
    const std::string said = messages_of(report);
    for (const char* part :
         {"did you mean 'sea'", "size_m", "nits", "cells", "pich_mm", "gdtf is not used", "[show] has none"})
        EXPECT_NE(said.find(part), std::string::npos) << part << " in\n" << said;
    ASSERT_TRUE(parsed->show.fixtures[0].wall);
    EXPECT_FLOAT_EQ(parsed->show.fixtures[0].wall->nits, 1500.0f);
}

// What a screen of a plot shows is in the archive or beside it; what is in neither is said.
TEST(LedWall, ScreensOfAPlotShowFilesOfItsArchiveAndBesideIt) {
    const fs::path folder = scratch("screens");
    const auto screen = [](int number, const std::string& file) {
        return "<VideoScreen uuid=\"" + uuid(number) + "\" name=\"" + file + "\">" +
               matrix(kIdentity + "{1000,2000,3000}") +
               "<Geometries><Geometry3D fileName=\"Sail.glb\"/></Geometries>" +
               "<Sources><Source linkedGeometry=\"Sail\" type=\"File\">" + file +
               "</Source></Sources></VideoScreen>\n";
    };
    write_mvr(folder / "Show.mvr",
              small_xml(screen(40, "inside.mp4") + screen(41, "beside.mp4") + screen(42, "gone.mp4")),
              {{"inside.mp4", "a film"}});
    std::ofstream(folder / "beside.mp4") << "another";
    for (int round = 0; round < 2; ++round) {
        Report report;
        const Show show = opened(folder / "Show.mvr", report);
        ASSERT_EQ(show.media.size(), 3u) << messages_of(report);
        EXPECT_EQ(messages_of(report).find("not in the archive"), std::string::npos) << messages_of(report);
        EXPECT_EQ(show.media[0].file.parent_path(), folder / ".ghost" / "media");
        std::ifstream unpacked(show.media[0].file);
        EXPECT_EQ(std::string(std::istreambuf_iterator<char>(unpacked), {}), "a film");
        EXPECT_EQ(show.media[1].file, folder / "beside.mp4");
        EXPECT_NE(messages_of(report).find("'gone.mp4' file: no such file " + (folder / "gone.mp4").string()),
                  std::string::npos)
            << messages_of(report);
        EXPECT_EQ(std::count_if(report.messages.begin(), report.messages.end(),
                                [](const Message& message) { return message.severity == Severity::error; }),
                  1)
            << messages_of(report);
    }
}

// Sail.glb is a triangle in X and Z; a screen with it is a wall as large as it, and [[wall]] says what it is
// like.
TEST(LedWall, ScreensOfAPlotAreWalls) {
    const fs::path folder = scratch("walls");
    write_mvr(folder / "Show.mvr",
              small_xml("<VideoScreen uuid=\"" + uuid(40) + "\" name=\"Back wall\">" +
                        matrix(kIdentity + "{1000,2000,3000}") +
                        "<Geometries><Geometry3D fileName=\"Sail.glb\"/></Geometries></VideoScreen>\n"));
    std::ofstream(folder / "show.toml") << R"([show]
plot = "Show.mvr"
[[media]]
name = "card"
card = "white"
[[wall]]
name = "Back*"
nits = 4000
[[wall]]
name = "Front*"
)";
    Report report;
    const Show show = opened(folder / "show.toml", report);
    ASSERT_EQ(show.fixtures.size(), 1u) << messages_of(report);
    ASSERT_TRUE(show.fixtures[0].wall);
    EXPECT_EQ(show.fixtures[0].name, "Back wall");
    EXPECT_FLOAT_EQ(show.fixtures[0].wall->nits, 4000.0f);
    EXPECT_FALSE(show.fixtures[0].wall->has_body);
    EXPECT_NE(messages_of(report).find("no screen 'Front*'"), std::string::npos) << messages_of(report);
    // Its rectangle holds all of the mesh.
    expect_near(show.fixtures[0].position_m, {1, 2, 3});
    Rig rig(show);
    rig.step({}, 0);
    const FrameLights lit = rig.lit(white(), DistanceMaps{});
    ASSERT_EQ(lit.walls.size(), 1u);
    const shared::LedWall& seen = lit.walls[0];
    EXPECT_FLOAT_EQ(seen.radiance.y, 4000.0f);
    for (const shared::Light& light : lit.lights) EXPECT_GT(glm::dot(light.axis_w, seen.normal), 0.999f);
    const vec3 eye_m = seen.centre_m + 10.0f * seen.normal;
    for (const Instance& instance : show.stage.instances)
        for (const vec3& position : show.stage.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const vec3 world(instance.world * glm::vec4(position, 1));
            const vec3 inside = glm::mix(seen.centre_m, world, 0.999f);
            EXPECT_EQ(shared::place_on_wall(seen, inside, eye_m).z, 1.0f)
                << world.x << " " << world.y << " " << world.z;
        }
}

} // namespace
} // namespace ghost::scene
