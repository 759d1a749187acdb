// SPDX-License-Identifier: Apache-2.0
// Lasers: where their figures are, that the lumens stay, and what channels and show file make of them.
#include "light/laser_rays.h"

#include "beam_groups/prism.h"
#include "diagnose/explain_parts.h"
#include "fixture_files/common/laser_type.h"
#include "light/frame_lights.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "shared/beam.h"
#include "show_file/show_toml.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace ghost::scene {
namespace {

using fixture::LaserCurve;
using fixture::LaserCurveKind;
using glm::vec2;
using glm::vec3;

const shared::Gobos kNoGobos;

fixture::BeamState laser_state(float field_deg) {
    const auto type = fixture::show_laser_type();
    fixture::BeamState beam;
    for (std::size_t k = 0; k < type->geometries.size(); ++k)
        if (type->geometries[k].beam) beam.geometry = static_cast<int>(k);
    beam.optics.dimmer = 1;
    beam.optics.zoom_deg = field_deg;
    return beam;
}

// At the origin, along +Y, up is +Z.
shared::Light beam_of(float field_deg) {
    const glm::mat4 to_world(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, -1, 0, 0),
                             glm::vec4(0, 0, 0, 1));
    return light_from(*fixture::show_laser_type(), laser_state(field_deg), to_world, {});
}

vec3 towards(const vec2& deg) {
    const vec2 way = glm::tan(glm::radians(deg));
    return {way.x, 1.0f, way.y};
}

// Candela far away, where no beam is as thick as at its lens, towards angles to the right and up.
float candela(const shared::Light& light, const vec2& deg) {
    return shared::beam_candela(light, shared::to_gate(light, 1e4f * towards(deg)), kNoGobos).y;
}

// Over all directions of the gate.
double lumens(const shared::Light& light, float least_step) {
    const double most = static_cast<double>(light.cut_radius);
    const int steps = static_cast<int>(2.0f * light.cut_radius / least_step);
    const double tan2 = std::pow(static_cast<double>(light.tan_field), 2.0), step = 2.0 * most / steps;
    double sum = 0;
    for (int y = 0; y < steps; ++y)
        for (int x = 0; x < steps; ++x) {
            const glm::dvec2 gate = glm::dvec2(x + 0.5, y + 0.5) * step - most;
            const vec3 at(1e4f * light.tan_field * vec2(gate), 1e4f);
            sum += static_cast<double>(shared::beam_candela(light, at, kNoGobos).y) /
                   std::pow(1.0 + tan2 * glm::dot(gate, gate), 1.5);
        }
    return sum * step * step * tan2;
}

TEST(Laser, ASweptFigureHasTheLumensOfItsBeam) {
    const shared::Light beam = beam_of(0.8f);
    const double expected = lumens(beam, 0.01f);
    EXPECT_NEAR(expected / (4.0 * M_PI * static_cast<double>(beam.bounce_cd.y)), 1.0, 5e-3);
    for (const LaserCurveKind kind : {LaserCurveKind::line, LaserCurveKind::circle, LaserCurveKind::wave})
        for (const vec2& size : {vec2(60, 20), vec2(20, 60), vec2(100, 10)})
            for (const float turn : {0.0f, 33.0f}) {
                LaserCurve figure{.kind = kind, .count = 2, .size_deg = size, .deg = turn};
                figure.phase = 0.3f;
                const shared::Light light = swept(beam, figure);
                ASSERT_NE(light.figure.kind, shared::kNoFigure);
                EXPECT_NEAR(lumens(light, 0.6f * light.figure.deviation) / expected, 1.0, 5e-3)
                    << static_cast<int>(kind) << " " << size.x << "x" << size.y << " turned " << turn;
                EXPECT_EQ(light.bounce_cd, beam.bounce_cd);
                // What explain says.
                EXPECT_NEAR(explained::output_lm(light, {}) / explained::output_lm(beam, {}), 1.0f, 0.01f);
            }
}

TEST(Laser, RaysShareTheLumens) {
    const shared::Light beam = beam_of(0.8f);
    const double expected = lumens(beam, 0.01f);
    for (const LaserCurveKind kind :
         {LaserCurveKind::beam, LaserCurveKind::fan, LaserCurveKind::grid, LaserCurveKind::ring}) {
        double sum = 0;
        vec3 bounced(0);
        for (const Copy& ray : rays_of({.kind = kind, .count = 12}, beam.tan_field)) {
            const shared::Light light = copied(beam, ray);
            sum += lumens(light, 0.01f);
            bounced += light.bounce_cd;
        }
        EXPECT_NEAR(sum / expected, 1.0, 5e-3);
        EXPECT_NEAR(bounced.y / beam.bounce_cd.y, 1.0f, 1e-4f);
    }
}

// Angles of the axes of the rays, to the right and up.
std::vector<vec2> angles(const LaserCurve& figure) {
    const shared::Light beam = beam_of(0.05f);
    std::vector<vec2> result;
    for (const Copy& ray : rays_of(figure, beam.tan_field)) {
        const vec3 axis = copied(beam, ray).axis_w;
        result.push_back(glm::degrees(glm::atan(vec2(axis.x, axis.z) / axis.y)));
    }
    return result;
}

TEST(Laser, RaysStandAtTheirAngles) {
    const std::vector<vec2> fan = angles({.kind = LaserCurveKind::fan, .count = 5, .size_deg = {40, 20}});
    ASSERT_EQ(fan.size(), 5u);
    for (int k = 0; k < 5; ++k) {
        EXPECT_NEAR(fan[static_cast<std::size_t>(k)].x, -20.0f + 10.0f * static_cast<float>(k), 0.02f);
        EXPECT_NEAR(fan[static_cast<std::size_t>(k)].y, 0.0f, 0.02f);
    }
    // Turned counter-clockwise as seen from the laser: the first one, at its left, goes down.
    const std::vector<vec2> upright =
        angles({.kind = LaserCurveKind::fan, .count = 2, .size_deg = {40, 0}, .deg = 90});
    EXPECT_NEAR(upright[0].y, -20.0f, 0.02f);
    EXPECT_NEAR(upright[1].y, 20.0f, 0.02f);
    const std::vector<vec2> grid = angles({.kind = LaserCurveKind::grid, .count = 12, .size_deg = {40, 30}});
    ASSERT_EQ(grid.size(), 12u);
    EXPECT_NEAR(grid.front().x, -20.0f, 0.02f);
    EXPECT_NEAR(grid.front().y, -15.0f, 0.02f);
    EXPECT_NEAR(grid.back().x, 20.0f, 0.02f);
    EXPECT_NEAR(grid.back().y, 15.0f, 0.02f);
    for (const vec2& at : angles({.kind = LaserCurveKind::ring, .count = 9, .size_deg = {30, 30}}))
        EXPECT_NEAR(glm::length(glm::tan(glm::radians(at))), std::tan(glm::radians(15.0f)), 1e-3f);
}

TEST(Laser, CurvesAreWhereTheirAnglesSay) {
    const shared::Light beam = beam_of(0.05f);
    const shared::Light line = swept(beam, {.kind = LaserCurveKind::line, .size_deg = {60, 10}});
    const float middle = candela(line, {0, 0});
    for (const float deg : {-29.0f, -12.0f, 12.0f, 29.0f}) {
        const float cosine = std::cos(glm::radians(deg)); // as many lux everywhere on a wall across it
        EXPECT_NEAR(candela(line, {deg, 0}) * cosine * cosine * cosine / middle, 1.0f, 0.01f) << deg;
    }
    EXPECT_LT(candela(line, {31, 0}), 1e-3f * middle);
    EXPECT_LT(candela(line, {0, 0.1f}), 1e-3f * middle);

    const shared::Light circle = swept(beam, {.kind = LaserCurveKind::circle, .size_deg = {30, 30}});
    for (const vec2& at : {vec2(15, 0), vec2(0, 15), vec2(-15, 0), vec2(0, -15)})
        EXPECT_GT(candela(circle, at), 0.9f * candela(circle, {15, 0}));
    for (const float deg : {0.0f, 14.8f, 15.2f})
        EXPECT_LT(candela(circle, {deg, 0}), 1e-3f * candela(circle, {15, 0}));

    // One wave of half its height up at a quarter of its length, which is even on a wall.
    const shared::Light wave = swept(beam, {.kind = LaserCurveKind::wave, .count = 1, .size_deg = {40, 10}});
    const float quarter = glm::degrees(std::atan(0.5f * std::tan(glm::radians(20.0f))));
    EXPECT_GT(candela(wave, {quarter, 5}), 0.5f * candela(wave, {-quarter, -5}));
    EXPECT_LT(candela(wave, {quarter, -5}), 1e-3f * candela(wave, {quarter, 5}));
    // A figure smaller than the beam is wide is the beam.
    EXPECT_EQ(swept(beam, {.kind = LaserCurveKind::line, .size_deg = {0.05f, 60}}).figure.kind,
              shared::kNoFigure);
}

// As thick as at its lens, and wider by its divergence: the standard deviation on a wall 2 m away.
TEST(Laser, ALineIsAsThickAsItsBeam) {
    const shared::Light line = swept(beam_of(0.05f), {.kind = LaserCurveKind::line, .size_deg = {40, 0}});
    double sum = 0, squares = 0;
    for (int k = -4000; k < 4000; ++k) {
        const double y_m = (k + 0.5) * 5e-6;
        const vec3 at(0.1f, static_cast<float>(y_m), 2.0f);
        const double value = static_cast<double>(shared::beam_candela(line, at, kNoGobos).y);
        sum += value;
        squares += value * y_m * y_m;
    }
    // Half the radius of a disc of 2.5 mm, and of a cone of 0.05 degrees, the thinnest that is drawn.
    const double expected_m = 0.5 * std::hypot(0.0025, 2.0 * std::tan(0.05 * M_PI / 180));
    EXPECT_NEAR(std::sqrt(squares / sum) / expected_m, 1.0, 0.02);
}

Show show_of(const std::string& laser, Report& report, const std::string& more = "") {
    const auto parsed =
        parse_show("[show]\nstage = \"stage.glb\"\n[[fixture]]\nname = \"L\"\nposition_m = [0, 0, 5]\n" +
                       more + "laser = " + laser +
                       "\n[[camera]]\nname = \"house\"\nposition_m = [0, -9, 2]\ntarget_m = [0, 0, 2]\n",
                   "show.toml", report);
    if (!parsed.ok()) {
        ADD_FAILURE() << parsed.error().text();
        return {};
    }
    Show show = parsed->show;
    for (PatchedFixture& fixture : show.fixtures) fixture.type = fixture::show_laser_type();
    return show;
}

std::vector<shared::Light> lit_by(Rig& rig) {
    std::vector<shared::Light> lights;
    for (const shared::Light& light : rig.lights({}, DistanceMaps{}))
        if (light.intensity_cd != vec3(0)) lights.push_back(light);
    return lights;
}

TEST(Laser, AShowFileSaysHowItIs) {
    Report report;
    const Show show =
        show_of("{ figure = \"fan\", rays = 5, size_deg = [40, 0], turning_deg_s = 90, watts = 5, "
                "colour = [0, 1, 0] }",
                report);
    for (const Message& message : report.messages) ADD_FAILURE() << message.what;
    Rig rig(show);
    rig.step({}, 0.0);
    EXPECT_EQ(rig.lights({}, DistanceMaps{}).size(), static_cast<std::size_t>(fixture::kMostRays));
    std::vector<shared::Light> lights = lit_by(rig);
    ASSERT_EQ(lights.size(), 5u);
    double green = 0, red = 0;
    for (const shared::Light& light : lights) {
        green += 4.0 * M_PI * static_cast<double>(light.bounce_cd.y);
        red += static_cast<double>(light.bounce_cd.x);
        EXPECT_NEAR(light.axis_w.y, 0.0f, 1e-5f); // it hangs: the fan is along X
    }
    // 1000 lm of white by a filter that lets green pass.
    EXPECT_GT(green, 300.0);
    EXPECT_LT(green, 1000.0);
    EXPECT_LT(red, green);
    rig.step({}, 1.0);
    lights = lit_by(rig);
    for (const shared::Light& light : lights) EXPECT_NEAR(light.axis_w.x, 0.0f, 1e-5f);
}

TEST(Laser, ChannelsChooseTheFigure) {
    Report report;
    const Show show = show_of("{ figure = \"fan\", rays = 9 }", report, "address = 1\n");
    Rig rig(show);
    dmx::Universes universes;
    const auto send = [&](std::vector<std::uint8_t> values, double dt_s) {
        dmx::Levels levels{};
        std::copy(values.begin(), values.end(), levels.begin());
        universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        rig.step(universes, dt_s);
        return lit_by(rig);
    };
    // Dimmer, shutter, red, green, blue, figure, rays, width, height, turn, turning, running.
    EXPECT_EQ(send({255, 255, 255, 255, 255, 0, 60, 85, 43, 0, 128, 128}, 0).size(), 1u);
    EXPECT_EQ(send({255, 255, 255, 255, 255, 40, 255, 85, 43, 0, 128, 128}, 0).size(), 32u);
    EXPECT_EQ(send({255, 255, 255, 255, 255, 80, 66, 85, 85, 0, 128, 128}, 0).size(), 9u);
    EXPECT_EQ(send({255, 0, 255, 255, 255, 80, 66, 85, 85, 0, 128, 128}, 0).size(), 0u);
    const auto curve = [&](std::uint8_t figure) {
        const auto lights = send({255, 255, 0, 255, 0, figure, 0, 85, 43, 0, 128, 255}, 0.01);
        EXPECT_EQ(lights.size(), 1u);
        return lights.empty() ? shared::LaserCurve{} : lights.front().figure;
    };
    EXPECT_EQ(curve(150).kind, shared::kLineFigure);
    EXPECT_EQ(curve(200).kind, shared::kCircleFigure);
    const float before = curve(255).phase, after = curve(255).phase;
    EXPECT_EQ(curve(255).kind, shared::kWaveFigure);
    EXPECT_NEAR(after - before, -2.0f * shared::kPi * 0.05f, 1e-4f); // 5 Hz, 10 ms
    // Every value of every channel is some picture.
    for (int channel = 5; channel < 12; ++channel)
        for (int value = 0; value < 256; ++value) {
            std::vector<std::uint8_t> values{255, 255, 255, 255, 255, 230, 60, 85, 43, 0, 128, 128};
            values[static_cast<std::size_t>(channel)] = static_cast<std::uint8_t>(value);
            for (const shared::Light& light : send(values, 0.04)) {
                ASSERT_TRUE(std::isfinite(light.intensity_cd.y)) << channel << " at " << value;
                ASSERT_TRUE(std::isfinite(light.figure.deviation));
            }
        }
}

TEST(Laser, WhatIsWrongIsSaid) {
    const auto said = [](const std::string& laser) {
        Report report;
        (void)show_of(laser, report);
        std::string all;
        for (const Message& message : report.messages) all += message.where + ": " + message.what + "\n";
        return all;
    };
    EXPECT_NE(said("{ figure = \"circel\" }")
                  .find("show.toml:6: [[fixture]] 'L' laser figure is 'circel', expected "
                        "beam, fan, grid, ring, line, circle or wave"),
              std::string::npos)
        << said("{ figure = \"circel\" }");
    for (const char* wrong : {"{ figure = \"fan\", rays = 33 }", "{ figure = \"fan\", size_deg = [180, 10] }",
                              "{ figure = \"fan\", size_deg = 20 }", "{ watts = -1 }", "{ figure = 7 }",
                              "{ rays = 3 }", "{ figure = \"wave\", running_hz = 1e9 }", "{ beems = 3 }"})
        EXPECT_NE(said(wrong).find("show.toml:6"), std::string::npos) << wrong << "\n" << said(wrong);
}

} // namespace
} // namespace ghost::scene
