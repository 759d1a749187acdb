// SPDX-License-Identifier: Apache-2.0
// Haze of wide beams at every 2nd or 4th ray against the same haze at every ray.
#include "render/haze/wide_beams.h"
#include "support/likeness.h"
#include "support/test_view.h"

#include <cstdio>

namespace ghost::render {
namespace {

using glm::vec3;

using BeamResolution = RelightTest;

constexpr float kBackWall_m = 6.0f;

scene::Camera camera(int width, int height) {
    return camera_at({1, -9, 2.2f}, {0.4f, 2, 3.2f}, 26, width, height);
}

// Wall passes in which near(x, y) pixels show a plane at 2 m before the camera.
scene::Passes passes_with(int width, int height, const std::function<bool(int, int)>& near) {
    scene::Passes passes = wall_passes(camera(width, height), kBackWall_m);
    const scene::Passes front = wall_passes(camera(width, height), -7.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto p = static_cast<std::size_t>(y * width + x);
            if (near(x, y)) passes.fragments[p] = front.fragments[p];
        }
    return passes;
}

bool nowhere(int, int) {
    return false;
}

// Two wide beams, with and without a gobo, and a narrow one; all pass behind the plane at y = -7.
std::vector<shared::Light> beams() {
    std::vector<shared::Light> lights{aimed_light({-4, 1, 6}, {2, 0.5f, 0}, 38, 2000),
                                      aimed_light({4, 2, 6}, {-1, 1, 0.5f}, 34, 1500, false),
                                      aimed_light({0, 3, 6.5f}, {0.6f, 0, 0}, 1.2f, 5000)};
    put_gobo(lights[0], 2, 20);
    for (shared::Light& light : lights) light.pass = 0;
    return lights;
}

enum class Scope { all, wide, narrow };

struct Drawing {
    int width = 232; // neither a multiple of a tile nor of four
    int height = 130;
    std::uint32_t batch = 0;
    Scope scope = Scope::all;
    std::function<bool(int, int)> near = nowhere;
};

image::ImageF drawn(std::uint32_t step, const Drawing& drawing, std::uint32_t most_step = 4) {
    const scene::Passes passes = passes_with(drawing.width, drawing.height, drawing.near);
    Settings settings;
    settings.haze = kHaze;
    settings.surfaces = false;
    settings.lights_per_dispatch = drawing.batch;
    settings.beams.most_wide_step = most_step;
    std::vector<shared::Light> lights = beams();
    if (drawing.scope == Scope::wide) lights.resize(2);
    if (drawing.scope == Scope::narrow) lights.erase(lights.begin(), lights.begin() + 2);
    Relighter relighter(device(), passes, test_gobos(), static_cast<int>(lights.size()), settings);
    if (most_step > 1) {
        HazeQuality quality;
        quality.wide_beam_step = step;
        relighter.set_quality(quality);
    }
    relighter.draw(lights);
    return relighter.frame();
}

// Of linear light, the brightest being 1.
double psnr_db(const image::ImageF& picture, const image::ImageF& reference) {
    const float most = *std::max_element(reference.samples.begin(), reference.samples.end());
    return image::psnr_db(pair_of(picture, reference), [&](const vec3& value) { return value / most; });
}

// Worst difference of a pixel from another picture, as a fraction of the brightest.
double worst(const image::ImageF& a, const image::ImageF& b, const std::function<bool(int, int)>& counts) {
    double difference = 0, most = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                most = std::max(most, static_cast<double>(b.at(x, y)[c]));
                if (!counts(x, y)) continue;
                difference =
                    std::max(difference, static_cast<double>(std::abs(a.at(x, y)[c] - b.at(x, y)[c])));
            }
    return difference / most;
}

TEST_F(BeamResolution, narrow_beams_and_full_quality_keep_every_bit) {
    const image::ImageF plain = drawn(1, {}, 1);
    EXPECT_EQ(drawn(1, {}).samples, plain.samples);
    const Drawing narrow{.scope = Scope::narrow};
    EXPECT_EQ(drawn(2, narrow).samples, drawn(1, narrow).samples);
    EXPECT_EQ(drawn(4, narrow).samples, drawn(1, narrow).samples);
    EXPECT_NE(drawn(2, {}).samples, plain.samples);
}

TEST_F(BeamResolution, the_rays_that_are_drawn_are_exact) {
    const Drawing wide{.scope = Scope::wide};
    const image::ImageF full = drawn(1, wide);
    for (const std::uint32_t step : {2u, 4u}) {
        const int every = static_cast<int>(step);
        const double off =
            worst(drawn(step, wide), full, [&](int x, int y) { return x % every == 0 && y % every == 0; });
        EXPECT_LT(off, 0.001) << step; // half floats
    }
}

TEST_F(BeamResolution, pixels_between_are_near_the_truth) {
    for (const std::uint32_t batch : {1u, shared::kLightsPerChunk}) {
        const Drawing all{.batch = batch};
        const image::ImageF full = drawn(1, all);
        const double half = psnr_db(drawn(2, all), full), quarter = psnr_db(drawn(4, all), full);
        std::printf("[ half    ] %.1f dB, quarter %.1f dB\n", half, quarter);
        EXPECT_GT(half, 40);
        EXPECT_GT(quarter, 33);
    }
}

TEST_F(BeamResolution, both_ways_to_dispatch_agree) {
    const auto bars = [](int x, int) { return x % 11 == 3; };
    for (const std::uint32_t step : {2u, 4u}) {
        const image::ImageF one = drawn(step, {.batch = 1, .near = bars});
        const image::ImageF many = drawn(step, {.batch = shared::kLightsPerChunk, .near = bars});
        EXPECT_LT(worst(many, one, [](int, int) { return true; }), 0.002) << step;
    }
}

// Bars of one, two and three pixels before the beams: the haze on them is that before them, next to none.
TEST_F(BeamResolution, edges_of_things_before_the_beams_stay_sharp) {
    const auto bars = [](int x, int y) {
        const int place = x % 29;
        return place == 3 || place == 10 || place == 11 || (place > 17 && place < 21) ||
               (y > 60 && x + y > 200);
    };
    const image::ImageF full = drawn(1, {.near = bars});
    for (const std::uint32_t step : {2u, 4u}) {
        const image::ImageF picture = drawn(step, {.near = bars});
        const double on_bars = worst(picture, full, bars);
        std::printf("[ step %u  ] off by %.4f on the bars, %.4f between, %.1f dB\n", step, on_bars,
                    worst(picture, full, [&](int x, int y) { return !bars(x, y); }), psnr_db(picture, full));
        EXPECT_LT(on_bars, 0.01) << step;
        EXPECT_GT(psnr_db(picture, full), step == 2 ? 40 : 33) << step;
    }
}

// Every pixel another depth than its neighbours: nothing to spread, every pixel gets its own ray.
TEST_F(BeamResolution, lonely_pixels_are_exact) {
    std::mt19937 random(3);
    std::vector<bool> near(232 * 130);
    for (std::size_t k = 0; k < near.size(); ++k) near[k] = random() % 16 == 0;
    const auto dust = [&](int x, int y) { return near[static_cast<std::size_t>(y * 232 + x)]; };
    const image::ImageF full = drawn(1, {.near = dust});
    for (const std::uint32_t step : {2u, 4u})
        EXPECT_LT(worst(drawn(step, {.near = dust}), full, dust), 0.02) << step;
}

TEST_F(BeamResolution, any_size_of_picture) {
    for (const auto& [width, height] : {std::pair{16, 16}, {17, 9}, {31, 23}, {64, 8}, {1, 1}, {3, 50}}) {
        const Drawing small{.width = width, .height = height};
        const image::ImageF full = drawn(1, small);
        for (const std::uint32_t step : {2u, 4u}) {
            const image::ImageF picture = drawn(step, small);
            double sum = 0, sum_full = 0;
            for (std::size_t k = 0; k < full.samples.size(); ++k) {
                sum += static_cast<double>(picture.samples[k]);
                sum_full += static_cast<double>(full.samples[k]);
            }
            EXPECT_NEAR(sum, sum_full, 0.15 * sum_full) << width << "x" << height << " step " << step;
        }
    }
}

TEST_F(BeamResolution, quality_changes_from_frame_to_frame) {
    const scene::Passes passes = passes_with(160, 90, nowhere);
    Settings settings;
    settings.haze = kHaze;
    settings.surfaces = false;
    settings.reuse = false;
    settings.beams.most_wide_step = 4;
    const std::vector<shared::Light> lights = beams();
    Relighter relighter(device(), passes, test_gobos(), 3, settings);
    relighter.draw(lights);
    const image::ImageF full = relighter.frame();
    const auto off_by = [&](const HazeQuality& quality) {
        relighter.set_quality(quality);
        relighter.draw(lights);
        return psnr_db(relighter.frame(), full);
    };
    const double half = off_by({.wide_beam_step = 2}), quarter = off_by({.wide_beam_step = 4});
    const double coarse = off_by({.curvature = 1.1f, .most_segments = 8});
    std::printf("[ 160x90  ] half %.1f dB, quarter %.1f dB, a third of the segments %.1f dB\n", half, quarter,
                coarse);
    EXPECT_GT(half, quarter);
    EXPECT_GT(quarter, 30);
    EXPECT_GT(coarse, 30);
    EXPECT_LT(coarse, 100);
    EXPECT_GT(off_by({}), 100) << "as if nothing had been";
}

TEST_F(BeamResolution, beams_are_wide_by_what_they_cover) {
    const auto wide = [](float field_deg, float away_m, float pixels_per_rad) {
        return is_wide(aimed_light({0, 0, 5}, {0, 0, 0}, field_deg, 1000), {away_m, 0, 1}, pixels_per_rad);
    };
    EXPECT_FALSE(wide(4, 8, 400)); // 0.28 m at 8 m
    EXPECT_TRUE(wide(20, 8, 400));
    EXPECT_FALSE(wide(20, 40, 400));
    EXPECT_TRUE(wide(20, 40, 1600));
    EXPECT_TRUE(wide(4, 0, 400)) << "the eye in the beam";
}

} // namespace
} // namespace ghost::render
