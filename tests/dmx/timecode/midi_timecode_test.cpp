// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/midi_timecode.h"
#include "dmx/timecode/timecode_clock.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Buffer = std::vector<std::uint8_t>;
using Rate = TimeCode::Rate;

TimeCode at(int hours, int minutes, int seconds, int frames, Rate rate) {
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    return {byte(hours), byte(minutes), byte(seconds), byte(frames), rate};
}

// The eight quarter frames of a time, in the order of forwards.
std::array<Buffer, 8> quarter_frames(const TimeCode& time) {
    const int nibbles[] = {time.frames & 15,  time.frames >> 4,
                           time.seconds & 15, time.seconds >> 4,
                           time.minutes & 15, time.minutes >> 4,
                           time.hours & 15,   time.hours >> 4 | static_cast<int>(time.rate) << 1};
    std::array<Buffer, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
        result[i] = {0xF1, static_cast<std::uint8_t>(i << 4 | static_cast<std::size_t>(nibbles[i]))};
    return result;
}

// A MIDI cable, 10 ms a quarter frame.
struct Cable {
    MidiTimeCode decoder;
    std::chrono::nanoseconds now = 5s;
    std::vector<TimeCode> heard;

    void send(const Buffer& bytes) {
        decoder.feed(bytes, now, [&](const TimeCode& time) { heard.push_back(time); });
        now += 10ms;
    }
    void forwards(TimeCode time, int pairs) {
        for (int i = 0; i < pairs; ++i, time = plus_frames(time, 2))
            for (const Buffer& bytes : quarter_frames(time)) send(bytes);
    }
    std::vector<std::string> take() {
        std::vector<std::string> result;
        for (const TimeCode& time : std::exchange(heard, {})) result.push_back(timecode_text(time));
        return result;
    }
};

using Texts = std::vector<std::string>;

TEST(MidiTimeCode, literal_bytes) {
    Cable cable;
    // 01:02:03:04 at 25 frames: F1 04 F1 10 F1 23 F1 30 F1 42 F1 50 F1 61 F1 72
    cable.send(
        {0xF1, 0x04, 0xF1, 0x10, 0xF1, 0x23, 0xF1, 0x30, 0xF1, 0x42, 0xF1, 0x50, 0xF1, 0x61, 0xF1, 0x72});
    EXPECT_EQ(cable.take(), Texts{}) << "that is what was, two frames ago";
    cable.send({0xF1, 0x06});
    EXPECT_EQ(cable.take(), Texts{"01:02:03:06 EBU 25"});
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x01, 0x6A, 0x1E, 0x0F, 0x1D, 0xF7});
    EXPECT_EQ(cable.take(), Texts{"10:30:15:29 SMPTE 30"});
    EXPECT_EQ(cable.decoder.counters().quarter_frames, 9u);
    EXPECT_EQ(cable.decoder.counters().full_frames, 1u);
}

TEST(MidiTimeCode, tells_each_frame_when_it_is) {
    for (const Rate rate : {Rate::film_24, Rate::ebu_25, Rate::drop_29_97, Rate::smpte_30}) {
        Cable cable;
        const TimeCode start = at(0, 59, 59, 20, rate);
        std::vector<TimeCode> expected;
        for (int frame = 2; frame < 40; ++frame) expected.push_back(plus_frames(start, frame));
        cable.forwards(start, 20);
        EXPECT_EQ(cable.heard, expected) << static_cast<int>(rate);
    }
}

TEST(MidiTimeCode, the_clock_runs_with_it) {
    Cable cable;
    TimeCodeClock clock;
    const TimeCode start = at(10, 0, 0, 0, Rate::ebu_25);
    for (int frame = 0; frame < 50; frame += 2)
        for (const Buffer& bytes : quarter_frames(plus_frames(start, frame)))
            for (cable.send(bytes); !cable.heard.empty(); cable.heard.clear())
                clock.feed(cable.heard.back(), cable.now - 10ms);
    const auto began = 5s; // frame 0
    EXPECT_NEAR(*clock.at_s(cable.now - 10ms),
                36000.0 + std::chrono::duration<double>(cable.now - 10ms - began).count(), 1e-6);
    EXPECT_NEAR(*clock.at_s(cable.now + 1h), 36003.0, 0.05) << "freewheels for a second";
}

TEST(MidiTimeCode, begins_in_the_middle_and_after_a_gap) {
    Cable cable;
    const TimeCode start = at(1, 0, 0, 0, Rate::ebu_25);
    const auto all = quarter_frames(start);
    for (std::size_t i = 3; i < 8; ++i) cable.send(all[i]);
    cable.forwards(plus_frames(start, 2), 2);
    EXPECT_EQ(cable.take(), (Texts{"01:00:00:04 EBU 25", "01:00:00:05 EBU 25"}));
    cable.now += 5s; // it stood, and goes on elsewhere
    cable.forwards(plus_frames(start, 1000), 2);
    EXPECT_EQ(cable.take(), (Texts{"01:00:40:02 EBU 25", "01:00:40:03 EBU 25"}));
    // One that is lost on the way spoils the eight that it belongs to.
    cable.forwards(plus_frames(start, 1004), 1);
    cable.take();
    const auto next = quarter_frames(plus_frames(start, 1006));
    for (std::size_t i = 0; i < 8; ++i)
        if (i != 2) cable.send(next[i]);
    EXPECT_EQ(cable.take(), Texts{"01:00:40:06 EBU 25"});
    cable.forwards(plus_frames(start, 1008), 2);
    EXPECT_EQ(cable.take(), (Texts{"01:00:40:10 EBU 25", "01:00:40:11 EBU 25"}));
}

TEST(MidiTimeCode, backwards) {
    Cable cable;
    const TimeCode start = at(0, 0, 10, 0, Rate::smpte_30);
    for (int frame = 0; frame > -8; frame -= 2) {
        const auto all = quarter_frames(plus_frames(start, frame));
        for (std::size_t i = 8; i-- > 0;) cable.send(all[i]);
    }
    EXPECT_EQ(cable.take(), (Texts{"00:00:10:00 SMPTE 30", "00:00:09:29 SMPTE 30", "00:00:09:28 SMPTE 30",
                                   "00:00:09:27 SMPTE 30", "00:00:09:26 SMPTE 30", "00:00:09:25 SMPTE 30",
                                   "00:00:09:24 SMPTE 30"}));
    cable.forwards(plus_frames(start, -6), 2); // and turns
    EXPECT_EQ(cable.take(), (Texts{"00:00:09:26 SMPTE 30", "00:00:09:27 SMPTE 30"}));
}

TEST(MidiTimeCode, other_messages_are_passed_over) {
    Cable cable;
    const TimeCode start = at(2, 0, 0, 0, Rate::film_24);
    for (const Buffer& bytes : quarter_frames(start)) {
        cable.send(
            {0x90, 60, 100, 61, 100, 0xB0, 1, 2, 0xC0, 5}); // notes with running status, control, program
        cable.send({0xF0, 1, 2, 3, 0xF8, 4, 0xF7});         // of somebody else
        cable.send({0xFE, 0xF8, bytes[0], 0xF8, bytes[1], 0x7F}); // clock within, and a stray byte
    }
    cable.send(quarter_frames(plus_frames(start, 2))[0]);
    EXPECT_EQ(cable.take(), Texts{"02:00:00:02 film 24"});
    // Exclusive messages that are nearly one.
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x01, 1, 2, 3, 0xF7});
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x01, 1, 2, 3, 4, 5, 0xF7});
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x02, 1, 2, 3, 4, 0xF7});
    cable.send({0xF0, 0x7E, 0x7F, 0x01, 0x01, 1, 2, 3, 4, 0xF7});
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x01, 1, 2, 3, 4, 0x90, 0xF7}); // not ended
    EXPECT_EQ(cable.take(), Texts{});
    EXPECT_EQ(cable.decoder.counters().full_frames, 0u);
    Buffer endless(100000, 1);
    endless[0] = 0xF0;
    cable.send(endless);
    cable.send({0xF7, 0xF0, 0x7F, 0x05, 0x01, 0xF8, 0x01, 1, 2, 3, 4, 0xF7});
    EXPECT_EQ(cable.take(), Texts{"01:02:03:04 film 24"});
}

TEST(MidiTimeCode, times_that_there_are_none_of) {
    Cable cable;
    for (const TimeCode& wrong : {at(24, 0, 0, 0, Rate::ebu_25), at(0, 60, 0, 0, Rate::ebu_25),
                                  at(0, 0, 60, 0, Rate::ebu_25), at(0, 0, 0, 25, Rate::ebu_25)}) {
        for (int i = 0; i < 2; ++i)
            for (const Buffer& bytes : quarter_frames(wrong)) cable.send(bytes);
        cable.now += 5s;
    }
    EXPECT_EQ(cable.decoder.counters().malformed, 8u);
    cable.send({0xF0, 0x7F, 0x7F, 0x01, 0x01, 0x20, 60, 0, 0, 0xF7});
    EXPECT_EQ(cable.decoder.counters().malformed, 9u);
    EXPECT_EQ(cable.take(), Texts{});
}

TEST(MidiTimeCode, noise_gives_valid_times_or_none) {
    std::mt19937 random(5);
    Cable cable;
    for (int i = 0; i < 20000; ++i) {
        Buffer bytes(random() % 40);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % 4 ? random() % 128 : random());
        if (i % 3 == 0) bytes.insert(bytes.begin(), {0xF1, static_cast<std::uint8_t>(random() % 128)});
        cable.send(bytes);
    }
    for (const TimeCode& time : cable.heard) EXPECT_TRUE(is_timecode(time));
}

TEST(TimeCode, frames_later_and_earlier) {
    const auto text = [](const TimeCode& time, int frames) {
        return timecode_text(plus_frames(time, frames));
    };
    EXPECT_EQ(text(at(23, 59, 59, 24, Rate::ebu_25), 1), "00:00:00:00 EBU 25");
    EXPECT_EQ(text(at(0, 0, 0, 0, Rate::film_24), -1), "23:59:59:23 film 24");
    EXPECT_EQ(text(at(0, 0, 59, 29, Rate::drop_29_97), 1), "00:01:00:02 drop-frame 29.97");
    EXPECT_EQ(text(at(0, 1, 0, 2, Rate::drop_29_97), -1), "00:00:59:29 drop-frame 29.97");
    EXPECT_EQ(text(at(0, 9, 59, 29, Rate::drop_29_97), 1), "00:10:00:00 drop-frame 29.97");
    EXPECT_EQ(text(at(23, 59, 59, 29, Rate::drop_29_97), 1), "00:00:00:00 drop-frame 29.97");
    // Every number of a day once, each a frame behind the one before.
    TimeCode time = at(0, 0, 0, 0, Rate::drop_29_97);
    for (int frame = 0; frame < 144 * 17982; ++frame) {
        ASSERT_TRUE(is_timecode(time));
        ASSERT_NEAR(timecode_seconds(time) * 30000 / 1001, frame, 1e-3);
        time = plus_frames(time, 1);
    }
    EXPECT_EQ(time, at(0, 0, 0, 0, Rate::drop_29_97));
}

} // namespace
} // namespace ghost::dmx
