// SPDX-License-Identifier: Apache-2.0
// How much a viewer may say.
#include "web/private/viewer.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

TEST(Viewer, sixty_at_once_and_sixty_a_second) {
    Viewer viewer;
    for (int k = 0; k < kMostMessagesPerSecond; ++k) ASSERT_TRUE(viewer.may_say(100)) << k;
    EXPECT_FALSE(viewer.may_say(100));
    int said = 0;
    for (int k = 1; k <= 1000; ++k) said += viewer.may_say(100 + 0.01 * k);
    EXPECT_NEAR(said, 600, 2);
}

TEST(Viewer, that_a_picture_is_painted_does_not_count_once) {
    Viewer viewer;
    double now_s = 100;
    for (std::uint32_t number = 1; number <= 600; ++number, now_s += 1.0 / 120) {
        viewer.flow.sent(number, now_s);
        ASSERT_TRUE(viewer.may_say(now_s)) << number;
        viewer.hear_painted(number, now_s);
        if (number % 3 > 0) continue; // and 40 pings a second
        ASSERT_TRUE(viewer.may_say(now_s)) << number;
    }
    EXPECT_NEAR(static_cast<double>(viewer.painted_s.size()), 120, 2);
    int said = 0;
    for (int k = 0; k < 200 && viewer.may_say(now_s); ++k, ++said) viewer.hear_painted(600, now_s);
    EXPECT_LE(said, kMostMessagesPerSecond) << "said again it counts";
}

} // namespace
} // namespace ghost::web
