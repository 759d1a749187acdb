// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/mip_levels.h"

#include <cmath>
#include <gtest/gtest.h>

namespace ghost::render {
namespace {

// Columns that lean left and right in turn by this slope.
image::Image8 ridges(float slope) {
    image::Image8 pixels(8, 4, 4);
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const float length = std::sqrt(1 + slope * slope);
            const float lean = (x % 2 ? slope : -slope) / length;
            std::uint8_t* texel = pixels.at(x, y);
            texel[0] = static_cast<std::uint8_t>(std::lround(127.5f * (1 + lean)));
            texel[1] = 128;
            texel[2] = static_cast<std::uint8_t>(std::lround(127.5f * (1 + 1 / length)));
            texel[3] = 255;
        }
    return pixels;
}

TEST(MipLevels, bumps_that_are_averaged_away_are_kept_as_variance) {
    const float slope = 0.3f;
    const auto levels = mip_levels(ridges(slope), TextureUse::bumps, 0);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0].at(0, 0)[3], 0); // whatever the picture has there
    const float cosine = 1 / std::sqrt(1 + slope * slope);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        const std::uint8_t* texel = levels[k].at(0, 0);
        EXPECT_NEAR(texel[0], 127.5, 1);
        EXPECT_NEAR(texel[2], 255, 1);
        EXPECT_NEAR(texel[3] / 255.0f, std::sqrt((1 - cosine) / cosine), 0.01f);
    }
}

TEST(MipLevels, colours_are_averaged_as_light_and_data_as_numbers) {
    image::Image8 pixels(2, 1, 4);
    for (int c = 0; c < 4; ++c) pixels.at(1, 0)[c] = 255;
    EXPECT_EQ(mip_levels(pixels, TextureUse::data, 0)[1].at(0, 0)[0], 128);
    const auto colour = mip_levels(pixels, TextureUse::colour, 0);
    EXPECT_EQ(colour[1].at(0, 0)[0], 188); // half the light
    EXPECT_EQ(colour[1].at(0, 0)[3], 128);
    const auto coarse = mip_levels(pixels, TextureUse::colour, 1);
    ASSERT_EQ(coarse.size(), 1u);
    EXPECT_EQ(coarse[0].samples, colour[1].samples);
}

} // namespace
} // namespace ghost::render
