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

// After the first frame, of one on which a frame takes 20 ms.
Pace fast() {
    Pace pace;
    run(pace, 1, 20);
    return pace;
}

TEST(Pace, the_first_picture_is_coarse_and_the_second_as_fine_as_there_is_time) {
    Pace pace;
    EXPECT_EQ(pace.share(), 0.25);
    EXPECT_EQ(run(pace, 1, 30), 1);
    EXPECT_EQ(pace.share(), 1.0);
    EXPECT_EQ(run(pace, 100, 30), 0);
    Pace slow;
    EXPECT_EQ(run(slow, 1, 250), 1);
    EXPECT_EQ(slow.share(), 0.5); // 62 ms, of which nobody could know
    EXPECT_EQ(run(slow, 200, 250), 0);
}

TEST(Pace, what_gets_slow_gets_there_in_one_step) {
    Pace pace = fast();
    EXPECT_EQ(run(pace, 6, 250), 0);
    EXPECT_EQ(run(pace, 1, 250), 1);
    EXPECT_EQ(pace.share(), 0.5) << "62 ms: below half of the sides nothing can be seen";
    EXPECT_EQ(run(pace, 200, 250), 0);
    Pace slower = fast();
    EXPECT_EQ(run(slower, 7, 330), 1);
    EXPECT_EQ(slower.share(), 0.35) << "at half of the sides it would not move any more";
}

// Half of a frame does not go with its pixels: from the first change on that is known.
TEST(Pace, what_does_not_go_with_the_pixels_is_measured) {
    Pace pace = fast();
    run(pace, 7, 60, 25); // 85 ms: 36 % are expected at 0.5, there are 40
    EXPECT_EQ(pace.share(), 0.5);
    const int changes = run(pace, 400, 60, 25);
    EXPECT_LE(changes, 2) << "0.7 would take 54 ms, and is not tried again and again";
    EXPECT_EQ(pace.share(), 0.5);
}

// A thousand fixtures without a GPU: nobody waits for three frames of half a minute.
TEST(Pace, a_frame_that_is_far_too_slow_is_enough) {
    Pace pace = fast();
    EXPECT_EQ(run(pace, 1, 30000), 1);
    EXPECT_EQ(pace.share(), 0.25);
    EXPECT_EQ(run(pace, 20, 30000), 0) << "there is nothing coarser";
}

TEST(Pace, no_machine_is_too_slow_for_a_picture) {
    Pace pace;
    run(pace, 50, 100000);
    EXPECT_EQ(pace.share(), 0.25);
}

TEST(Pace, pixels_come_back_when_there_is_time) {
    Pace pace;
    run(pace, 1, 1000);
    ASSERT_EQ(pace.share(), 0.25);
    run(pace, 500, 20);
    EXPECT_EQ(pace.share(), 1.0);
}

TEST(Pace, one_slow_frame_changes_nothing) {
    Pace pace = fast();
    run(pace, 20, 20);
    EXPECT_FALSE(pace.add(390, kFps));
    EXPECT_EQ(run(pace, 20, 20), 0);
    EXPECT_EQ(pace.share(), 1.0);
}

// It may be the first of many; where it was not, all pixels are back within two seconds.
TEST(Pace, one_that_is_far_too_slow_costs_pixels_for_a_short_while) {
    Pace pace = fast();
    EXPECT_TRUE(pace.add(5000, kFps));
    EXPECT_EQ(pace.share(), 0.25);
    run(pace, 50, 20);
    EXPECT_EQ(pace.share(), 1.0);
}

// What does not shrink with the pixels: it tries again and again, but ever more rarely.
TEST(Pace, tries_that_fail_become_rare) {
    Pace pace = fast();
    run(pace, 7, 100, 33);
    const int early = run(pace, 200, 40, 33);
    const int late = run(pace, 200, 40, 33);
    EXPECT_LE(late, early);
    EXPECT_LE(late, 4);
}

} // namespace
} // namespace ghost::app
