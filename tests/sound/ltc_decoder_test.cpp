// SPDX-License-Identifier: Apache-2.0
// LTC is made here, bit by bit after SMPTE 12M-1, and by libltc's encoder.
#include "sound/ltc_decoder.h"

#include "dmx/wire/timecode.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ltc.h>
#include <random>
#include <string>
#include <vector>

namespace ghost::sound {
namespace {

using namespace std::chrono_literals;
using dmx::plus_frames;
using dmx::TimeCode;
using Rate = TimeCode::Rate;
using Samples = std::vector<std::int16_t>;

constexpr int kRate_hz = 48000;
constexpr std::chrono::nanoseconds kBegin = 100s; // when the first sample is heard

TimeCode at(int hours, int minutes, int seconds, int frames, Rate rate) {
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
    TimeCode time;
    time.hours = byte(hours);
    time.minutes = byte(minutes);
    time.seconds = byte(seconds);
    time.frames = byte(frames);
    time.rate = rate;
    return time;
}

// The 80 bits of a frame, the first one first.
std::vector<bool> bits_of(const TimeCode& time) {
    std::vector<bool> bits(80, false);
    const auto put = [&](int from, int count, int value) {
        for (int k = 0; k < count; ++k) bits[static_cast<std::size_t>(from + k)] = value >> k & 1;
    };
    put(0, 4, time.frames % 10);
    put(8, 2, time.frames / 10);
    put(10, 1, time.rate == Rate::drop_29_97);
    put(16, 4, time.seconds % 10);
    put(24, 3, time.seconds / 10);
    put(32, 4, time.minutes % 10);
    put(40, 3, time.minutes / 10);
    put(48, 4, time.hours % 10);
    put(56, 2, time.hours / 10);
    put(64, 16, 0xBFFC); // 0011 1111 1111 1101
    return bits;
}

// Frames in a row as a sound.
struct Tape {
    Samples samples;
    double level = 10000;
    double speed = 1;

    void add(const TimeCode& start, int frames) {
        for (int k = 0; k < frames; ++k) {
            const TimeCode time = plus_frames(start, k);
            const double bit = kRate_hz * dmx::frame_seconds(time.rate) / 80 / speed;
            for (const bool one : bits_of(time)) {
                flip();
                until_ += bit / 2;
                fill();
                if (one) flip();
                until_ += bit / 2;
                fill();
            }
        }
    }
    void add_silence(double seconds) {
        until_ += seconds * kRate_hz;
        samples.resize(static_cast<std::size_t>(std::lround(until_)), 0);
    }
    // All that was added, the other way round.
    void turn() { std::reverse(samples.begin(), samples.end()); }

private:
    void flip() { level = -level; }
    void fill() {
        samples.resize(static_cast<std::size_t>(std::lround(until_)), static_cast<std::int16_t>(level));
    }
    double until_ = 0;
};

struct Heard {
    TimeCode time;
    double at_s = 0; // of the sound
};

// As an input brings it: in pieces.
std::vector<Heard> heard(const Samples& samples, LtcDecoder& decoder, std::size_t piece = 480) {
    std::vector<Heard> result;
    for (std::size_t from = 0; from < samples.size(); from += piece) {
        const std::size_t count = std::min(piece, samples.size() - from);
        const auto end = kBegin + std::chrono::nanoseconds(static_cast<std::int64_t>(from + count) *
                                                           1'000'000'000 / kRate_hz);
        decoder.feed(std::span(samples).subspan(from, count), end, [&](const TimeCode& time, auto moment) {
            result.push_back({time, std::chrono::duration<double>(moment - kBegin).count()});
        });
    }
    return result;
}

std::vector<Heard> heard(const Samples& samples) {
    LtcDecoder decoder(kRate_hz);
    return heard(samples, decoder);
}

const std::vector<Rate> kRates{Rate::film_24, Rate::ebu_25, Rate::drop_29_97, Rate::smpte_30};

TEST(Ltc, each_frame_is_heard_when_it_is) {
    for (const Rate rate : kRates) {
        const TimeCode start = at(10, 0, 59, 10, rate);
        Tape tape;
        tape.add(start, 100);
        const auto frames = heard(tape.samples);
        ASSERT_GE(frames.size(), 97u) << static_cast<int>(rate);
        for (const Heard& one : frames) {
            const double in_frames = one.at_s / dmx::frame_seconds(rate);
            const int number = static_cast<int>(std::lround(in_frames));
            EXPECT_NEAR(in_frames, number, 0.02) << static_cast<int>(rate);
            EXPECT_EQ(dmx::timecode_text(one.time), dmx::timecode_text(plus_frames(start, number)));
        }
    }
}

TEST(Ltc, backwards_each_frame_is_heard_when_it_is) {
    for (const Rate rate : kRates) {
        const TimeCode start = at(10, 0, 59, 10, rate);
        Tape tape;
        tape.add(start, 100);
        tape.turn();
        const auto frames = heard(tape.samples);
        ASSERT_GE(frames.size(), 96u) << static_cast<int>(rate);
        for (const Heard& one : frames) {
            const double in_frames = one.at_s / dmx::frame_seconds(rate);
            const int back = static_cast<int>(std::lround(in_frames));
            EXPECT_NEAR(in_frames, back, 0.05) << static_cast<int>(rate);
            EXPECT_EQ(dmx::timecode_text(one.time), dmx::timecode_text(plus_frames(start, 100 - back)))
                << static_cast<int>(rate);
        }
    }
}

TEST(Ltc, of_libltcs_encoder) {
    LTCEncoder* const encoder = ltc_encoder_create(kRate_hz, 25, LTC_TV_625_50, 0);
    SMPTETimecode begin{};
    begin.hours = 1;
    begin.secs = 58;
    ltc_encoder_set_timecode(encoder, &begin);
    Samples samples;
    for (int k = 0; k < 100; ++k) {
        ltc_encoder_encode_frame(encoder);
        ltc_encoder_inc_timecode(encoder);
        ltcsnd_sample_t* bytes = nullptr;
        const int count = ltc_encoder_get_bufferptr(encoder, &bytes, 1);
        for (int i = 0; i < count; ++i) samples.push_back(static_cast<std::int16_t>((bytes[i] - 128) * 200));
    }
    ltc_encoder_free(encoder);
    const auto frames = heard(samples);
    ASSERT_GE(frames.size(), 96u);
    for (const Heard& one : frames) EXPECT_NEAR(dmx::timecode_seconds(one.time), 3658 + one.at_s, 0.001);
}

TEST(Ltc, faster_and_slower_quieter_and_in_other_pieces) {
    const TimeCode start = at(1, 2, 3, 4, Rate::ebu_25);
    for (const double speed : {0.5, 0.9, 1.1, 2.0})
        for (const double level : {300.0, 30000.0}) {
            Tape tape;
            tape.speed = speed;
            tape.level = level;
            tape.add(start, 150);
            LtcDecoder decoder(kRate_hz);
            const auto frames = heard(tape.samples, decoder, 777);
            ASSERT_GE(frames.size(), 100u) << speed << " " << level;
            for (const Heard& one : frames) {
                if (speed * one.at_s < 1) continue; // how many frames a second has is known from its end on
                EXPECT_NEAR(dmx::timecode_seconds(one.time), dmx::timecode_seconds(start) + speed * one.at_s,
                            0.001)
                    << speed;
            }
            EXPECT_NEAR(decoder.counters().level_dbfs, 20 * std::log10(level / 32768), 3) << level;
        }
}

TEST(Ltc, noise_loses_frames_and_invents_none) {
    const TimeCode start = at(1, 2, 3, 4, Rate::ebu_25);
    for (const int noise : {1000, 4000, 9000, 14000, 20000}) {
        Tape tape;
        tape.add(start, 500);
        std::mt19937 random(7);
        std::uniform_int_distribution<int> hiss(-noise, noise);
        for (std::int16_t& sample : tape.samples)
            sample = static_cast<std::int16_t>(std::clamp(sample + hiss(random), -32768, 32767));
        const auto frames = heard(tape.samples);
        if (noise <= 4000) {
            EXPECT_GE(frames.size(), 490u) << noise;
        }
        for (const Heard& one : frames)
            EXPECT_NEAR(dmx::timecode_seconds(one.time), dmx::timecode_seconds(start) + one.at_s, 0.003)
                << noise;
    }
}

// libltc, once it took noise for bits, may never find any again.
TEST(Ltc, after_hiss_it_is_found_within_seconds) {
    const TimeCode start = at(1, 2, 3, 4, Rate::ebu_25);
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Tape tape;
        tape.level = 12000;
        tape.add_silence(0.8);
        tape.add(start, 150); // 6 s
        std::mt19937 random(seed);
        std::normal_distribution<double> hiss(0.0, 400.0);
        for (std::int16_t& sample : tape.samples)
            sample = static_cast<std::int16_t>(std::clamp(sample + hiss(random), -32768.0, 32767.0));
        const auto frames = heard(tape.samples);
        EXPECT_GE(frames.size(), 60u) << seed;
        for (const Heard& one : frames)
            EXPECT_NEAR(dmx::timecode_seconds(one.time) - dmx::timecode_seconds(start), one.at_s - 0.8, 0.003)
                << seed;
    }
}

TEST(Ltc, drop_outs_and_jumps) {
    const TimeCode start = at(1, 0, 0, 0, Rate::ebu_25), other = at(20, 0, 0, 0, Rate::ebu_25);
    Tape tape;
    tape.add(start, 50);
    for (std::size_t k = 48000; k < 48000 + 9600; ++k) tape.samples[k] = 0; // a fifth of a second
    tape.add(other, 50);
    tape.add_silence(1);
    tape.add(plus_frames(start, 500), 50);
    std::vector<Heard> frames = heard(tape.samples);
    const auto from = [&](double begin_s, double end_s) {
        std::vector<Heard> part;
        for (const Heard& one : frames)
            if (one.at_s >= begin_s && one.at_s < end_s) part.push_back(one);
        return part;
    };
    EXPECT_TRUE(from(1.01, 1.2).empty());
    ASSERT_GE(from(1.2, 2.001).size(), 15u) << "the first whole frame goes on where it was";
    for (const Heard& one : from(0, 2.001))
        EXPECT_NEAR(dmx::timecode_seconds(one.time), 3600 + one.at_s, 0.001);
    ASSERT_GE(from(2.001, 4.001).size(), 48u);
    for (const Heard& one : from(2.001, 4.001))
        EXPECT_NEAR(dmx::timecode_seconds(one.time), 72000 + one.at_s - 2, 0.001);
    EXPECT_TRUE(from(4.001, 5).empty());
    ASSERT_GE(from(5, 8).size(), 46u);
    for (const Heard& one : from(5, 8))
        EXPECT_NEAR(dmx::timecode_seconds(one.time), 3620 + one.at_s - 5, 0.001);
}

TEST(Ltc, stands_where_the_same_frame_comes_again) {
    const TimeCode start = at(1, 0, 0, 0, Rate::ebu_25);
    Tape tape;
    tape.add(start, 50);
    for (int k = 0; k < 25; ++k) tape.add(plus_frames(start, 50), 1);
    const auto frames = heard(tape.samples);
    ASSERT_GE(frames.size(), 70u);
    for (std::size_t k = frames.size() - 20; k < frames.size(); ++k)
        EXPECT_EQ(dmx::timecode_text(frames[k].time), "01:00:02:00 EBU 25");
}

TEST(Ltc, what_is_no_time_code_brings_none) {
    std::mt19937 random(3);
    Samples hiss, tone, square;
    for (int k = 0; k < 10 * kRate_hz; ++k) {
        hiss.push_back(static_cast<std::int16_t>(random()));
        tone.push_back(static_cast<std::int16_t>(20000 * std::sin(k * 0.1)));
        square.push_back(k / 10 % 2 ? 32767 : -32768);
    }
    for (const Samples& samples :
         {hiss, tone, square, Samples(480000, 0), Samples(480000, -32768), Samples{}})
        EXPECT_TRUE(heard(samples).empty());
}

} // namespace
} // namespace ghost::sound
