// SPDX-License-Identifier: Apache-2.0
#include "image/pyramid.h"

#include "image/colour.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

Image8 filled(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255) {
    Image8 picture(width, height, 4);
    for (std::size_t k = 0; k < picture.samples.size(); k += 4) {
        picture.samples[k] = r;
        picture.samples[k + 1] = g;
        picture.samples[k + 2] = b;
        picture.samples[k + 3] = a;
    }
    return picture;
}

TEST(Pyramid, FitsAndKeepsEvenColour) {
    EXPECT_EQ(fitted(1920, 1080, 512), glm::ivec2(512, 288));
    EXPECT_EQ(fitted(100, 400, 256), glm::ivec2(64, 256));
    EXPECT_EQ(fitted(16384, 1, 256), glm::ivec2(256, 1));
    const Pyramid pyramid = make_pyramid(filled(64, 36, 188, 188, 60), 64);
    ASSERT_EQ(pyramid.levels->size(), 5u); // 64 .. 4
    EXPECT_FLOAT_EQ(pyramid.extent.y, 36.0f / 64.0f);
    EXPECT_NEAR(pyramid.mean.x, srgb_to_linear(188.0f / 255), 1e-3f);
    for (const auto& level : *pyramid.levels)
        for (std::size_t k = 0; k < level.size(); k += 4) {
            ASSERT_EQ(level[k], 188);
            ASSERT_EQ(level[k + 2], 60);
        }
}

// The mean of black and white is half of the light, which is 188 in sRGB, not 128.
TEST(Pyramid, AveragesLight) {
    Image8 picture = filled(64, 64, 0, 0, 0);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if ((x + y) % 2 == 0)
                for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = 255;
    const Pyramid pyramid = make_pyramid(picture, 64);
    for (std::size_t level = 1; level < pyramid.levels->size(); ++level)
        for (const std::size_t k : {0u, 4u}) EXPECT_NEAR((*pyramid.levels)[level][k], 188, 1) << level;
    EXPECT_NEAR(pyramid.mean.y, 0.5f, 1e-3f);
}

TEST(Pyramid, AlphaIsInTheColours) {
    const Pyramid soft = make_pyramid(filled(64, 64, 255, 255, 255, 128), 64);
    EXPECT_NEAR(soft.mean.x, 128.0f / 255, 1e-3f);
    const Pyramid gone = make_pyramid(filled(30, 70, 255, 255, 255, 0), 64); // resampled
    EXPECT_EQ(gone.mean, glm::vec3(0.0f));
}

// Beyond the picture its rim goes on: a dark border would eat into a blurred picture.
TEST(Pyramid, TheRimGoesOn) {
    Image8 picture = filled(64, 32, 255, 255, 255);
    for (int x = 0; x < 64; ++x) picture.at(x, 31)[0] = 0;
    const Pyramid pyramid = make_pyramid(picture, 64);
    const std::vector<std::uint8_t>& level = pyramid.levels->front();
    EXPECT_EQ(level[0], 255);               // above
    EXPECT_EQ(level[(63 * 64 + 5) * 4], 0); // below, red is out
    EXPECT_EQ(level[(63 * 64 + 5) * 4 + 1], 255);
}

TEST(Pyramid, OnePixelAndLong) {
    EXPECT_EQ(make_pyramid(filled(1, 1, 255, 0, 0), 4).mean.x, 1.0f);
    EXPECT_EQ(make_pyramid(filled(5000, 1, 255, 0, 0), 128).levels->size(), 6u);
}

} // namespace
} // namespace ghost::image
