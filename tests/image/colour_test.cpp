// SPDX-License-Identifier: Apache-2.0
#include "image/colour.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

void expect_near(const glm::vec3& value, const glm::vec3& expected, float tolerance) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

// ITU-R BT.2087-0, table of the matrix M2.
TEST(Colour, Rec709ToRec2020AsPublished) {
    expect_near(rec709_to_rec2020({1, 0, 0}), {0.6274f, 0.0691f, 0.0164f}, 5e-5f);
    expect_near(rec709_to_rec2020({0, 1, 0}), {0.3293f, 0.9195f, 0.0880f}, 5e-5f);
    expect_near(rec709_to_rec2020({0, 0, 1}), {0.0433f, 0.0114f, 0.8956f}, 5e-5f);
}

// ITU-R BT.2020-2: Y = 0.2627 R + 0.6780 G + 0.0593 B.
TEST(Colour, LuminanceOfRec2020AsPublished) {
    EXPECT_NEAR(rec2020_to_xyz({1, 0, 0}).y, 0.2627f, 5e-5f);
    EXPECT_NEAR(rec2020_to_xyz({0, 1, 0}).y, 0.6780f, 5e-5f);
    EXPECT_NEAR(rec2020_to_xyz({0, 0, 1}).y, 0.0593f, 5e-5f);
}

TEST(Colour, WhiteStaysWhite) {
    expect_near(rec709_to_rec2020(glm::vec3(1)), glm::vec3(1), 1e-6f);
    expect_near(xyy_to_rec2020({0.3127f, 0.3290f, 1}), glm::vec3(1), 1e-5f);
}

TEST(Colour, ThereAndBack) {
    const glm::vec3 colour(0.2f, 0.9f, 0.05f);
    expect_near(rec2020_to_rec709(rec709_to_rec2020(colour)), colour, 1e-6f);
    expect_near(xyz_to_rec2020(rec2020_to_xyz(colour)), colour, 1e-6f);
    expect_near(rgb_to_rec2020(kRec709) * colour, rec709_to_rec2020(colour), 1e-6f);
    expect_near(rgb_to_rec2020(kRec2020) * colour, colour, 1e-6f);
}

TEST(Colour, BlackOfXyy) {
    expect_near(xyy_to_rec2020({0.3f, 0.0f, 1.0f}), glm::vec3(0), 0);
    expect_near(xyy_to_rec2020({0.3127f, 0.3290f, 0.0f}), glm::vec3(0), 0);
}

// IEC 61966-2-1.
TEST(Colour, SrgbCurve) {
    EXPECT_FLOAT_EQ(srgb_to_linear(0.0f), 0.0f);
    EXPECT_FLOAT_EQ(srgb_to_linear(1.0f), 1.0f);
    EXPECT_NEAR(srgb_to_linear(0.5f), 0.21404f, 1e-5f);
    EXPECT_NEAR(srgb_to_linear(0.04045f), 0.0031308f, 1e-6f);
    for (int k = 0; k <= 255; ++k) {
        const float encoded = static_cast<float>(k) / 255.0f;
        EXPECT_NEAR(linear_to_srgb(srgb_to_linear(encoded)), encoded, 1e-6f);
    }
}

glm::vec2 chromaticity(const glm::vec3& rgb) {
    const glm::vec3 xyz = rec2020_to_xyz(rgb);
    return glm::vec2(xyz) / (xyz.x + xyz.y + xyz.z);
}

TEST(Colour, CorrelatedColourTemperature) {
    // CIE illuminant A (2856 K): 0.44758, 0.40745. Daylight of 6504 K: D65. The fit is good to about 5e-4.
    const glm::vec2 a = chromaticity(cct_to_rec2020(2856));
    EXPECT_NEAR(a.x, 0.44758f, 1e-3f);
    EXPECT_NEAR(a.y, 0.40745f, 1e-3f);
    expect_near(cct_to_rec2020(6504), glm::vec3(1), 2e-3f);
    // CIE D50 (5003 K): 0.3457, 0.3585.
    const glm::vec2 d50 = chromaticity(cct_to_rec2020(5003));
    EXPECT_NEAR(d50.x, 0.3457f, 2e-4f);
    EXPECT_NEAR(d50.y, 0.3585f, 2e-4f);
    for (const float t : {-5.0f, 1667.0f, 3200.0f, 4000.0f, 5600.0f, 10000.0f, 1e9f})
        EXPECT_NEAR(rec2020_to_xyz(cct_to_rec2020(t)).y, 1.0f, 1e-5f) << t;
    expect_near(cct_to_rec2020(0), cct_to_rec2020(1667), 0);
    expect_near(cct_to_rec2020(1e9f), cct_to_rec2020(25000), 0);
}

TEST(Colour, CorrelatedColourTemperatureHasNoStep) {
    for (int t = 1700; t < 25000; t += 10) {
        const glm::vec2 here = chromaticity(cct_to_rec2020(static_cast<float>(t)));
        const glm::vec2 next = chromaticity(cct_to_rec2020(static_cast<float>(t + 10)));
        EXPECT_LT(glm::distance(here, next), 2e-3f) << t;
    }
}

} // namespace
} // namespace ghost::image
