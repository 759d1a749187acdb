// SPDX-License-Identifier: Apache-2.0
#include "image/jpeg.h"
#include "image/ldr.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

// Left half of the one, right half of the other colour.
Image8 two_halves(int width, int height, const std::vector<std::uint8_t>& left,
                  const std::vector<std::uint8_t>& right) {
    Image8 image(width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            std::copy_n((x < width / 2 ? left : right).begin(), 4, image.at(x, y));
    return image;
}

TEST(Jpeg, what_is_written_is_read_again) {
    const Image8 picture = two_halves(64, 32, {200, 30, 60, 0}, {10, 90, 220, 255});
    for (const bool full : {false, true}) {
        const auto bytes = encode_jpeg(picture, {92, full});
        ASSERT_TRUE(bytes.ok());
        const auto again = decode_ldr(*bytes, "again");
        ASSERT_TRUE(again.ok());
        EXPECT_EQ(again->width, 64);
        EXPECT_EQ(again->height, 32);
        for (const int c : {0, 1, 2}) {
            EXPECT_NEAR(again->at(8, 8)[c], picture.at(8, 8)[c], 4);
            EXPECT_NEAR(again->at(56, 24)[c], picture.at(56, 24)[c], 4);
        }
    }
}

TEST(Jpeg, a_lower_quality_has_fewer_bytes) {
    Image8 noise(128, 128, 3);
    for (std::size_t i = 0; i < noise.samples.size(); ++i)
        noise.samples[i] = static_cast<std::uint8_t>(i * i >> 3);
    EXPECT_LT(encode_jpeg(noise, {50, false})->size(), encode_jpeg(noise, {92, true})->size());
}

TEST(Jpeg, a_narrow_picture_is_the_mean_and_keeps_its_shape) {
    const Image8 picture = two_halves(100, 50, {100, 0, 0, 255}, {0, 0, 200, 255});
    const Image8 small = narrowed(picture, 10);
    EXPECT_EQ(small.width, 10);
    EXPECT_EQ(small.height, 5);
    EXPECT_EQ(small.at(4, 2)[0], 100);
    EXPECT_EQ(small.at(5, 2)[2], 200);
    const Image8 one = narrowed(picture, 1);
    EXPECT_EQ(one.height, 1);
    EXPECT_EQ(one.at(0, 0)[0], 50);
    EXPECT_EQ(one.at(0, 0)[2], 100);
    EXPECT_EQ(narrowed(picture, 100).samples, picture.samples);
    EXPECT_EQ(narrowed(picture, 4000).width, 100);
    const Image8 uneven = narrowed(picture, 33); // no whole number of pixels each
    EXPECT_EQ(uneven.height, 16);
    EXPECT_EQ(uneven.at(0, 0)[0], 100);
    EXPECT_EQ(uneven.at(32, 15)[2], 200);
}

} // namespace
} // namespace ghost::image
