// SPDX-License-Identifier: Apache-2.0
// The pace against machines made up here, on which a frame takes so many milliseconds with all its pixels.
#include "app/pace.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

constexpr double kFps = 25; // 40 ms

// Frames of a machine; returns how often the share changed.
int run(Pace& pace, int frames, double full_ms, double fixed_ms = 0) {
    int changes = 0;
    for (int i = 0; i < frames; ++i)
        changes += pace.add(fixed_ms + full_ms * pace.share() * pace.share(), kFps) ? 1 : 0;
    return changes;
}

TEST(Pace, a_fast_machine_keeps_all_pixels) {
    Pace pace;
    EXPECT_EQ(run(pace, 100, 30), 0);
    EXPECT_EQ(pace.share(), 1.0);
}

TEST(Pace, a_slow_machine_gets_there_in_one_step) {
    Pace pace;
    EXPECT_EQ(run(pace, 3, 250), 1);
    EXPECT_EQ(pace.share(), 0.35); // 31 ms
    EXPECT_EQ(run(pace, 200, 250), 0);
}

TEST(Pace, no_machine_is_too_slow_for_a_picture) {
    Pace pace;
    run(pace, 50, 100000);
    EXPECT_EQ(pace.share(), 0.25);
}

TEST(Pace, pixels_come_back_when_there_is_time) {
    Pace pace;
    run(pace, 3, 1000);
    ASSERT_EQ(pace.share(), 0.25);
    run(pace, 500, 20);
    EXPECT_EQ(pace.share(), 1.0);
}

TEST(Pace, one_slow_frame_changes_nothing) {
    Pace pace;
    run(pace, 20, 20);
    EXPECT_FALSE(pace.add(5000, kFps));
    EXPECT_EQ(run(pace, 20, 20), 0);
}

// What does not shrink with the pixels: it tries again and again, but ever more rarely.
TEST(Pace, tries_that_fail_become_rare) {
    Pace pace;
    run(pace, 3, 100, 33);
    const int early = run(pace, 200, 40, 33);
    const int late = run(pace, 200, 40, 33);
    EXPECT_LE(late, early);
    EXPECT_LE(late, 4);
}

} // namespace
} // namespace ghost::app
