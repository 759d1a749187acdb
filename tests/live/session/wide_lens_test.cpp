// SPDX-License-Identifier: Apache-2.0
// Shadows in the air of what stands right before a large lens: the light comes from an apex far behind it,
// what is in its way is seen from the head's pivot (docs/design/optics.md, "From lens to wall"), and both
// must agree with brute force.
#include "support/thesis_scene.h"

namespace ghost::app {
namespace {

using glm::vec3;

struct Blocked {
    const char* name;
    float field_deg;
    float radius_m;
    vec3 low_m; // of the box in the way; the lens stands at (-4, 2, 4) and shines along x
    vec3 high_m;
};

const LiveStage::Eye kBeside{{0, -9, 4.3f}, {0, 2, 4}, 26};

LiveStage stage_of(const Blocked& blocked) {
    scene::Stage stage = small_stage();
    add_box(stage, blocked.low_m, blocked.high_m);
    shared::Light light = aimed_light({-4, 2, 4}, {4, 2, 4}, blocked.field_deg, true);
    leave_lens(light, blocked.radius_m);
    return LiveStage(std::move(stage), {light}, 128, 72, haze_only(), 2048);
}

TEST(WideLens, WhatStandsBeforeItThrowsItsShadowInTheAir) {
    // Limits a little below what was measured.
    const std::pair<Blocked, double> all[] = {
        {{"bar 1 m before 10 degrees", 10, 0.07f, {-3.025f, 1.5f, 4.02f}, {-2.975f, 2.5f, 4.07f}}, 39.5},
        {{"bar 0.5 m before 4 degrees", 4, 0.1f, {-3.52f, 1.5f, 4.04f}, {-3.48f, 2.5f, 4.08f}}, 39.8},
        {{"plate 0.6 m before 6 degrees", 6, 0.15f, {-3.41f, 1.95f, 3.95f}, {-3.39f, 2.05f, 4.05f}}, 39.0},
        {{"half of 6 degrees", 6, 0.15f, {-3.41f, 1.5f, 4.05f}, {-3.39f, 2.5f, 4.6f}}, 44.0},
    };
    for (const auto& [blocked, least_db] : all) {
        SCOPED_TRACE(blocked.name);
        LiveStage stage = stage_of(blocked);
        stage.look(kBeside);
        const Likeness like = likeness(stage.draw(), stage.reference(2048));
        std::printf("%-30s %.1f dB, bias %.2f %%\n", blocked.name, like.psnr_db, 100 * like.bias);
        EXPECT_GE(like.psnr_db, least_db);
    }
}

// From ahead of the head past a bar, and from within the beam: what is right before the lens is bright, and
// shafts have no facets.
TEST(WideLens, LooksRightFromWithinTheBeam) {
    const LiveStage::Eye eyes[] = {{{-1.8f, 2.3f, 4.1f}, {-3, 1.95f, 4}, 60},
                                   {{1, 2.02f, 4.03f}, {-4, 2.01f, 4}, 40}};
    const double least_db[] = {36, 51};
    const double most_bias[] = {0.08, 0.02}; // rays that skim the bar's edge
    for (int k = 0; k < 2; ++k) {
        SCOPED_TRACE(k);
        LiveStage stage = stage_of({"bar", 8, 0.1f, {-3.02f, 1.5f, 4.04f}, {-2.98f, 2.5f, 4.08f}});
        stage.look(eyes[k]);
        const image::ImageF picture = stage.draw(), reference = stage.reference(2048);
        const Likeness like = likeness(picture, reference);
        std::printf("eye %d: %.1f dB, bias %.2f %%\n", k, like.psnr_db, 100 * like.bias);
        EXPECT_GE(like.psnr_db, least_db[k]);
        EXPECT_LT(std::abs(like.bias), most_bias[k]);
        const float brightest = *std::max_element(reference.samples.begin(), reference.samples.end());
        int black = 0;
        for (std::size_t n = 0; n < reference.samples.size(); ++n)
            black +=
                reference.samples[n] > 0.2f * brightest && picture.samples[n] < 0.02f * brightest ? 1 : 0;
        EXPECT_LE(black, 24); // of three colours: a few pixels of the bar's edge
    }
}

// A floor that the beam skims is lit from the head; from the apex behind it, it would be lit at a lower
// angle: a seventh darker.
TEST(WideLens, SurfacesAreLitFromTheHead) {
    shared::Light light = aimed_light({-4, 2, 0.45f}, {4, 2, 0.45f}, 10, true);
    leave_lens(light, 0.1f);
    light.disc_radius_m = 0; // hard shadows, as in the reference
    render::Settings settings = bench_settings();
    settings.air = false;
    LiveStage live(small_stage(), {light}, 128, 72, settings, 2048);
    live.look({{4, -3, 4}, {4, 2, 0}, 40});
    const Likeness like = likeness(live.draw(), live.reference(1));
    std::printf("floor: %.1f dB, bias %.2f %%\n", like.psnr_db, 100 * like.bias);
    EXPECT_LT(std::abs(like.bias), 0.02);
}

// The same along no axis of the world: a plank that light skims at 2 to 5 degrees does not shadow itself.
TEST(WideLens, PlanksAreLitByLightThatSkimsThem) {
    for (const float rise_deg : {2.0f, 3.0f, 5.0f}) {
        SCOPED_TRACE(rise_deg);
        const glm::mat4 turn = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(vec3(0.3f, -0.8f, 0.4f)));
        const auto placed = [&](const vec3& at_m) { return vec3(turn * glm::vec4(at_m, 1)); };
        scene::Stage stage = empty_stage();
        add_box(stage, {-1, -3, -0.1f}, {12, 3, 0});
        stage.instances.back().world = turn * stage.instances.back().world;
        const float height_m = 8 * std::tan(glm::radians(rise_deg));
        shared::Light light = aimed_light(placed({-2, 0, height_m}), placed({6, 0, 0}), 10, true);
        light.disc_radius_m = 0; // hard shadows, as in the reference
        render::Settings settings = bench_settings();
        settings.air = false;
        LiveStage live(std::move(stage), {light}, 128, 72, settings, 1024);
        live.look({placed({5, -4, 5}), placed({5, 0, 0}), 60});
        const Likeness like = likeness(live.draw(), live.reference(1));
        std::printf("plank at %.0f degrees: %.1f dB, bias %.2f %%\n", static_cast<double>(rise_deg),
                    like.psnr_db, 100 * like.bias);
        EXPECT_LT(std::abs(like.bias), 0.02);
    }
}

// Haze at a silhouette is mended with its neighbours' (shaders/relight/fold.comp): that must not take more
// than is there.
TEST(WideLens, NoPixelIsBlackerThanBlack) {
    LiveStage stage =
        stage_of({"bars between the eye and the beam", 10, 0.07f, {-3.2f, 0.5f, 0}, {-3.1f, 0.6f, 8}});
    for (const render::Beams beams : {render::Beams::cone, render::Beams::march, render::Beams::gate}) {
        render::Settings settings = haze_only();
        settings.beams.beams = beams;
        stage.renew(settings, bench_gobos());
        stage.look(kBeside);
        const image::ImageF picture = stage.draw();
        EXPECT_GE(*std::min_element(picture.samples.begin(), picture.samples.end()), 0.0f);
        EXPECT_GT(mean_of(picture), 0.0);
    }
}

} // namespace
} // namespace ghost::app
