// SPDX-License-Identifier: Apache-2.0
// The tone curves: their names, and what is known of their shape.
#include "image/tone.h"

#include "image/colour.h"
#include "shared/develop.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

// Linear value of the display for an exposed grey.
float shown(Tone tone, float grey) {
    const glm::vec3 encoded = shared::develop(glm::vec3(grey), 1.0f, static_cast<std::uint32_t>(tone));
    EXPECT_NEAR(encoded.x, encoded.y, 2e-3f);
    EXPECT_NEAR(encoded.x, encoded.z, 2e-3f);
    return srgb_to_linear(encoded.y);
}

TEST(Tone, names_go_there_and_back) {
    for (const Tone tone : kTones) EXPECT_EQ(*tone_from(name_of(tone)), tone);
    EXPECT_FALSE(tone_from("AgX").ok());
    EXPECT_FALSE(tone_from("").ok());
}

TEST(Tone, middle_grey_stays_about_where_it_is) {
    EXPECT_NEAR(shown(Tone::linear, 0.18f), 0.18f, 1e-3f);
    EXPECT_NEAR(shown(Tone::aces, 0.18f), 0.18f, 1e-3f);
    EXPECT_NEAR(shown(Tone::agx, 0.18f), 0.21f, 1e-2f);
}

TEST(Tone, aces_is_the_published_fit) {
    const double x = 0.7232; // of an exposed 1
    EXPECT_NEAR(shown(Tone::aces, 1), x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 2e-3);
}

TEST(Tone, what_is_brighter_is_never_shown_darker) {
    for (const Tone tone : kTones) {
        float before = -1;
        for (float grey = 1e-4f; grey < 1e6f; grey *= 1.3f) {
            const float now = shown(tone, grey);
            EXPECT_GE(now, before - 1e-4f) << name_of(tone) << " at " << grey;
            EXPECT_LE(now, 1.0f);
            before = now;
        }
        EXPECT_EQ(shown(tone, 0), shown(tone, -1)) << "there is no light below none";
        EXPECT_LT(shown(tone, 0), 1e-3f);
        EXPECT_GT(before, 0.95f) << name_of(tone);
    }
}

// The linear one clips at the display's white; the others still tell brighter from bright there.
TEST(Tone, only_the_linear_one_clips) {
    EXPECT_EQ(shown(Tone::linear, 1), 1.0f);
    EXPECT_EQ(shown(Tone::linear, 2), 1.0f);
    for (const Tone tone : {Tone::agx, Tone::aces}) EXPECT_LT(shown(tone, 1) + 0.05f, shown(tone, 2));
}

// Far too bright blue: AgX goes to white, the linear one stays blue.
TEST(Tone, bright_colours_go_to_white_as_the_curve_says) {
    const glm::vec3 blue = 30.0f * rec709_to_rec2020({0.05f, 0.1f, 1});
    const auto red_of = [&](Tone tone) {
        return shared::develop(blue, 1.0f, static_cast<std::uint32_t>(tone)).x;
    };
    const glm::vec3 dim = rec709_to_rec2020({0, 0.02f, 0.6f});
    EXPECT_GT(red_of(Tone::agx), 0.6f);
    EXPECT_EQ(shared::develop(dim, 1.0f, shared::kToneLinear).x, 0.0f);
}

} // namespace
} // namespace ghost::image
