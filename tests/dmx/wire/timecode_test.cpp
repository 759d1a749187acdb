// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/timecode_clock.h"
#include "dmx/wire/timecode.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
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

// Frames of 25 a second, each a packet.
struct Desk {
    TimeCodeClock clock;
    std::chrono::nanoseconds now = 5s;

    void send(int frame) {
        clock.feed({0, static_cast<std::uint8_t>(frame / 1500), static_cast<std::uint8_t>(frame / 25 % 60),
                    static_cast<std::uint8_t>(frame % 25), Rate::ebu_25},
                   now);
    }
    void run(int from, int to) {
        for (int frame = from; frame <= to; ++frame, now += 40ms) send(frame);
    }
};

TEST(TimeCode, runs_between_packets_and_never_further_than_the_next) {
    Desk desk;
    EXPECT_FALSE(desk.clock.at_s(desk.now).has_value());
    desk.run(100, 150);
    desk.now -= 40ms; // when frame 150 came
    EXPECT_NEAR(*desk.clock.at_s(desk.now), 6.0, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 20ms), 6.02, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 39ms), 6.039, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now - 5ms), 6.0, 1e-9);
}

TEST(TimeCode, stands_when_it_stops) {
    Desk desk;
    desk.run(0, 50);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 1h), 2.04, 1e-9); // no packets any more
    EXPECT_FALSE(desk.clock.is_heard(desk.now + 1h));
    desk.send(50); // a desk that pauses and goes on sending
    desk.now += 40ms;
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 30ms), 2.0, 1e-9);
    desk.send(50);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 30ms), 2.0, 1e-9);
    EXPECT_TRUE(desk.clock.is_heard(desk.now));
}

TEST(TimeCode, jumps_and_runs_backwards) {
    Desk desk;
    desk.run(0, 50);
    desk.send(1000);
    EXPECT_NEAR(*desk.clock.at_s(desk.now), 40.0, 1e-9);
    desk.now += 40ms;
    desk.send(999);
    desk.now += 40ms;
    desk.send(998);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 20ms), 39.90, 1e-9);
}

TEST(TimeCode, sparse_packets_run_on_as_they_step) {
    Desk desk;
    for (int frame = 0; frame <= 100; frame += 5, desk.now += 200ms) desk.send(frame);
    desk.now -= 200ms;
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 150ms), 4.15, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 900ms), 4.2, 1e-9);
}

} // namespace
} // namespace ghost::dmx
