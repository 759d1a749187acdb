// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

TEST(Averaged, IsTheMeanOfEachBlock) {
    ImageF picture(5, 4, 2); // the fifth column is cut off
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) {
            picture.at(x, y)[0] = static_cast<float>(x + 10 * y);
            picture.at(x, y)[1] = 1.0f;
        }
    const ImageF small = averaged(picture, 2);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 2);
    EXPECT_FLOAT_EQ(small.at(0, 0)[0], (0 + 1 + 10 + 11) / 4.0f);
    EXPECT_FLOAT_EQ(small.at(1, 1)[0], (22 + 23 + 32 + 33) / 4.0f);
    EXPECT_FLOAT_EQ(small.at(1, 0)[1], 1.0f);
    EXPECT_EQ(averaged(picture, 1).samples, picture.samples);
    EXPECT_TRUE(averaged(picture, 6).empty());
}

} // namespace
} // namespace ghost::image
