// SPDX-License-Identifier: Apache-2.0
// How much a recording does when: where levels change is the most, where they rest is nothing.
#include "dmx/record/activity.h"

#include <gtest/gtest.h>

#include <string>

namespace ghost::dmx {
namespace {

// Ten seconds: still, two seconds of a fader that moves, still.
std::string one_fader() {
    std::string text = "OLA Show\n1 0\n";
    for (int tenth = 1; tenth <= 100; ++tenth) {
        const int level = tenth < 40 ? 0 : tenth > 60 ? 200 : (tenth - 40) * 10;
        text += "100\n1 " + std::to_string(level) + "\n";
    }
    return text + "0\n";
}

TEST(Activity, is_where_levels_change) {
    auto recording = parse_recording(one_fader(), "test.show");
    ASSERT_TRUE(recording.ok()) << recording.error().text();
    Player player(std::move(*recording));
    ASSERT_NEAR(player.duration_s(), 10, 0.2);
    const std::vector<float> activity = activity_of(player, 10);
    ASSERT_EQ(activity.size(), 10u);
    for (const std::size_t still : {0u, 1u, 2u, 7u, 8u, 9u}) EXPECT_EQ(activity[still], 0.0f) << still;
    EXPECT_EQ(std::max(activity[4], activity[5]), 1.0f);
    EXPECT_GT(std::min(activity[4], activity[5]), 0.7f);
}

TEST(Activity, stops_when_it_is_asked_to) {
    auto recording = parse_recording(one_fader(), "test.show");
    ASSERT_TRUE(recording.ok());
    int asked = 0;
    Player player(std::move(*recording));
    EXPECT_TRUE(activity_of(player, 10, [&] { return ++asked == 3; }).empty());
    EXPECT_EQ(asked, 3);
}

} // namespace
} // namespace ghost::dmx
