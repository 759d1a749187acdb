// SPDX-License-Identifier: Apache-2.0
// Video projectors: geometry and photometry as data sheets state them.
#include "light/projector_beam.h"

#include "diagnose/explain.h"
#include "diagnose/explain_print.h"
#include "fixture_files/common/projector_type.h"
#include "image/pyramid.h"
#include "light/frame_lights.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "shared/beam.h"
#include "show_file/show_toml.h"
#include "support/must.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kLumens = 10000;

// A stack whose only medium is one colour, of this shape.
GoboStack showing_grey(std::uint8_t grey, int width = 64, int height = 36) {
    image::Image8 picture(width, height, 4);
    std::fill(picture.samples.begin(), picture.samples.end(), grey);
    for (std::size_t k = 3; k < picture.samples.size(); k += 4) picture.samples[k] = 255;
    const image::Pyramid pyramid = image::make_pyramid(picture, 64);
    GoboStack stack;
    stack.images.slides.push_back({pyramid.side, pyramid.levels});
    stack.showing.push_back({1, pyramid.extent, pyramid.mean, pyramid.side});
    return stack;
}

Projector projector() {
    Projector one;
    one.media = 0;
    one.lumens = kLumens;
    one.throw_ratio = 1.5f;
    one.contrast = 1e7f;
    one.focus_m = 8;
    return one;
}

// At the origin, along +Y, its picture upright (Z up).
shared::Light projector_light(const Projector& projector, const GoboStack& stack,
                              const std::function<void(fixture::Optics&)>& set = {}) {
    const auto type = fixture::video_projector_type();
    fixture::BeamState beam;
    for (std::size_t k = 0; k < type->geometries.size(); ++k)
        if (type->geometries[k].beam) beam.geometry = static_cast<int>(k);
    beam.optics.dimmer = 1;
    if (set) set(beam.optics);
    const glm::mat4 to_world(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, -1, 0, 0),
                             glm::vec4(0, 0, 0, 1));
    ProfileTable profiles;
    return light_from(*type, beam, to_world, stack, profiles, &projector);
}

// Lux on a wall across Y, green for white.
float lux_at(const shared::Light& light, const GoboStack& stack, const vec3& place,
             const vec3& normal = {0, -1, 0}) {
    const vec3 candela = shared::beam_candela(light, shared::to_gate(light, place), stack.images);
    const float d = glm::length(place);
    return candela.y / (d * d) * std::max(glm::dot(normal, -place / d), 0.0f);
}

// At 9 m and a throw ratio of 1.5 a picture is 6 m wide; 10000 lm over 6 x 3.375 m are 494 lux everywhere.
TEST(Projector, LightsAWallEvenlyWithItsLumens) {
    const GoboStack stack = showing_grey(255);
    const shared::Light light = projector_light(projector(), stack);
    const float expected = kLumens / (6.0f * 3.375f);
    for (const vec2& at : {vec2(0, 0), vec2(2.9f, 0), vec2(-2.9f, 1.6f), vec2(1, -1.6f), vec2(2.9f, 1.6f)})
        EXPECT_NEAR(lux_at(light, stack, {at.x, 9, at.y}) / expected, 1.0f, 2e-3f) << at.x << " " << at.y;
    for (const vec2& at : {vec2(3.1f, 0), vec2(0, 1.8f), vec2(-3.1f, -1.8f)})
        EXPECT_LT(lux_at(light, stack, {at.x, 9, at.y}), 1e-3f * expected);
    double sum = 0;
    constexpr int kSteps = 400;
    for (int y = 0; y < kSteps; ++y)
        for (int x = 0; x < kSteps; ++x)
            sum += static_cast<double>(lux_at(light, stack,
                                              {7.0f * (static_cast<float>(x) + 0.5f) / kSteps - 3.5f, 9,
                                               4.5f * (static_cast<float>(y) + 0.5f) / kSteps - 2.25f}));
    EXPECT_NEAR(sum * 7.0 * 4.5 / (kSteps * kSteps) / static_cast<double>(kLumens), 1.0, 5e-3);
}

// Lens shift moves the picture, and nothing else: as large, as bright.
TEST(Projector, LensShiftMovesThePicture) {
    const GoboStack stack = showing_grey(255);
    Projector shifted = projector();
    shifted.lens_shift = {0.25f, 0.5f}; // a quarter of 6 m to the right, half of 3.375 m up
    const shared::Light light = projector_light(shifted, stack);
    const float expected = kLumens / (6.0f * 3.375f);
    const vec2 middle(1.5f, 1.6875f);
    for (const vec2& at :
         {vec2(0, 0), vec2(2.9f, 1.6f), vec2(-2.9f, 1.6f), vec2(-2.9f, -1.6f), vec2(2.9f, -1.6f)})
        EXPECT_NEAR(lux_at(light, stack, {middle.x + at.x, 9, middle.y + at.y}) / expected, 1.0f, 3e-3f)
            << at.x << " " << at.y;
    for (const vec2& at : {vec2(3.1f, 0), vec2(-3.1f, 0), vec2(0, 1.8f), vec2(0, -1.8f)})
        EXPECT_LT(lux_at(light, stack, {middle.x + at.x, 9, middle.y + at.y}), 1e-2f * expected);
}

// explain's lumens, fraction of the picture and angles: those of the panel, not of a round field.
TEST(Projector, ExplainMeasuresThePicture) {
    Show show;
    show.media.push_back({.name = "film"});
    PatchedFixture fixture;
    fixture.name = "Beamer";
    fixture.type = fixture::video_projector_type();
    fixture.projector = projector();
    fixture.address = 1;
    show.fixtures.push_back(fixture);
    Report report;
    Rig rig(show);
    dmx::Universes universes;
    dmx::Levels levels{};
    levels.fill(255);
    universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
    Reception reception;
    reception.kind = Reception::Kind::recording;
    rig.step(universes, 0.03);
    const auto explained = [&](std::uint8_t grey, int width, int height) {
        const GoboStack stack = showing_grey(grey, width, height);
        ExplainInput input{show, report, rig, stack, universes, reception};
        return Explainer(input).explain(0);
    };
    const Explanation white = explained(255, 64, 36);
    ASSERT_EQ(white.visibility, Visibility::lit) << white.verdict;
    const BeamFacts& beam = white.beams.at(0);
    EXPECT_NEAR(beam.full_lm, kLumens, 0.02f * kLumens);
    EXPECT_NEAR(beam.output_lm, kLumens, 0.02f * kLumens);
    EXPECT_NEAR(beam.picture, 1.0f, 0.01f);
    EXPECT_NEAR(beam.lit_deg.x, glm::degrees(2.0f * std::atan(0.5f / 1.5f)), 1.0f);
    EXPECT_NEAR(beam.lit_deg.y, glm::degrees(2.0f * std::atan(0.28125f / 1.5f)), 1.0f);
    EXPECT_NE(white.verdict.find("picture 3"), std::string::npos) << white.verdict;
    const auto says = [&](const Explanation& explanation, const std::vector<std::string>& parts) {
        const std::string words = words_of(explanation, reception);
        for (const std::string& part : parts)
            EXPECT_NE(words.find(part), std::string::npos) << "'" << part << "' is not in\n" << words;
    };
    says(white, {"projects 'film'", "x picture 100 % = 100", "beam      picture 3", " x 2"});
    EXPECT_EQ(words_of(white, reception).find("deg at half"), std::string::npos) << "it has no round field";
    EXPECT_NEAR(explained(255, 36, 36).beams.at(0).output_lm, 0.5625f * kLumens, 0.02f * kLumens)
        << "a square picture on a panel of 16:9";
    const Explanation black = explained(0, 64, 36);
    EXPECT_EQ(black.cause, Cause::picture) << black.verdict;
    EXPECT_NEAR(black.beams.at(0).full_lm, kLumens, 0.02f * kLumens);
    says(black, {"dark because the picture that it projects is black at this moment: of white it has 0 %",
                 "projects 'film'", "x picture 0 % = 0"});
}

// What is beside the picture on the panel is lit as much as its black.
TEST(Projector, BlackIsNotDark) {
    const GoboStack narrow = showing_grey(255, 36, 36); // 1:1 on a panel of 16:9
    Projector grey = projector();
    grey.contrast = 1000;
    const shared::Light light = projector_light(grey, narrow);
    const float white = lux_at(light, narrow, {0, 9, 0});
    EXPECT_NEAR(lux_at(light, narrow, {2.5f, 9, 0}) / white, 1e-3f, 1e-5f);
    EXPECT_EQ(lux_at(light, narrow, {3.2f, 9, 0}), 0.0f);
    const GoboStack black = showing_grey(0);
    EXPECT_NEAR(lux_at(projector_light(grey, black), black, {0, 9, 0}) / white, 1e-3f, 1e-5f);
}

// The ends of a picture that covers the panel are cut off where the panel ends.
TEST(Projector, CoverFillsThePanelAndNoMore) {
    Projector covering = projector();
    covering.fit = Fit::cover;
    const float expected = kLumens / (6.0f * 3.375f);
    for (const auto& [width, height] : {std::pair{36, 36}, {64, 16}}) {
        const GoboStack stack = showing_grey(255, width, height);
        const shared::Light light = projector_light(covering, stack);
        for (const vec2& at : {vec2(0, 0), vec2(2.9f, 1.6f), vec2(-2.9f, -1.6f)})
            EXPECT_NEAR(lux_at(light, stack, {at.x, 9, at.y}) / expected, 1.0f, 2e-3f) << at.x << " " << at.y;
        for (const vec2& at : {vec2(3.1f, 0), vec2(0, 1.8f), vec2(-3.1f, -1.8f)})
            EXPECT_LT(lux_at(light, stack, {at.x, 9, at.y}), 1e-3f * expected) << at.x << " " << at.y;
    }
}

// On a wall turned about the vertical the picture is a rectangle of the right shape.
TEST(Projector, KeystoneIsRightOnATurnedWall) {
    const GoboStack stack = showing_grey(255);
    for (const vec2& turn_deg : {vec2(25, 0), vec2(0, -20), vec2(15, 20)}) {
        Projector turned = projector();
        turned.keystone_deg = turn_deg;
        const Throw made = throw_of(turned, turned.throw_ratio, stack.showing[0]);
        // Where the picture's corners leave the lens: the inverse of the map, in the frame of the optical
        // axis.
        glm::mat3 rows(made.slide.picture[0], made.slide.picture[1], made.slide.picture[2]);
        const glm::mat3 to_gate = glm::inverse(glm::transpose(rows));
        const vec2 a = glm::radians(turn_deg);
        const vec3 right(std::cos(a.x), 0, std::sin(a.x)), ahead(-std::sin(a.x), 0, std::cos(a.x));
        const vec3 up = std::cos(a.y) * vec3(0, 1, 0) + std::sin(a.y) * ahead;
        const vec3 normal = glm::cross(right, up);
        vec2 on_wall[4];
        for (int corner = 0; corner < 4; ++corner) {
            vec3 gate = to_gate * vec3(corner % 2 ? 1 : -1, corner / 2 ? 1 : -1, 1);
            gate /= gate.z;
            vec3 way = made.turn * vec3(gate.x * made.tan_field, gate.y * made.tan_field, 1.0f);
            EXPECT_LE(std::abs(way.x / way.z), 0.5f / 1.5f + 1e-4f); // on the panel
            EXPECT_LE(std::abs(way.y / way.z), 0.5f / 1.5f / turned.aspect + 1e-4f);
            way *= glm::dot(vec3(0, 0, 9), normal) / glm::dot(way, normal); // a wall through (0, 0, 9)
            on_wall[corner] = {glm::dot(way - vec3(0, 0, 9), right), glm::dot(way - vec3(0, 0, 9), up)};
        }
        const float width = on_wall[1].x - on_wall[0].x, height = on_wall[2].y - on_wall[0].y;
        EXPECT_NEAR(width / height, 16.0f / 9.0f, 1e-3f) << turn_deg.x << " " << turn_deg.y;
        EXPECT_NEAR(on_wall[1].y, on_wall[0].y, 1e-3f * width);
        EXPECT_NEAR(on_wall[3].y, on_wall[2].y, 1e-3f * width);
        EXPECT_NEAR(on_wall[2].x, on_wall[0].x, 1e-3f * width);
        EXPECT_GT(width, 3.0f);
    }
}

// Two pictures side by side, a fifth over each other: nothing shows of the seam.
TEST(Projector, TwoBlendsAddUp) {
    const GoboStack stack = showing_grey(255);
    Projector left = projector(), right = projector();
    left.lens_shift = {-0.4f, 0};
    right.lens_shift = {0.4f, 0}; // 2.4 m each way: 1.2 m of 6 m are over each other
    left.blend = {0, 0.2f, 0, 0};
    right.blend = {0.2f, 0, 0, 0};
    const shared::Light a = projector_light(left, stack), b = projector_light(right, stack);
    const float expected = kLumens / (6.0f * 3.375f);
    for (float x = -2.0f; x <= 2.0f; x += 0.1f)
        EXPECT_NEAR((lux_at(a, stack, {x, 9, 0.3f}) + lux_at(b, stack, {x, 9, 0.3f})) / expected, 1.0f, 5e-3f)
            << x;
}

// A test picture with its upper left quarter white lights the upper left, as people before the wall see it.
TEST(Projector, IsNotMirrored) {
    image::Image8 picture(64, 36, 4);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 4; ++c) picture.at(x, y)[c] = c == 3 || (x < 32 && y < 18) ? 255 : 0;
    const image::Pyramid pyramid = image::make_pyramid(picture, 64);
    GoboStack stack;
    stack.images.slides.push_back({pyramid.side, pyramid.levels});
    stack.showing.push_back({1, pyramid.extent, pyramid.mean, pyramid.side});
    const shared::Light light = projector_light(projector(), stack);
    EXPECT_GT(lux_at(light, stack, {-1.5f, 9, 0.8f}), 400.0f); // the wall is before us, X to the right
    for (const vec2& at : {vec2(1.5f, 0.8f), vec2(-1.5f, -0.8f), vec2(1.5f, -0.8f)})
        EXPECT_LT(lux_at(light, stack, {at.x, 9, at.y}), 1.0f);
}

TEST(Projector, TheRestOfTheGateStillWorks) {
    const GoboStack stack = showing_grey(255);
    const shared::Light open = projector_light(projector(), stack);
    EXPECT_EQ(shared::beam_class(open), shared::kSlideClass);
    const shared::Light dimmed =
        projector_light(projector(), stack, [](fixture::Optics& o) { o.dimmer = 0.5f; });
    EXPECT_NEAR(lux_at(dimmed, stack, {1, 9, 0}) / lux_at(open, stack, {1, 9, 0}), 0.5f, 1e-3f);
    const shared::Light iris = projector_light(projector(), stack, [](fixture::Optics& o) { o.iris = 0.5f; });
    EXPECT_EQ(shared::beam_class(iris), shared::kCutSlideClass);
    // The corners are half a diagonal away: 3.44 m; an iris of a half leaves 1.72 m.
    EXPECT_NEAR(lux_at(iris, stack, {1.4f, 9, 0}) / lux_at(open, stack, {1.4f, 9, 0}), 1.0f, 2e-2f);
    EXPECT_LT(lux_at(iris, stack, {2.1f, 9, 0}), 1.0f);
    const shared::Light cut = projector_light(projector(), stack, [](fixture::Optics& o) {
        o.blades = {{0.5f, 0.5f}, {0, 0}, {0, 0}, {0, 0}}; // the top half
    });
    EXPECT_LT(lux_at(cut, stack, {0, 9, 0.5f}), 1.0f);
    EXPECT_NEAR(lux_at(cut, stack, {0, 9, -0.8f}) / lux_at(open, stack, {0, 9, -0.8f}), 1.0f, 2e-2f);
    // Without a throw ratio the zoom makes the picture's diagonal.
    Projector zooms = projector();
    zooms.throw_ratio = 0;
    const shared::Light wide = projector_light(zooms, stack, [](fixture::Optics& o) { o.zoom_deg = 60; });
    EXPECT_NEAR(wide.tan_field, std::tan(glm::radians(30.0f)), 1e-4f);
}

// Out of focus a picture keeps its light.
TEST(Projector, BlurKeepsTheLumens) {
    const GoboStack stack = showing_grey(255);
    for (const float focus_m : {1.0f, 0.3f, 0.1f}) {
        Projector near = projector();
        near.focus_m = focus_m;
        const shared::Light light = projector_light(near, stack);
        const float wide_m = 2.1f * 9 * light.tan_field * light.cut_radius;
        double sum = 0;
        constexpr int kSteps = 400;
        for (int y = 0; y < kSteps; ++y)
            for (int x = 0; x < kSteps; ++x)
                sum +=
                    static_cast<double>(lux_at(light, stack,
                                               {wide_m * ((static_cast<float>(x) + 0.5f) / kSteps - 0.5f), 9,
                                                wide_m * ((static_cast<float>(y) + 0.5f) / kSteps - 0.5f)}));
        const double lumens = sum * std::pow(static_cast<double>(wide_m) / kSteps, 2);
        std::printf("focused at %.1f m: %.4f of its lumens\n", static_cast<double>(focus_m),
                    lumens / static_cast<double>(kLumens));
        EXPECT_NEAR(lumens / static_cast<double>(kLumens), 1.0, focus_m < 0.2f ? 0.08 : 5e-3);
    }
}

TEST(Projector, AimsAtItsTarget) {
    for (const vec3& target : {vec3(0, 9, 3), vec3(-4, -2, 0), vec3(3, 0, 8), vec3(0, 0, -5)}) {
        PatchedFixture fixture;
        fixture.position_m = {1, 0.5f, 4};
        fixture.rotation_deg = rotation_towards(fixture.position_m, target);
        const glm::mat4 world = fixture_to_world(fixture, 0);
        const vec3 way = -glm::normalize(vec3(world[2]));
        EXPECT_GT(glm::dot(way, glm::normalize(target - fixture.position_m)), 0.99999f);
        EXPECT_GE(world[1].z, -1e-5f); // upright
        EXPECT_NEAR(world[0].z, 0.0f, 1e-5f);
    }
}

constexpr std::string_view kBegin = "[show]\nname = \"x\"\nstage = \"x.glb\"\n[[camera]]\nname = \"c\"\n"
                                    "position_m = [0, -10, 2]\ntarget_m = [0, 0, 2]\n";

ParsedShow parsed(const std::string& text, Report& report) {
    return must(parse_show(std::string(kBegin) + text, "/shows/x/show.toml", report));
}

TEST(ProjectorFile, IsRead) {
    Report report;
    const ParsedShow show =
        parsed("[[media]]\nname = \"sea\"\nfile = \"sea.mp4\"\nloop = false\nstart_s = 12\n"
               "[[media]]\nname = \"cam\"\ncamera = \"/dev/video0\"\n"
               "[[media]]\nname = \"card\"\ncard = \"bars\"\n"
               "[[fixture]]\nname = \"P\"\nposition_m = [0, 0, 5]\nprojector = { media = \"cam\", lumens = "
               "12000, throw_ratio = 0.8, lens_shift = [0, 0.5], keystone_deg = [0, 10], contrast = "
               "500, edge_blend = [0.1, 0, 0, 0], fit = \"cover\", target_m = [0, 9, 3], focus_m = 9, "
               "select = { universe = 2, address = 7 } }\n",
               report);
    for (const Message& message : report.messages)
        EXPECT_NE(message.severity, Severity::error) << message.what;
    ASSERT_EQ(show.show.media.size(), 3u);
    EXPECT_EQ(show.show.media[0].file, "/shows/x/sea.mp4");
    EXPECT_FALSE(show.show.media[0].loop);
    EXPECT_EQ(show.show.media[1].file, "/dev/video0");
    EXPECT_EQ(show.show.media[2].kind, MediaKind::card);
    ASSERT_EQ(show.show.fixtures.size(), 1u);
    const Projector& projector = *show.show.fixtures[0].projector;
    EXPECT_EQ(projector.media, 1);
    EXPECT_FLOAT_EQ(projector.throw_ratio, 0.8f);
    EXPECT_EQ(projector.fit, Fit::cover);
    EXPECT_EQ(projector.address, 7);
    EXPECT_NE(show.show.fixtures[0].rotation_deg, vec3(0.0f));
}

TEST(ProjectorFile, WhatIsWrongIsSaid) {
    Report report;
    const ParsedShow show =
        parsed("[[media]]\nname = \"sea\"\nfile = \"sea.mp4\"\n"
               "[[media]]\nname = \"odd\"\ncard = \"cat\"\n"
               "[[fixture]]\nname = \"P\"\nposition_m = [0, 0, 5]\nprojector = { media = \"see\", lumens = "
               "-1, throw_ratio = 0, fit = \"big\", colour = 1 }\n",
               report);
    std::string all;
    for (const Message& message : report.messages) all += message.where + ": " + message.what + "\n";
    for (const char* part :
         {"'see'", "did you mean 'sea'", "lumens", "throw_ratio", "'big'", "'cat'", "colour", "show.toml:"})
        EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
    const int card = show.show.fixtures[0].projector->media; // something to see is better than the wrong film
    EXPECT_EQ(show.show.media[static_cast<std::size_t>(card)].kind, MediaKind::card);
}

// A channel chooses the film.
TEST(ProjectorFile, TheDeskChoosesTheMedium) {
    Report report;
    Show show = parsed("[[media]]\nname = \"a\"\ncard = \"white\"\n[[media]]\nname = \"b\"\ncard = \"bars\"\n"
                       "[[fixture]]\nname = \"P\"\nposition_m = [0, 0, 5]\nprojector = { media = \"b\", "
                       "select = { universe = 1, "
                       "address = 10 } }\n",
                       report)
                    .show;
    show.fixtures[0].type = fixture::video_projector_type();
    Rig rig(show);
    GoboStack stack = showing_grey(255);
    stack.images.slides.push_back(stack.images.slides[0]);
    stack.showing.push_back(stack.showing[0]);
    const auto layer_at = [&](std::uint8_t level) {
        dmx::Universes universes;
        auto levels = std::make_shared<dmx::Levels>();
        levels->fill(0);
        (*levels)[9] = level;
        universes.at(1).levels = levels;
        rig.step(universes, 0.04);
        return rig.lights(stack, DistanceMaps{}).at(0).slide.layer;
    };
    EXPECT_EQ(layer_at(0), 2u);
    EXPECT_EQ(layer_at(1), 1u);
    EXPECT_EQ(layer_at(2), 2u);
    EXPECT_EQ(layer_at(255), 2u); // there are two
}

} // namespace
} // namespace ghost::scene
