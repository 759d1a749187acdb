// SPDX-License-Identifier: Apache-2.0
// Glare keeps the light, follows its source without steps, is round, and falls off as the CIE's function
// does.
#include "support/test_glare.h"

#include <numeric>

namespace ghost::render {
namespace {

using glm::vec3;

using Glare = RelightTest;

constexpr float kPixelsPerRad = 800;
constexpr float kWide = 180; // pixels a radian: the glare's 30 degrees are 94 pixels

image::ImageF glare_of(const image::ImageF& picture, float strength, float pixels_per_rad = kPixelsPerRad) {
    const gpu::Texture frame = picture_of(picture);
    GlarePass glare(device(), frame.shape().width, frame.shape().height, {strength});
    gpu::Commands commands(device());
    commands.begin();
    glare.record(commands, frame, 0.0f, pixels_per_rad);
    glare.see(commands, frame);
    commands.submit_and_wait();
    return read_back(glare.seen(frame));
}

// Of the light that is scattered, what goes farther than a texel of the finest level.
float share_seen(float pixels_per_rad) {
    const std::vector<float> weights = glare_weights(4, pixels_per_rad);
    return std::accumulate(weights.begin(), weights.end(), 0.0f);
}

image::ImageF spot(int width, int height, int x, int y, float light) {
    image::ImageF picture(width, height, 3);
    for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = light;
    return picture;
}

TEST_F(Glare, KeepsTheLight) {
    // A spot farther from the border than the glare reaches.
    for (const auto& [width, height] : {std::pair{1024, 300}, {256, 256}, {333, 261}})
        for (const float strength : {0.1f, 1.0f}) {
            const image::ImageF seen =
                glare_of(spot(width, height, width / 2 + 1, height / 2, 60000), strength, kWide);
            EXPECT_NEAR(sum_of(seen) / 59968.0, 1.0, 0.001) << width << "x" << height << ", " << strength;
        }
}

TEST_F(Glare, AnEvenPictureStaysEvenFarFromItsBorder) {
    image::ImageF even(512, 384, 3);
    for (float& sample : even.samples) sample = 7.5f;
    const image::ImageF seen = glare_of(even, 1.0f, kWide);
    for (int y = 170; y < 214; ++y)
        for (int x = 170; x < 342; ++x) ASSERT_NEAR(seen.at(x, y)[1], 7.5f, 0.02f) << x << ", " << y;
    // At the border nothing comes from beyond; most glare is near, so little is missing.
    EXPECT_LT(seen.at(0, 0)[1], 7.4f);
    EXPECT_GT(seen.at(0, 0)[1], 7.0f);
}

TEST_F(Glare, OddAndTinyPictures) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {37, 23}, {15, 60}, {5, 200}}) {
        const image::ImageF seen = glare_of(spot(width, height, width / 2, height / 2, 100), 0.3f);
        for (const float sample : seen.samples) ASSERT_TRUE(std::isfinite(sample));
        EXPECT_LE(sum_of(seen), 100.2) << width << "x" << height;
        EXPECT_GE(sum_of(seen), 70.0) << width << "x" << height;
    }
}

TEST_F(Glare, OffIsTheFrameItself) {
    const gpu::Texture frame = picture_of(spot(40, 30, 3, 3, 10));
    GlarePass glare(device(), 40, 30, {0.0f});
    gpu::Commands commands(device());
    commands.begin();
    glare.record(commands, frame, 0.0f, kPixelsPerRad);
    glare.see(commands, frame);
    commands.submit_and_wait();
    EXPECT_TRUE(commands.spans().empty());
    EXPECT_EQ(&glare.seen(frame), &frame);
    EXPECT_EQ(glare.memory_bytes(), 0u);
}

TEST_F(Glare, WeightsAreTheCieFunctionOfEachOctave) {
    // Integral of (10 / a^3 + 5 / a^2) a da, by many small steps.
    const auto light = [](double from, double to) {
        double sum = 0;
        constexpr int kSteps = 200000;
        const double step = (to - from) / kSteps;
        for (int k = 0; k < kSteps; ++k) {
            const double a = from + (k + 0.5) * step;
            sum += (10 / (a * a) + 5 / a) * step;
        }
        return sum;
    };
    const double all = light(0.1, 30);
    for (const float pixels_per_rad : {kPixelsPerRad, 1500.0f, 6000.0f}) {
        const std::vector<float> weights = glare_weights(6, pixels_per_rad);
        double sum = 0;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            const double texel_deg =
                std::exp2(static_cast<double>(k + 1)) / double{pixels_per_rad} * 180.0 / 3.14159265358979;
            const double to = k + 1 < weights.size() ? std::max(2 * texel_deg, 0.1) : 30.0;
            EXPECT_NEAR(double{weights[k]}, light(std::max(texel_deg, 0.1), to) / all, 1e-4) << k;
            sum += double{weights[k]};
        }
        const double first_deg = 2.0 / double{pixels_per_rad} * 180.0 / 3.14159265358979;
        EXPECT_NEAR(sum, light(std::max(first_deg, 0.1), 30) / all, 1e-4);
    }
}

// The halo is the camera's: as much light arrives 2 to 10 degrees from a lamp in a coarse picture as in fine
// ones.
TEST_F(Glare, IsTheSameInAFinerPicture) {
    double coarse[2] = {};
    for (const int fine : {1, 2, 4}) {
        const float pixels_per_rad = 240.0f * static_cast<float>(fine);
        const int side = 160 * fine;
        image::ImageF picture(side, side, 3); // of 2x2 pixels around the middle
        for (int k = 0; k < 4; ++k)
            picture.at(side / 2 - 1 + k % 2, side / 2 - 1 + k / 2)[1] =
                4000.0f * static_cast<float>(fine * fine);
        const image::ImageF seen = glare_of(picture, 0.25f, pixels_per_rad);
        double ring[2] = {}; // 2 to 5, 5 to 10 degrees
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const float middle = 0.5f * static_cast<float>(side) - 0.5f;
                const float angle_deg =
                    std::hypot(static_cast<float>(x) - middle, static_cast<float>(y) - middle) /
                    pixels_per_rad * 57.29578f;
                if (angle_deg >= 2 && angle_deg < 10)
                    ring[angle_deg < 5 ? 0 : 1] += double{seen.at(x, y)[1]} / (fine * fine);
            }
        std::printf("x%d: %.1f at 2 to 5 degrees, %.1f at 5 to 10\n", fine, ring[0], ring[1]);
        for (int k = 0; k < 2; ++k) {
            if (fine == 1) coarse[k] = ring[k];
            EXPECT_NEAR(ring[k] / coarse[k], 1.0, 0.2) << fine << ", " << k;
        }
        // 16000 cd/m^2 times pixels, a quarter scattered beyond 0.1 degrees.
        EXPECT_NEAR(ring[0] / (16000 * 0.25 * (10 / 2.0 - 10 / 5.0 + 5 * std::log(2.5)) /
                               (100 - 1.0 / 3 + 5 * std::log(300))),
                    1.0, 0.3);
    }
}

TEST_F(Glare, IsRoundAndFallsWithoutSteps) {
    image::ImageF picture(512, 512, 3); // a spot of 2x2 pixels around (257, 257)
    for (int k = 0; k < 4; ++k) picture.at(256 + k % 2, 256 + k / 2)[1] = 60000;
    const image::ImageF seen = glare_of(picture, 1.0f);
    float last = 1e30f;
    for (const int ring : {4, 8, 16, 32, 64}) {
        float least = 1e30f, most = 0;
        for (int y = 257 - ring - 1; y <= 257 + ring; ++y)
            for (int x = 257 - ring - 1; x <= 257 + ring; ++x) {
                const float r = std::hypot(static_cast<float>(x) - 256.5f, static_cast<float>(y) - 256.5f) /
                                static_cast<float>(ring);
                if (std::abs(r - 1.0f) * static_cast<float>(ring) > 0.5f) continue;
                const float value = seen.at(x, y)[1] * r * r * r;
                least = std::min(least, value);
                most = std::max(most, value);
            }
        std::printf("glare at %2d pixels: %.3g .. %.3g\n", ring, double{least}, double{most});
        EXPECT_LT(most, 1.6f * least) << ring;
        EXPECT_LT(most, last) << ring;
        last = least;
    }
    // To the border and the corner, round.
    EXPECT_GT(seen.at(5, 256)[1], 0);
    EXPECT_NEAR(seen.at(257 + 150, 257 + 150)[1] / seen.at(257 + 212, 257)[1], 1.0f, 0.25f);
    // No texel of any level shows: neighbours differ little.
    for (int x = 264; x < 400; ++x)
        EXPECT_LT(std::abs(std::log(seen.at(x + 1, 256)[1] / seen.at(x, 256)[1])), 0.35) << x;
}

TEST_F(Glare, FollowsASmallLensWithoutFlicker) {
    DarkHall hall(256, 128, 30, 60, {}, {}, {0.5f});
    const float pixel_m = 30.0f / pixels_per_rad(hall.view());
    const double kept = 1.0 - 0.5 * double{share_seen(pixels_per_rad(hall.view()))};
    double least = 1e30, most = 0, step = 0, last_peak = 0, lowest = 1e30, highest = 0;
    for (int k = 0; k <= 40; ++k) {
        const vec3 from(0.1f * static_cast<float>(k) * pixel_m, 30, 0.041f * static_cast<float>(k) * pixel_m);
        shared::Light light = aimed_light(from, {0, 0, 0}, 20, 500.0f);
        light.disc_radius_m = 0.02f;
        hall.draw({light});
        const image::ImageF frame = hall.frame(), seen = hall.seen();
        const double sum = sum_of(seen);
        double peak = 0;
        for (std::size_t i = 0; i < frame.samples.size(); ++i)
            peak = std::max(peak, double{seen.samples[i]} - kept * double{frame.samples[i]});
        least = std::min(least, sum);
        most = std::max(most, sum);
        lowest = std::min(lowest, peak);
        highest = std::max(highest, peak);
        if (k > 0) step = std::max(step, std::abs(peak / last_peak - 1.0));
        last_peak = peak;
    }
    std::printf("moved by 0.1 pixels: light %.3f %%, peak of the glare %.2f %% a step, %.1f %% in all\n",
                100 * (most / least - 1), 100 * step, 100 * (highest / lowest - 1));
    EXPECT_GT(least, 0);
    EXPECT_LT(most / least, 1.01);
    EXPECT_LT(step, 0.06);
}

// A lens a thousand times brighter than a half float holds.
TEST_F(Glare, HasAllLightOfALensThatIsClipped) {
    DarkHall hall(512, 256, 40, 60, {}, {}, {0.02f});
    const shared::Light light = aimed_light({0, 15, 0}, {0, 0, 0}, 8, 1e6f);
    hall.draw({light});
    const image::ImageF frame = hall.frame(), seen = hall.seen();
    double scattered = 0;
    for (std::size_t i = 1; i < frame.samples.size(); i += 3) {
        // Where the picture with glare is clipped too, nothing can be said.
        if (frame.samples[i] > 0) continue;
        scattered += double{seen.samples[i]};
    }
    const double all = 0.02 * double{share_seen(pixels_per_rad(hall.view()))} * hall.light();
    EXPECT_GT(scattered, 0.3 * all);
    EXPECT_LT(scattered, all);
    EXPECT_GT(scattered, 3 * 0.02 * sum_of(frame));
}

} // namespace
} // namespace ghost::render
