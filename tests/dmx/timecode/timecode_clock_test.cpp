// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/timecode_clock.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Rate = TimeCode::Rate;

// Frames of 25 a second, each a packet.
struct Desk {
    TimeCodeClock clock;
    std::chrono::nanoseconds now = 5s;

    void send(int frame) {
        clock.feed({0, static_cast<std::uint8_t>(frame / 1500), static_cast<std::uint8_t>(frame / 25 % 60),
                    static_cast<std::uint8_t>(frame % 25), Rate::ebu_25},
                   now);
    }
    void run(int from, int to, std::chrono::nanoseconds each = 40ms) {
        const int step = from < to ? 1 : -1;
        for (int frame = from; frame != to + step; frame += step, now += each) send(frame);
        now -= each; // when the last one came
    }
    double after(std::chrono::nanoseconds age) const { return *clock.at_s(now + age); }
    std::string text(std::chrono::nanoseconds age) const { return chase_text(clock.status(now + age)); }
};

TEST(TimeCodeClock, runs_between_packets) {
    Desk desk;
    EXPECT_FALSE(desk.clock.at_s(desk.now).has_value());
    desk.run(100, 150);
    EXPECT_NEAR(*desk.clock.at_s(desk.now), 6.0, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 20ms), 6.02, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 39ms), 6.039, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now - 5ms), 6.0, 1e-9);
}

TEST(TimeCodeClock, stands_when_it_stops) {
    Desk desk;
    desk.run(0, 50);
    desk.now += 40ms;
    desk.send(50); // a desk that pauses and goes on sending
    desk.now += 40ms;
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 30ms), 2.0, 1e-9);
    desk.send(50);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 30ms), 2.0, 1e-9);
    EXPECT_EQ(desk.text(30ms), "time code stands");
    EXPECT_EQ(desk.text(1min), "time code dropped out 60 s ago");
}

TEST(TimeCodeClock, jumps_and_runs_backwards) {
    Desk desk;
    desk.run(0, 50);
    desk.now += 40ms;
    desk.send(1000);
    EXPECT_NEAR(*desk.clock.at_s(desk.now), 40.0, 1e-9);
    desk.now += 40ms;
    desk.send(999);
    desk.now += 40ms;
    desk.send(998);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 20ms), 39.90, 1e-9);
}

TEST(TimeCodeClock, sparse_packets_run_on_as_they_step) {
    Desk desk;
    for (int frame = 0; frame <= 100; frame += 5, desk.now += 200ms) desk.send(frame);
    desk.now -= 200ms;
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 150ms), 4.15, 1e-9);
    EXPECT_NEAR(*desk.clock.at_s(desk.now + 900ms), 4.9, 1e-9);
    EXPECT_EQ(desk.text(300ms), "");
}

TEST(TimeCodeClock, freewheels_for_its_time_and_then_stands) {
    Desk desk;
    desk.run(0, 50);
    EXPECT_EQ(desk.text(90ms), "");
    EXPECT_EQ(desk.text(400ms), "time code freewheels since 0.4 s");
    EXPECT_NEAR(desk.after(400ms), 2.4, 1e-9);
    EXPECT_NEAR(desk.after(1s), 3.0, 1e-9);
    EXPECT_NEAR(desk.after(1h), 3.0, 1e-9);
    EXPECT_EQ(desk.text(12500ms), "time code dropped out 12 s ago");
    desk.now += 600ms; // it comes back before that
    desk.run(65, 66);
    EXPECT_EQ(desk.text(0ms), "time code stands") << "a jump: it is not locked yet";
    desk.now += 40ms;
    desk.run(67, 70);
    EXPECT_EQ(desk.text(0ms), "");
}

TEST(TimeCodeClock, the_time_of_freewheeling_is_chosen) {
    Desk none{TimeCodeClock(0)}, long_one{TimeCodeClock(10)};
    for (Desk* desk : {&none, &long_one}) desk->run(0, 50);
    EXPECT_NEAR(none.after(1h), 2.04, 1e-9);
    EXPECT_EQ(none.text(200ms), "time code dropped out 0 s ago");
    EXPECT_NEAR(long_one.after(9s), 11.0, 1e-9);
    EXPECT_EQ(long_one.text(9s), "time code freewheels since 9.0 s");
}

TEST(TimeCodeClock, a_few_frames_do_not_lock_it) {
    for (const int frames : {1, 2}) {
        Desk desk;
        desk.run(100, 100 + frames - 1);
        EXPECT_NEAR(desk.after(1s), (100 + frames) / 25.0, 1e-9) << frames;
        EXPECT_EQ(desk.text(100ms), "time code stands");
    }
    Desk desk;
    EXPECT_EQ(desk.text(0ms), "no time code yet");
    desk.run(100, 102);
    EXPECT_NEAR(desk.after(500ms), 102 / 25.0 + 0.5, 1e-9);
}

TEST(TimeCodeClock, freewheels_as_it_ran_backwards_and_at_other_speeds) {
    Desk back;
    back.run(200, 100);
    EXPECT_NEAR(back.after(500ms), 3.5, 1e-9);
    Desk slow;
    slow.run(0, 100, 80ms);
    EXPECT_NEAR(slow.after(60ms), 4.03, 1e-6);
    EXPECT_NEAR(slow.after(1s), 4.5, 1e-6);
    EXPECT_EQ(slow.text(150ms), "");
    Desk shaky; // packets that arrive up to 12 ms late: nominal speed
    for (int frame = 0; frame <= 100; ++frame) {
        shaky.now = 5s + frame * 40ms + (frame * 7 % 13) * 1ms;
        shaky.send(frame);
    }
    EXPECT_NEAR(shaky.after(1s), 5.0, 1e-9);
}

TEST(TimeCodeClock, a_frame_that_is_sent_twice_is_one) {
    Desk desk;
    for (int frame = 0; frame <= 50; ++frame, desk.now += 40ms) {
        desk.send(frame);
        desk.now += 10ms;
        desk.send(frame);
        desk.now -= 10ms;
    }
    desk.now -= 40ms;
    EXPECT_NEAR(desk.after(25ms), 2.025, 1e-9);
    EXPECT_EQ(desk.text(400ms), "time code freewheels since 0.4 s");
}

} // namespace
} // namespace ghost::dmx
