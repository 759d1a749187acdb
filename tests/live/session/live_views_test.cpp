// SPDX-License-Identifier: Apache-2.0
// The gate's haze among the things of the demo stage, with shadows, against the brute force of the reference:
// canned views, one or two lights each.
#include "light/bodies.h"
#include "reference/reference.h"
#include "show/show.h"
#include "show_folder/load_show.h"
#include "support/demo_copy.h"
#include "support/likeness.h"
#include "support/live_picture.h"

#include "support/test_view.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <string_view>

namespace ghost::app {
namespace {

using glm::vec3;

struct CannedView {
    const char* name;
    vec3 eye_m;
    vec3 target_m;
    float fov_y_deg;
    std::vector<shared::Light> lights;
};

std::vector<CannedView> canned_views() {
    const vec3 house_m(0, -15.5f, 4.2f), onto_stage_m(0, 3, 3.2f);
    std::vector<CannedView> views;
    const auto add = [&](const char* name, const vec3& eye_m, const vec3& target_m, float fov_y_deg,
                         std::vector<shared::Light> lights) {
        views.push_back({name, eye_m, target_m, fov_y_deg, std::move(lights)});
    };
    const auto gobo = [](shared::Light light) {
        render::put_gobo(light, 1, 20);
        return light;
    };
    const auto two_gobos = [&](shared::Light light) {
        light = gobo(light);
        render::put_gobo(light, 2, 50);
        return light;
    };
    add("through a truss", {-4, -3, 2}, {1, 6, 5}, 50,
        {render::aimed_light({-5.2f, 9.5f, 8.2f}, {1, 2, 1}, 24, 8000)});
    add("behind the drum kit", {0, -6, 2}, {0, 4, 2}, 40,
        {render::aimed_light({0, 7.4f, 5.5f}, {0, 0, 0.5f}, 26, 8000)});
    add("into the camera", house_m, onto_stage_m, 24,
        {render::aimed_light({3, 7.4f, 6}, house_m + vec3(0, 0, 2.5f), 16, 3000)});
    add("camera inside the cone", {-1.75f, -0.7f, 1.75f}, {-0.75f, 5, 3.2f}, 56,
        {render::aimed_light({0, 7.4f, 6}, {-1.5f, -0.5f, 1.8f}, 26, 3000)});
    add("narrow, 2 degrees", {-5, 0, 4}, {-3, 7, 4}, 50,
        {render::aimed_light({-5.2f, 7.4f, 6}, {4, 0, 0}, 2, 40000)});
    add("wide, 40 degrees", {-11, -8.5f, 7.4f}, {1, 3.8f, 2.8f}, 44,
        {render::aimed_light({0, 7.4f, 6}, {0, 0, 0}, 40, 8000)});
    add("gobo", house_m, onto_stage_m, 24,
        {gobo(render::aimed_light({5.2f, 7.4f, 6}, {-2, 1, 0}, 24, 8000))});
    add("soft wash", house_m, onto_stage_m, 24,
        {render::aimed_light({-4.6f, 0, 6}, {2, 5, 1}, 40, 8000, false)});
    add("floor light upwards", {-11, -8.5f, 7.4f}, {1, 3.8f, 2.8f}, 44,
        {render::aimed_light({-2.5f, 1, 1.7f}, {-1.5f, 3, 8}, 14, 8000)});
    add("two gobos", {-11, -8.5f, 7.4f}, {1, 3.8f, 2.8f}, 44,
        {two_gobos(render::aimed_light({5.2f, 7.4f, 6}, {-2, 1, 0}, 26, 8000))});
    add("two lights crossing", house_m, onto_stage_m, 24,
        {render::aimed_light({-5.2f, 7.4f, 6}, {3, 1, 0}, 12, 8000),
         gobo(render::aimed_light({5.2f, 7.4f, 6}, {-3, 1, 0}, 20, 8000))});
    return views;
}

// Pixels through which one surface is seen, or none: there haze ends at one distance. The live haze ends at
// the main fragment of a pixel, so that silhouettes are another matter (docs/measurements/live-accuracy.md).
std::vector<std::uint8_t> away_from_silhouettes(const bake::Tracer& tracer, const scene::Camera& camera) {
    const bake::DenormalsOff mode;
    const glm::mat4 world = scene::camera_to_world(camera);
    const float tan_y = std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
    const float tan_x = tan_y * static_cast<float>(camera.width) / static_cast<float>(camera.height);
    std::vector<std::uint8_t> counts;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            float nearest_m = 1e9f, farthest_m = 0;
            for (int k = 0; k < 25; ++k) {
                const int row = k / 5;
                const float px = static_cast<float>(x) + static_cast<float>(k % 5) / 4.0f;
                const float py = static_cast<float>(y) + static_cast<float>(row) / 4.0f;
                const vec3 way = glm::normalize(
                    glm::mat3(world) * vec3(tan_x * (2.0f * px / static_cast<float>(camera.width) - 1.0f),
                                            tan_y * (1.0f - 2.0f * py / static_cast<float>(camera.height)),
                                            -1.0f));
                const bake::Surface hit =
                    tracer.first_hit(camera.position_m, way, -1.0f, bake::Sees::everything);
                const float distance_m = hit.instance < 0 ? 60.0f : hit.distance_m;
                nearest_m = std::min(nearest_m, distance_m);
                farthest_m = std::max(farthest_m, distance_m);
            }
            counts.push_back(farthest_m < 1.05f * nearest_m ? 1 : 0);
        }
    return counts;
}

// All but the 4 pixels round each lamp: there haze is as bright as the ray comes near, and a body of
// centimetres ends it.
std::vector<std::uint8_t> away_from_lamps(const scene::Camera& camera,
                                          const std::vector<shared::Light>& lights) {
    const glm::mat4 to_camera = glm::inverse(scene::camera_to_world(camera));
    const float per_px =
        2 * std::tan(glm::radians(camera.fov_y_deg) * 0.5f) / static_cast<float>(camera.height);
    std::vector<std::uint8_t> counts;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            float nearest_px = 1e9f;
            for (const shared::Light& light : lights) {
                const vec3 at = vec3(to_camera * glm::vec4(light.position_m, 1));
                if (at.z >= 0) continue;
                const glm::vec2 lamp_px(at.x / (-at.z * per_px) + 0.5f * static_cast<float>(camera.width),
                                        at.y / (at.z * per_px) + 0.5f * static_cast<float>(camera.height));
                nearest_px = std::min(nearest_px, glm::distance(lamp_px, glm::vec2(x, y) + 0.5f));
            }
            counts.push_back(nearest_px > 4 ? 1 : 0);
        }
    return counts;
}

// Where counts is 1; everywhere where it is empty.
Likeness figures(const image::ImageF& ours, const image::ImageF& reference,
                 const std::vector<std::uint8_t>& counts) {
    image::PicturePair pair = pair_of(ours, reference);
    if (!counts.empty()) {
        pair.counts = counts;
        pair.counted = static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 1));
    }
    return likeness(pair);
}

TEST(live_views, HazeAmongThingsAgreesWithTheReference) {
    Report report;
    auto show = scene::load_show(DemoCopy::show(), true, report);
    ASSERT_TRUE(show.ok()) << show.error().text();
    scene::Stage stage = scene::stage_with_bodies(*show, report);
    // Haze alone is compared: what shines by itself would be in the live picture only.
    for (scene::Material& material : stage.materials) material.emission = vec3(0);
    const bake::Tracer tracer(stage);
    const render::StageModel model(device(), stage, report);
    const shared::Haze haze{0.022f, 0.022f, 0.77f, -0.6f, 0.035f};
    for (CannedView& view : canned_views()) {
        SCOPED_TRACE(view.name);
        scene::Camera camera;
        camera.position_m = view.eye_m;
        camera.target_m = view.target_m;
        camera.fov_y_deg = view.fov_y_deg;
        camera.width = 96;
        camera.height = 54;
        bake::ReferenceOptions options;
        options.surfaces = false;
        const auto reference = [&](int air_samples, int pixel_samples) {
            options.air_samples = air_samples;
            options.pixel_samples = pixel_samples;
            return must(bake::reference_picture(&tracer, camera, view.lights, render::test_gobos(), haze, 0,
                                                options));
        };
        const std::vector<std::uint8_t> counts = away_from_silhouettes(tracer, camera);
        const scene::DistanceMaps usual = trace_maps(tracer, view.lights, scene::kDistanceMapSize),
                                  fine = trace_maps(tracer, view.lights, 2048);
        const auto drawn = [&](const scene::DistanceMaps& maps, int supersample) {
            LiveScene live{model, camera, view.lights, render::test_gobos(), maps, {}};
            live.settings.haze = haze;
            live.settings.surfaces = false;
            return live_picture(live, supersample);
        };
        const image::ImageF middles = reference(1024, 1);
        const Likeness away = figures(drawn(usual, 1), middles, counts);
        const Likeness sharp = figures(drawn(fine, 1), middles, counts);
        // All pixels, as a still is drawn: each the mean of what it shows.
        const Likeness whole =
            figures(drawn(fine, 4), reference(128, 4), away_from_lamps(camera, view.lights));
        std::printf(
            "%-24s away from silhouettes (%2.0f %% of pixels): map 512 %4.1f dB, bias %6.3f %%, map 2048 "
            "%4.1f dB, bias %6.3f %%; all but 4 px round lamps, 4 x as large: %4.1f dB, bias %6.2f %%\n",
            view.name,
            100.0 * static_cast<double>(std::count(counts.begin(), counts.end(), 1)) /
                static_cast<double>(counts.size()),
            away.psnr_db, 100 * away.bias, sharp.psnr_db, 100 * sharp.bias, whole.psnr_db, 100 * whole.bias);
        // Twice what was measured for most; three views have more, see docs/measurements/live-accuracy.md.
        const std::string_view name = view.name;
        const bool two_gobos = name == "two gobos";
        EXPECT_GE(away.psnr_db, 44.0);
        EXPECT_LT(std::abs(away.bias), name == "through a truss" ? 0.009 : two_gobos ? 0.006 : 0.004);
        EXPECT_GE(sharp.psnr_db, 46.5);
        EXPECT_LT(std::abs(sharp.bias), two_gobos ? 0.009 : 0.003);
        EXPECT_GE(whole.psnr_db, 50.0);
        EXPECT_LT(std::abs(whole.bias), two_gobos                    ? 0.012
                                        : name.starts_with("narrow") ? 0.009
                                        : name == "through a truss"  ? 0.006
                                                                     : 0.004);
    }
}

} // namespace
} // namespace ghost::app
