// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/playout.h"

#include "support/must.h"
#include "support/test_recording.h"

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr nanoseconds kPeriod = 1'000'000'000ns / 44;

struct Sent {
    nanoseconds time{0};
    std::uint16_t universe = 0;
    std::uint16_t slot_count = 0;
    int level = 0; // of its first slot
};

Player player_of(const std::vector<RecordedFrame>& frames, std::chrono::microseconds duration) {
    const TestFolder folder;
    return Player(must(read_recording(write_bytes(folder.path / "a.ghostdmx", pack(frames, duration)))));
}

// Asks as the outlet does: at the time of the next look or repeat, but late by up to `late`.
std::vector<Sent> play(Player& player, nanoseconds length, nanoseconds late = 0ns) {
    Playout playout(player, kPeriod);
    std::vector<Sent> sent;
    std::mt19937 random(1);
    for (nanoseconds now{0}; now <= length;) {
        const double t_s = std::chrono::duration<double>(now).count();
        for (;;) {
            const Universes due = playout.due(t_s, now);
            if (due.list.empty()) break;
            for (const Universe& one : due.list)
                sent.push_back({now, one.number, one.slot_count, (*one.levels)[0]});
        }
        nanoseconds next = length + 1ns;
        if (const auto look_s = playout.next_look_s())
            next = std::min(next, nanoseconds(std::llround(*look_s * 1e9)));
        if (const auto repeat = playout.next_repeat()) next = std::min(next, *repeat);
        now = std::max(next, now + 1ns);
        if (late > 0ns) now += nanoseconds(static_cast<std::int64_t>(random()) % late.count());
    }
    return sent;
}

std::vector<RecordedFrame> looks_every(std::chrono::microseconds interval, int count) {
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < count; ++i) frames.push_back(make_frame(interval * i, 1, {i % 255 + 1, 7, 9}));
    return frames;
}

// 30, 40, 44 and 50 Hz are what desks send: each look at its own time, and nothing between.
TEST(Playout, every_look_of_a_desk_goes_out_once_and_in_time) {
    for (const auto interval : {33333us, 25000us, 22727us, 20000us}) {
        const std::vector<RecordedFrame> frames = looks_every(interval, 301);
        Player player = player_of(frames, interval * 300);
        const std::vector<Sent> sent = play(player, interval * 300);
        ASSERT_EQ(sent.size(), 301u) << interval.count();
        for (std::size_t i = 0; i < sent.size(); ++i) {
            EXPECT_EQ(sent[i].level, static_cast<int>(i) % 255 + 1);
            EXPECT_LE(std::chrono::abs(sent[i].time - nanoseconds(frames[i].time)), 1us);
        }
    }
}

TEST(Playout, a_caller_that_comes_late_loses_no_look) {
    Player player = player_of(looks_every(20ms, 301), 6s);
    std::vector<int> levels;
    for (const Sent& one : play(player, 7s, 90ms))
        if (levels.empty() || levels.back() != one.level) levels.push_back(one.level);
    EXPECT_EQ(levels.size(), 301u);
}

TEST(Playout, what_rests_is_repeated_at_the_rate) {
    Player player = player_of({make_frame(0us, 1, {1}), make_frame(0us, 2, {2})}, 10s);
    std::map<int, std::vector<nanoseconds>> times;
    for (const Sent& one : play(player, 10s)) times[one.universe].push_back(one.time);
    for (const int universe : {1, 2}) {
        const std::vector<nanoseconds>& of = times[universe];
        ASSERT_NEAR(static_cast<double>(of.size()), 440.0, 2.0);
        for (std::size_t i = 2; i < of.size(); ++i) EXPECT_EQ(of[i] - of[i - 1], kPeriod);
    }
}

TEST(Playout, universes_keep_their_slot_count) {
    auto more = make_frame(1s, 1, {3, 0, 0, 0});
    Player player = player_of({make_frame(0us, 1, {1, 2}), more}, 2s);
    for (const Sent& one : play(player, 2s)) EXPECT_EQ(one.slot_count, one.level == 1 ? 2 : 4);
}

TEST(Playout, a_jump_leaves_out_what_lies_between) {
    Player player = player_of(looks_every(20ms, 301), 6s);
    Playout playout(player, kPeriod);
    const auto levels_at = [&](double t_s, nanoseconds now) {
        std::vector<int> levels;
        for (Universes due = playout.due(t_s, now); !due.list.empty(); due = playout.due(t_s, now))
            levels.push_back(due.level(1, 1));
        return levels;
    };
    EXPECT_EQ(levels_at(0.0, 0s), std::vector<int>{1});
    EXPECT_EQ(levels_at(4.0, 1ms), std::vector<int>{201}) << "forwards";
    EXPECT_EQ(levels_at(3.96, 2ms), std::vector<int>{199}) << "back";
    EXPECT_EQ(levels_at(1.0, 3ms), std::vector<int>{51});
    EXPECT_EQ(levels_at(1.04, 4ms), (std::vector<int>{52, 53}));
    playout.rewind();
    EXPECT_EQ(levels_at(1.02, 5ms), std::vector<int>{52}) << "a round that begins anew, however near";
}

// Block after block: the times of looks are known beyond the end of what is unpacked.
TEST(Playout, a_recording_of_many_blocks) {
    const auto frames = random_frames(21, 9000, 12);
    Player player = player_of(frames, frames.back().time);
    ASSERT_GE(player.recording().blocks(), 5u);
    double at_s = 0.0;
    std::size_t steps = 0;
    std::set<std::int64_t> times;
    for (const RecordedFrame& frame : frames) times.insert(frame.time.count());
    times.erase(0);
    for (auto next = player.next_after(at_s); next; next = player.next_after(at_s), ++steps) {
        ASSERT_GT(*next, at_s);
        ASSERT_TRUE(times.contains(std::llround(*next * 1e6)));
        at_s = *next;
    }
    EXPECT_EQ(steps, times.size());
}

} // namespace
} // namespace ghost::dmx
