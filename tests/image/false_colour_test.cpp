// SPDX-License-Identifier: Apache-2.0
// False colours: each decade as wide as the others, what is beyond the scale is told apart from it.
#include "image/false_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace ghost::image {
namespace {

TEST(FalseColour, each_decade_is_as_wide) {
    const Scale scale{1, 1000};
    EXPECT_FLOAT_EQ(place_on(scale, 1), 0.0f);
    EXPECT_NEAR(place_on(scale, 10), 1.0f / 3, 1e-6);
    EXPECT_NEAR(place_on(scale, 100), 2.0f / 3, 1e-6);
    EXPECT_FLOAT_EQ(place_on(scale, 1000), 1.0f);
}

TEST(FalseColour, beyond_the_scale_is_no_colour_of_the_scale) {
    const Scale scale{1, 1000};
    std::set<Rgb8> inside;
    for (float value = 1; value <= 1000; value *= 1.01f) inside.insert(false_colour(scale, value));
    EXPECT_GT(inside.size(), 200u) << "values are told apart";
    for (const float beyond : {0.999f, 0.0f, -5.0f, 1001.0f, std::numeric_limits<float>::infinity(),
                               std::numeric_limits<float>::quiet_NaN()})
        EXPECT_FALSE(inside.contains(false_colour(scale, beyond))) << beyond;
}

TEST(FalseColour, low_is_blue_middle_is_green_high_is_red) {
    const Scale scale{1, 100};
    const Rgb8 low = false_colour(scale, 2), middle = false_colour(scale, 10), high = false_colour(scale, 80);
    EXPECT_GT(low[2], low[0]);
    EXPECT_GT(middle[1], std::max(middle[0], middle[2]));
    EXPECT_GT(high[0], std::max(high[1], high[2]));
}

TEST(FalseColour, a_picture_keeps_its_places) {
    ImageF values(2, 2, 1);
    values.samples = {0, 10, 100, 1e6f};
    const Scale scale{1, 1000};
    const Image8 picture = false_coloured(values, scale);
    ASSERT_EQ(picture.samples.size(), 16u);
    for (std::size_t i = 0; i < 4; ++i) {
        const Rgb8 wanted = false_colour(scale, values.samples[i]);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(picture.samples[4 * i + c], wanted[c]);
        EXPECT_EQ(picture.samples[4 * i + 3], 255);
    }
}

} // namespace
} // namespace ghost::image
