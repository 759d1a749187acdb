// SPDX-License-Identifier: Apache-2.0
#include "base/progress.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace ghost {
namespace {

TEST(Progress, Clock) {
    EXPECT_EQ(clock_text(0), "0:00");
    EXPECT_EQ(clock_text(65.4), "1:05");
    EXPECT_EQ(clock_text(7384), "2:03:04");
    EXPECT_EQ(clock_text(-3), "0:00");
}

TEST(Progress, LineTellsShareAndTimeLeft) {
    EXPECT_EQ(progress_line("baking", 0.25, 10, "house"),
              "baking  25 % [######                  ] 0:30 left  house");
    EXPECT_EQ(progress_line("baking", 0, 10, ""), "baking   0 % [                        ]");
    EXPECT_EQ(progress_line("baking", 7, 10, ""), "baking 100 % [########################] 0:00 left");
}

TEST(Progress, LinesComeEveryFewSecondsOnly) {
    testing::internal::CaptureStderr();
    Progress progress("baking", Progress::Style::lines, 100);
    for (int k = 0; k <= 120; ++k) progress.update(k / 120.0, 100 + k * 0.1, "");
    progress.finish();
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
    testing::internal::CaptureStderr();
    Progress silent("baking", Progress::Style::silent, 0);
    silent.update(0.5, 100, "");
    silent.finish();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace ghost
