// SPDX-License-Identifier: Apache-2.0
// The real chain on the real demo stage, small: baked, written, read, relit on the GPU, against the same
// beams traced directly. Silhouettes included.
#include "bake/bake_show.h"
#include "dmx/record/player.h"
#include "light/bodies.h"
#include "live/session/session.h"
#include "passes/passes_file.h"
#include "reference/trace_lit.h"
#include "show_folder/load_show.h"
#include "support/demo_copy.h"

#include "support/likeness.h"
#include "support/must.h"
#include "support/one_device.h"
#include "support/test_stage.h"

#include <cstdio>
#include <gtest/gtest.h>

namespace ghost::app {
namespace {

constexpr int kSpp = 16;

struct Demo {
    scene::Show show;
    scene::GoboStack gobos;
    scene::Passes ours;  // read back from disk
    scene::Passes plain; // the paper's own form: whole pictures, the position of the pixel's centre
    scene::Stage stage;

    scene::Camera& camera() { return show.cameras[0]; }
};

Demo& demo() {
    static Demo one = [] {
        Demo made;
        Report report;
        made.show = must(scene::load_show(DemoCopy::show(), true, report));
        made.show.cameras.resize(1);
        // A quarter of the field at a quarter of the pixels, round the singer.
        made.camera().fov_y_deg =
            glm::degrees(2 * std::atan(std::tan(glm::radians(made.camera().fov_y_deg) / 2) / 4));
        made.camera().target_m = {0, 2, 2};
        made.camera().width = 256;
        made.camera().height = 75;
        made.camera().name = "part";
        bake::BakeOptions options;
        options.spp = kSpp;
        const auto baked = bake::bake_show(made.show, options, report);
        EXPECT_TRUE(baked.ok()) << baked.error().text();
        made.ours = must(scene::load_passes(scene::passes_folder(made.show, "part"), true, report));
        made.ours.emission.clear(); // direct tracing has none
        made.gobos = scene::build_gobos(made.show, report);
        made.stage = scene::stage_with_bodies(made.show, report);
        EXPECT_FALSE(report.lost_anything());

        std::vector<glm::vec3> lights_m;
        for (const scene::LightPass& light : made.ours.lights) lights_m.push_back(light.position_m);
        bake::FrameRequest request;
        request.spp = kSpp;
        request.lights_m = lights_m;
        std::uint64_t rays = 0;
        const bake::Frame frame = bake::trace_frame(bake::Tracer(made.stage), made.camera(), request, rays);
        made.plain = bake::plain_passes_of(frame, made.camera(), lights_m);
        for (std::size_t k = 0; k < lights_m.size(); ++k)
            made.plain.lights[k].fixture = made.ours.lights[k].fixture;
        return made;
    }();
    return one;
}

std::vector<shared::Light> lights_at(double t_s) {
    dmx::Player player(must(dmx::read_recording(demo().show.recording)));
    scene::Rig rig(demo().show);
    for (int frame = 0; frame <= static_cast<int>(t_s * 30); ++frame)
        rig.step(player.at(frame / 30.0), 1.0 / 30);
    return rig.lights(demo().gobos, demo().ours);
}

image::ImageF relit_on_gpu(const scene::Passes& passes, const std::vector<shared::Light>& lights,
                           const shared::Haze& haze) {
    render::Settings settings;
    settings.haze = haze;
    settings.air = false;
    render::Relighter relighter(device(), passes, demo().gobos.images, static_cast<int>(lights.size()),
                                settings);
    relighter.draw(lights);
    EXPECT_EQ(device().validation_errors(), 0u);
    return relighter.frame();
}

TEST(relit_demo, SpotsMatchDirectTracing) {
    const shared::Haze haze{0.022f, 0.022f, 0.77f, -0.6f, 0.035f};
    for (const double t_s : {8.0, 50.0, 70.0}) {
        SCOPED_TRACE(std::to_string(t_s) + " s");
        const std::vector<shared::Light> lights = lights_at(t_s);
        const image::ImageF direct =
            bake::trace_lit(demo().stage, demo().camera(), lights, demo().gobos.images, kSpp, haze);
        const double ours_db = display_psnr(relit_on_gpu(demo().ours, lights, haze), direct);
        const double plain_db = display_psnr(relit_on_gpu(demo().plain, lights, haze), direct);
        std::printf("%.0f s: one position a pixel %.1f dB, fragments %.1f dB\n", t_s, plain_db, ours_db);
        EXPECT_GE(ours_db, 45.0);
        EXPECT_GT(ours_db, plain_db + 3.0);
    }
}

// One light on one white wall, through bake, GPU and formula: E = I cos / d^2, L = E albedo / pi.
TEST(relit_demo, BakedWallShowsTheFormula) {
    scene::Stage stage;
    const float albedo = 0.8f;
    bake::place(stage, bake::add_mesh(stage, bake::quad_mesh({-20, 6, -20}, {40, 0, 0}, {0, 0, 40}),
                                      bake::add_material(stage, glm::vec3(albedo))));
    const scene::Camera camera = bake::edgy_camera(64, 40);
    const glm::vec3 at(1, -2, 5);
    bake::FrameRequest request;
    request.spp = 16;
    request.lights_m = {at};
    std::uint64_t rays = 0;
    const bake::Frame frame = bake::trace_frame(bake::Tracer(stage), camera, request, rays);
    const scene::Passes passes = bake::passes_of(frame, camera, request.lights_m);
    shared::Light light = bake::spot(at, {0, 6, 2}, 60, 0);
    light.profile_scale = 1e-6f; // even light
    light.intensity_cd = glm::vec3(5000.0f);
    const image::ImageF picture = relit_on_gpu(passes, {light}, shared::Haze{});
    double worst = 0;
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        const glm::dvec3 way = glm::dvec3(passes.fragments[p]) - glm::dvec3(at);
        const double d2 = glm::dot(way, way);
        const double expected =
            5000.0 * (way.y / std::sqrt(d2)) / d2 * static_cast<double>(albedo) / 3.14159265358979;
        worst = std::max(worst, std::abs(picture.samples[3 * p + 1] / expected - 1.0));
    }
    std::printf("baked white wall against I cos / d^2 albedo / pi: worst error %.3f %%\n", 100 * worst);
    EXPECT_LT(worst, 0.005);
}

} // namespace
} // namespace ghost::app
