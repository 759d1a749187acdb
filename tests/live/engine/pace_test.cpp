// SPDX-License-Identifier: Apache-2.0
// The pace against machines made up here, on which a frame takes so many milliseconds with all its pixels.
#include "live/engine/pace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

namespace ghost::app {
namespace {

constexpr double kPaceFps = 25;               // 40 ms
constexpr std::size_t kFew = 10, kMany = 400; // lights

// Frames of a machine; returns how often the share changed.
int run(Pace& pace, int frames, double full_ms, double fixed_ms = 0) {
    int changes = 0;
    for (int i = 0; i < frames; ++i)
        changes += pace.add(fixed_ms + full_ms * pace.share() * pace.share(), kPaceFps) ? 1 : 0;
    return changes;
}

// After the first frames, of one on which a frame takes 20 ms.
Pace fast() {
    Pace pace(kFew);
    run(pace, 2, 20);
    return pace;
}

TEST(Pace, the_first_pictures_are_coarse_and_the_next_as_fine_as_there_is_time) {
    Pace pace(kMany);
    EXPECT_EQ(pace.share(), 0.25);
    EXPECT_FALSE(pace.add(1000, kPaceFps)) << "shaders were made";
    EXPECT_EQ(run(pace, 1, 30), 1);
    EXPECT_EQ(pace.share(), 1.0);
    EXPECT_EQ(run(pace, 100, 30), 0);
    EXPECT_EQ(Pace(kFew).share(), 0.5);
    Pace slow(kMany);
    EXPECT_EQ(run(slow, 2, 250), 1);
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
    EXPECT_EQ(run(slower, 7, 900), 1);
    EXPECT_LT(slower.share(), 0.5) << "at half of the sides it would not move any more";
}

// Half of a frame does not go with its pixels: from the first change on that is known.
TEST(Pace, what_does_not_go_with_the_pixels_is_measured) {
    Pace pace = fast();
    run(pace, 7, 60, 25); // 85 ms: 31 are expected at 0.5, there are 40
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
    Pace pace(kMany);
    run(pace, 50, 100000);
    EXPECT_EQ(pace.share(), 0.25);
}

TEST(Pace, pixels_come_back_when_there_is_time) {
    Pace pace(kMany);
    run(pace, 1, 1000);
    ASSERT_EQ(pace.share(), 0.25);
    run(pace, 500, 20);
    EXPECT_EQ(pace.share(), 1.0);
}

TEST(Pace, one_slow_frame_changes_nothing) {
    Pace pace = fast();
    run(pace, 20, 20);
    EXPECT_FALSE(pace.add(390, kPaceFps));
    EXPECT_FALSE(pace.add(1200, kPaceFps)) << "something else had the processor";
    EXPECT_EQ(run(pace, 20, 20), 0);
    EXPECT_EQ(pace.share(), 1.0);
}

// It may be the first of many; where it was not, all pixels are back within two seconds.
TEST(Pace, one_that_is_far_too_slow_costs_pixels_for_a_short_while) {
    Pace pace = fast();
    EXPECT_TRUE(pace.add(5000, kPaceFps));
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

// One or two lights turn, now and then five: the usual picture is soon drawn, and the next better level would
// be late each time.
TEST(Pace, what_is_slow_now_and_then_is_not_tried) {
    for (const int period : {4, 6, 9}) {
        Pace pace(kFew);
        run(pace, 3, 100, 10);
        ASSERT_EQ(pace.share(), 0.5) << "35 ms";
        int changes = 0;
        for (int i = 0; i < 2000; ++i) {
            const double full_ms = i % period == 0 ? 160 : 16; // 50 ms and 14; 88 and 18 at the next level
            changes += pace.add(10 + full_ms * pace.share() * pace.share(), kPaceFps) ? 1 : 0;
        }
        EXPECT_EQ(changes, 0) << period;
        run(pace, 200, 16);
        EXPECT_EQ(pace.share(), 1.0) << "where none is slow it is";
    }
}

// Two cores and ten lights, other work beside them: coarse, but never below half of the sides.
TEST(Pace, few_lights_never_go_below_half_of_the_sides) {
    for (const double full_ms : {20.0, 80.0, 160.0, 330.0}) {
        Pace pace(kFew);
        double least = 1;
        for (int i = 0; i < 1000; ++i) {
            const double load = i / 100 % 2 == 0 ? 1 : 1.6; // for four seconds at a time
            pace.add(load * (20 + (full_ms - 20) * pace.share() * pace.share()), kPaceFps);
            least = std::min(least, pace.share());
        }
        EXPECT_GE(least, 0.5) << full_ms;
    }
}

// The second frame of a picture may make much that is kept: a blur that no machine needs does not stay.
TEST(Pace, below_half_of_the_sides_it_does_not_stay_where_half_would_move) {
    Pace pace(kFew);
    run(pace, 1, 900);
    EXPECT_TRUE(pace.add(300, kPaceFps));
    ASSERT_EQ(pace.share(), 0.25);
    run(pace, 200, 80, 30); // 35 ms there; 50 at half of the sides, which is 1.25 times what is wanted
    EXPECT_EQ(pace.share(), 0.5);
}

// Other sizes of the picture that come and go are seen as flicker.
TEST(Pace, no_series_of_frames_makes_it_flicker) {
    std::uint32_t seed = 7;
    const auto noise = [&] { // 0.8 to 1.25
        seed = seed * 1664525u + 1013904223u;
        return 0.8 + 0.45 * (seed >> 8) / 16777216.0;
    };
    for (const int period : {8, 30, 75, 150, 400}) // frames of a wave of load
        for (const double fixed : {0.1, 0.5, 0.8})
            for (double full_ms = 25; full_ms < 1500; full_ms *= 1.4) {
                Pace pace(kFew);
                int changes = 0, of_late = 0, reversals = 0, last = 0, last_at = -1000;
                double before = pace.share();
                constexpr int kFrames = 5000; // 200 s
                for (int i = 0; i < kFrames; ++i) {
                    const double wave = std::sin(2 * 3.14159 * i / period) > 0 ? 1.7 : 1.0;
                    const double rare = i % 97 == 0 ? 4.0 : 1.0;
                    pace.add(rare * noise() * wave * full_ms *
                                 (fixed + (1 - fixed) * pace.share() * pace.share()),
                             kPaceFps);
                    const int way = pace.share() > before ? 1 : pace.share() < before ? -1 : 0;
                    before = pace.share();
                    if (way == 0) continue;
                    ++changes;
                    if (i > kFrames / 2) ++of_late;
                    if (last != 0 && way != last && i - last_at < 25) ++reversals; // within a second
                    last = way;
                    last_at = i;
                }
                EXPECT_EQ(reversals, 0) << full_ms << " ms, fixed " << fixed << ", wave of " << period;
                EXPECT_LE(of_late, 2) << full_ms << " ms, fixed " << fixed << ", wave of " << period;
                EXPECT_LE(changes, 5) << full_ms << " ms, fixed " << fixed << ", wave of " << period;
            }
}

} // namespace
} // namespace ghost::app
