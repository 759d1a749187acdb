// SPDX-License-Identifier: Apache-2.0
// Silhouettes: relit passes against the same spots traced directly. Known from Cycles: 38-40 dB with one
// position per pixel.
#include "passes/relight_cpu.h"
#include "reference/trace_lit.h"
#include "support/likeness.h"
#include "support/test_stage.h"

#include <cstdio>
#include <gtest/gtest.h>

namespace ghost::bake {
namespace {

Surface hit_at(float distance_m) {
    Surface surface;
    surface.instance = 0;
    surface.distance_m = distance_m;
    return surface;
}

TEST(Fragments, SilhouetteParts) {
    const std::vector<Surface> samples = {hit_at(10), hit_at(20), hit_at(10.001f), hit_at(20.001f),
                                          hit_at(20.002f)};
    std::vector<int> part(5);
    ASSERT_EQ(split_into_fragments(samples, 0.001f, part), 2);
    EXPECT_EQ(part, (std::vector<int>{1, 0, 1, 0, 0})); // the larger share is the main one
}

TEST(Fragments, FlatSurfaceStaysWhole) {
    const std::vector<Surface> samples = {hit_at(10), hit_at(10.005f), hit_at(10.01f), Surface{}};
    std::vector<int> part(4);
    ASSERT_EQ(split_into_fragments(samples, 0.001f, part), 1);
    EXPECT_EQ(part, (std::vector<int>{0, 0, 0, -1}));
}

TEST(Fragments, NeverMoreThanFour) {
    std::vector<Surface> samples;
    for (int k = 0; k < 16; ++k) samples.push_back(hit_at(1.0f + static_cast<float>(k)));
    std::vector<int> part(16);
    EXPECT_EQ(split_into_fragments(samples, 0.001f, part), kMaxFragments);
    for (const int p : part) EXPECT_TRUE(p >= 0 && p < kMaxFragments);
}

TEST(Fragments, NothingHit) {
    const std::vector<Surface> samples(3);
    std::vector<int> part(3);
    EXPECT_EQ(split_into_fragments(samples, 0.001f, part), 0);
}

TEST(Fragments, RelitSpotsMatchDirectTracing) {
    const scene::Stage stage = edgy_stage();
    const scene::Camera camera = edgy_camera(320, 180);
    const std::vector<glm::vec3> lights_m = {{-3, 1, 6.5f}, {3, 1, 6.5f}, {0, 9, 6.5f}};
    const Tracer tracer(stage);
    FrameRequest request;
    request.spp = 32;
    request.lights_m = lights_m;
    std::uint64_t rays = 0;
    const Frame frame = trace_frame(tracer, camera, request, rays);
    const std::vector<shared::Light> lights = {spot(lights_m[0], {-1, 5, 1}, 11, 0),
                                               spot(lights_m[1], {2, 9, 1}, 9, 1),
                                               spot(lights_m[2], {0, 4, 0}, 14, 2)};
    const shared::Gobos gobos;
    const shared::Haze haze{0.02f, 0.02f, 0.77f, -0.6f, 0.03f};
    const image::ImageF direct = trace_lit(stage, camera, lights, gobos, request.spp, haze);
    const image::ImageF other = trace_lit(stage, camera, lights, gobos, 256, haze, 7);
    const image::ImageF plain =
        scene::relight_cpu(plain_passes_of(frame, camera, lights_m), lights, gobos, haze);
    const image::ImageF ours = scene::relight_cpu(passes_of(frame, camera, lights_m), lights, gobos, haze);
    const double plain_db = display_psnr(plain, direct);
    const double ours_db = display_psnr(ours, direct);
    std::printf("same samples: one position a pixel %.1f dB, fragments %.1f dB; extra fragments %.1f %% of "
                "the pixels\n",
                plain_db, ours_db,
                100.0 * frame.extra_first.back() / static_cast<double>(direct.samples.size() / 3));
    std::printf(
        "against 256 other samples: one position %.1f dB, fragments %.1f dB, direct at this spp %.1f dB\n",
        display_psnr(plain, other), display_psnr(ours, other), display_psnr(direct, other));
    EXPECT_GE(ours_db, 45.0);
    EXPECT_LT(plain_db, 42.0); // else the scene has no hard edges and the test above says nothing
}

} // namespace
} // namespace ghost::bake
