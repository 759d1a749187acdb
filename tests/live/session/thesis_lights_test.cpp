// SPDX-License-Identifier: Apache-2.0
// "It is impossible to identify in and out intersection points, thus each light source must be rendered
// separately" (the thesis, 10.4.5), and "the algorithm is probably inappropriate" for 400 fixtures (11).
// Beams that cross are the sum of each alone, with their shadows, and so are 64 and 200 lights at once.
#include "support/thesis_scene.h"

#include <numeric>
#include <random>

namespace ghost::app {
namespace {

using glm::vec3;

constexpr int kLightsWidth = 96;
constexpr int kLightsHeight = 54;

// Three beams through each other and through the eye's own cone: one of them comes at the camera.
std::vector<shared::Light> crossing() {
    std::vector<shared::Light> lights{aimed_light({-4, 3, 6}, {3, 2, 0.5f}, 14, true),
                                      aimed_light({4, 3, 6}, {-3, 2, 0.5f}, 22, true),
                                      aimed_light({0, 5, 6.5f}, {0.3f, -12, 3}, 16, true)};
    lights[0].intensity_cd = 8000.0f * vec3(1, 0.25f, 0.15f);
    lights[1].intensity_cd = 8000.0f * vec3(0.15f, 0.35f, 1);
    lights[2].intensity_cd = 150.0f * vec3(0.5f, 1, 0.4f);
    return lights;
}

std::vector<shared::Light> many(int count) {
    std::mt19937 random(4);
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    std::vector<shared::Light> lights;
    for (int k = 0; k < count; ++k) {
        const int row = k / 16;
        const vec3 from_m(-6 + 0.8f * static_cast<float>(k % 16), 3 + 0.5f * static_cast<float>(row % 10),
                          6.5f);
        const vec3 to_m(-6 + 12 * unit(), -2 + 6 * unit(), 0);
        lights.push_back(aimed_light(from_m, to_m, 4 + 16 * unit(), k % 3 != 0));
        lights.back().intensity_cd = 3000.0f * vec3(0.2f + unit(), 0.2f + unit(), 0.2f + unit());
    }
    return lights;
}

// Half floats are rounded once for each light.
void expect_sum(const image::ImageF& all, const std::vector<double>& sum, double steps) {
    double worst = 0;
    std::size_t lit = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) {
        ASSERT_TRUE(std::isfinite(all.samples[k]));
        lit += sum[k] > 1e-3 ? 1 : 0;
        // 11 bits, and what is below the smallest normal number of a half float.
        worst = std::max(worst,
                         std::abs(static_cast<double>(all.samples[k]) - sum[k]) / (sum[k] / 2048 + 6.2e-5));
    }
    std::printf("lit samples: %zu of %zu; farthest from the sum: %.2f steps of a half float\n", lit,
                sum.size(), worst);
    EXPECT_GT(lit, sum.size() / 10);
    EXPECT_LE(worst, steps);
}

TEST(thesis_lights, CrossingBeamsAreTheSumOfEachAlone) {
    LiveStage stage(small_stage(), crossing(), kLightsWidth, kLightsHeight, bench_settings(), 512);
    for (const LiveStage::Eye& eye : {kHouse, LiveStage::Eye{{0, 2, 2.6f}, {2, 4, 3}, 70},
                                      LiveStage::Eye{{-3.2f, 2.9f, 5.3f}, {3, 2, 0.5f}, 50}}) {
        stage.look(eye);
        const image::ImageF all = stage.draw();
        std::vector<double> sum(all.samples.size(), 0.0);
        int seen = 0;
        for (std::size_t light = 0; light < 3; ++light) {
            const image::ImageF one = stage.draw_alone(light);
            seen += mean_of(one) > 0 ? 1 : 0;
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += static_cast<double>(one.samples[k]);
        }
        EXPECT_GE(seen, 2);
        expect_sum(all, sum, 4);
    }
}

TEST(thesis_lights, CrossingBeamsAreTheReference) {
    LiveStage stage(small_stage(), crossing(), kLightsWidth, kLightsHeight, haze_only(), 1024);
    stage.look(kHouse);
    const Likeness found = likeness(stage.draw(), stage.reference(512));
    std::printf("three beams crossing: %.1f dB, bias %.3f %%\n", found.psnr_db, 100 * found.bias);
    EXPECT_GE(found.psnr_db, 55.0);
    EXPECT_LT(std::abs(found.bias), 0.002);
}

// Drawn one by one, each into a picture of its own, and all in one frame: with lights changing, resting and
// coming back, whatever the light tree keeps.
TEST(thesis_lights, SixtyFourAtOnceAreTheSumOfEachAlone) {
    constexpr std::size_t kLights = 64;
    LiveStage stage(small_stage(), many(kLights), kLightsWidth, kLightsHeight, bench_settings(), 64);
    stage.look(kHouse);
    const image::ImageF all = stage.draw();
    EXPECT_EQ(stage.statistics.drawn, static_cast<int>(kLights));
    std::vector<double> sum(all.samples.size(), 0.0);
    for (std::size_t light = 0; light < kLights; ++light) {
        const image::ImageF one = stage.draw_alone(light);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += static_cast<double>(one.samples[k]);
    }
    expect_sum(all, sum, 12);
    EXPECT_NEAR(mean_of(all) /
                    (std::accumulate(sum.begin(), sum.end(), 0.0) / static_cast<double>(sum.size())),
                1, 2e-3);
    const Likeness again = likeness(stage.draw(), all);
    EXPECT_GE(again.psnr_db, 60.0);
}

TEST(thesis_lights, DISABLED_Picture) {
    ASSERT_TRUE(picture_folder()) << "GHOST_THESIS_PICTURES: the folder to write to";
    LiveStage three(small_stage(), crossing(), kPictureWidth, kPictureHeight, picture_settings(2), 1024);
    three.look(kHouse);
    three.draw();
    write_picture("crossing", three.relighter().picture());
    LiveStage all(small_stage(), many(200), kPictureWidth, kPictureHeight, picture_settings(4), 512);
    all.look(kHouse);
    all.draw();
    write_picture("many-lights", all.relighter().picture());
}

} // namespace
} // namespace ghost::app
