// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/timecode.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using Rate = TimeCode::Rate;

TEST(TimeCode, seconds_of_each_rate) {
    EXPECT_DOUBLE_EQ(timecode_seconds({1, 2, 3, 12, Rate::film_24}), 3723.5);
    EXPECT_DOUBLE_EQ(timecode_seconds({0, 0, 1, 5, Rate::ebu_25}), 1.2);
    EXPECT_DOUBLE_EQ(timecode_seconds({10, 0, 0, 15, Rate::smpte_30}), 36000.5);
    // SMPTE 12M: 00:01:00;02 follows 00:00:59;29, and after ten minutes the clock is right again.
    const double frame_s = 1001.0 / 30000.0;
    EXPECT_NEAR(timecode_seconds({0, 1, 0, 2, Rate::drop_29_97}) -
                    timecode_seconds({0, 0, 59, 29, Rate::drop_29_97}),
                frame_s, 1e-9);
    EXPECT_NEAR(timecode_seconds({0, 10, 0, 0, Rate::drop_29_97}), 600.0, 0.01);
    EXPECT_NEAR(timecode_seconds({10, 0, 0, 0, Rate::drop_29_97}), 36000.0, 0.1);
}

TEST(TimeCode, text_of_a_beginning) {
    EXPECT_DOUBLE_EQ(*parse_timecode("10:00:00:00"), 36000.0);
    EXPECT_DOUBLE_EQ(*parse_timecode("01:02:03:05"), 3723.2);
    EXPECT_DOUBLE_EQ(*parse_timecode("00:00:10"), 10.0);
    EXPECT_DOUBLE_EQ(*parse_timecode("12.5"), 12.5);
    EXPECT_DOUBLE_EQ(*parse_timecode("0"), 0.0);
    for (const char* wrong : {"", "x", "10:00", "24:00:00:00", "00:60:00:00", "00:00:00:25", "1:2:3:4:5",
                              "-1", "00:00:00:", "nan", "1e9", "10:00:00:00 "})
        EXPECT_FALSE(parse_timecode(wrong).ok()) << wrong;
}

} // namespace
} // namespace ghost::dmx
