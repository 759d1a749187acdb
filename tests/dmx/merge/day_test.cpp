// SPDX-License-Identifier: Apache-2.0
// A day with a clock of its own: every five minutes desks come, fail over, fall silent and come back, so that
// each time-out runs out 288 times, never at the same place between two ticks. Before it the look stands,
// after it the next one does; at the end nothing is left over.
#include "dmx/receive/intake.h"
#include "dmx/receive/poll_answers.h"
#include "dmx/wire/build.h"
#include "sanitize/kept_freed.h"

#include <gtest/gtest.h>

#include <fstream>
#include <list>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr nanoseconds kTick = 100ms;  // as the receiver does
constexpr nanoseconds kEvery = 500ms; // a desk sends
constexpr nanoseconds kCycle = 300s;
constexpr int kCycles = 288;
constexpr nanoseconds kStart = 1000s;

struct Sending {
    Protocol protocol = Protocol::sacn;
    std::uint8_t id = 1; // of CID or address
    std::uint16_t universe = 1;
    std::uint8_t priority = 100;
    std::uint8_t level = 0;                    // of slots 1 and 2
    std::vector<std::uint8_t> slot_priorities; // sent as well, where there are any
    std::uint16_t sync = 0;
    std::uint8_t options = 0;
    bool on = true;
    std::uint8_t sequence = 0;

    IpAddress from() const { return IpAddress(0x0A000000u + id); }
    std::array<std::uint8_t, 16> cid() const { return {id}; }
};

class Day {
public:
    Day() : intake_(options()), answers_({0, 1, 2}) { intake_.merge().listen(now_); }

    Sending& desk(Sending desk) { return desks_.emplace_back(std::move(desk)); }
    void forget_desks() { desks_.clear(); }
    void run(nanoseconds time) {
        for (const nanoseconds end = now_ + time; now_ < end; now_ += kTick) {
            if (now_ >= next_) {
                for (Sending& one : desks_)
                    if (one.on) send(one);
                next_ = now_ + kEvery;
            }
            intake_.tick(now_);
            while (answers_.next(now_)) ++replies;
            (void)intake_.merge().universes();
        }
    }
    // The program was stopped: what waits is read after it went on.
    void stop(nanoseconds time) {
        now_ += time;
        intake_.merge().resume(time, now_);
        next_ = now_;
    }
    void shift(nanoseconds time) { now_ += time; }
    void send(Sending& desk) {
        const std::vector<std::uint8_t> slots{desk.level, desk.level};
        ++desk.sequence;
        if (desk.protocol == Protocol::artnet) {
            take(build_artdmx(static_cast<std::uint16_t>(desk.universe - 1), slots,
                              std::max<std::uint8_t>(desk.sequence, 1)),
                 desk);
            return;
        }
        take(build_sacn(desk.universe, slots, desk.sequence, {desk.priority, desk.cid(), "desk"},
                        {desk.options, 0, desk.sync}),
             desk);
        if (!desk.slot_priorities.empty())
            take(build_sacn(desk.universe, desk.slot_priorities, ++desk.sequence,
                            {desk.priority, desk.cid(), "desk"}, {desk.options, 0xDD, desk.sync}),
                 desk);
    }
    void take(const std::vector<std::uint8_t>& bytes, const Sending& from) {
        const auto poll =
            intake_.take(bytes, {from.protocol, from.from(), IpAddress(0x0A0000FFu), 0, 2, false, now_});
        if (poll) (void)answers_.asked(*poll, from.from().ipv4(), 0x0A000063, now_);
    }

    int level(int universe, int address = 1) {
        return intake_.merge().universes().level(static_cast<std::uint16_t>(universe), address);
    }
    bool lost(int universe) {
        const Universe* found = intake_.merge().universes().find(static_cast<std::uint16_t>(universe));
        return found && found->lost;
    }
    Statistics statistics() const {
        Statistics result;
        intake_.report(result, now_);
        return result;
    }
    std::uint64_t replies = 0;
    nanoseconds now() const { return now_; }

private:
    static IntakeOptions options() {
        IntakeOptions options;
        options.universes = {1, 2, 3, 4, 5};
        options.merge.sampling = kSamplingPeriod;
        options.merge.priority_wait = kPriorityWait;
        options.merge.loss.black_after = 20s;
        return options;
    }

    nanoseconds now_ = kStart;
    nanoseconds next_{0};
    Intake intake_;
    PollAnswers answers_;
    std::list<Sending> desks_;
};

#define AFTER(time, ...)                                                                                     \
    day.run(time);                                                                                           \
    EXPECT_EQ(__VA_ARGS__) << "cycle " << cycle << ", after " << #time

// E1.31: loss, take-over, priorities per address, goodbye, preview, our own pause.
void run_sacn(Day& day, int cycle) {
    Sending& main = day.desk({.id = 1, .level = 10});
    AFTER(3s, day.level(1), 10);
    Sending& backup = day.desk({.id = 2, .priority = 90, .level = 20});
    AFTER(5s, day.level(1), 10);
    main.on = false;
    AFTER(1900ms, day.level(1), 10);
    AFTER(1300ms, day.level(1), 20);
    main.on = true;
    AFTER(900ms, day.level(1), 20); // its priorities may still come
    AFTER(1300ms, day.level(1), 10);
    main.slot_priorities = {0, 200};
    AFTER(1s, day.level(1, 1), 20);
    EXPECT_EQ(day.level(1, 2), 10);
    main.slot_priorities.clear();
    AFTER(1900ms, day.level(1, 1), 20);
    AFTER(1300ms, day.level(1, 1), 10);
    backup.on = false;
    day.take(build_sacn(1, {}, ++backup.sequence, {90, backup.cid(), "desk"}, {0x40}), backup);
    AFTER(100ms, day.statistics().sources.size(), 1u);
    Sending& blind = day.desk({.id = 3, .level = 99, .options = 0x80});
    AFTER(1s, day.statistics().ignored.size(), 1u);
    blind.on = false;
    AFTER(9s, day.statistics().ignored.size(), 1u);
    AFTER(2s, day.statistics().ignored.size(), 0u);
    day.stop(30s);
    AFTER(1s, day.level(1), 10);
    EXPECT_FALSE(day.lost(1)) << "our pause is no loss, cycle " << cycle;
    main.on = false;
    AFTER(1900ms, day.lost(1), false);
    AFTER(1300ms, day.lost(1), true);
    EXPECT_EQ(day.level(1), 10);
    AFTER(16s, day.level(1), 10);
    AFTER(5s, day.level(1), 0); // 20 s after the loss
    EXPECT_EQ(day.statistics().lost.size(), static_cast<std::size_t>(cycle > 0 ? 5 : 1)) << cycle;
    main.on = true;
    AFTER(600ms, day.level(1), 10);
}

void run_artnet(Day& day, int cycle) {
    const auto artnet = [&](std::uint8_t id, std::uint16_t universe, std::uint8_t level) -> Sending& {
        return day.desk({.protocol = Protocol::artnet, .id = id, .universe = universe, .level = level});
    };
    Sending& a = artnet(11, 2, 30);
    Sending& b = artnet(12, 2, 40);
    AFTER(1s, day.level(2), 40);
    Sending& third = artnet(13, 2, 50);
    AFTER(1s, day.level(2), 40);
    EXPECT_EQ(day.statistics().ignored.size(), 1u) << cycle;
    third.on = b.on = false;
    AFTER(9400ms, day.level(2), 40);
    AFTER(1300ms, day.level(2), 30);
    a.on = false;
    AFTER(9400ms, day.lost(2), false);
    AFTER(1300ms, day.lost(2), true);
}

void run_synchronised(Day& day, int cycle) {
    Sending& forced = day.desk({.id = 21, .universe = 3, .level = 50, .sync = 7, .options = 0x20});
    Sending& strict = day.desk({.id = 22, .universe = 4, .level = 50, .sync = 7});
    Sending& artnet = day.desk({.protocol = Protocol::artnet, .id = 23, .universe = 5, .level = 50});
    AFTER(1s, day.level(3) + day.level(4) + day.level(5), 150); // nobody synchronises yet
    for (const Sending* one : {&forced, &strict})
        day.take(build_sacn_sync(7, static_cast<std::uint8_t>(cycle + 1), one->cid()), *one);
    day.take({'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x52, 0, 14, 0, 0}, artnet);
    forced.level = strict.level = artnet.level = 60;
    AFTER(2400ms, day.level(3), 50);
    AFTER(800ms, day.level(3), 60); // 2.5 s
    EXPECT_EQ(day.level(5), 50);
    AFTER(1500ms, day.level(5), 60); // 4 s
    EXPECT_EQ(day.level(4), 50);
    AFTER(5s, day.level(4), 50);
    AFTER(1s, day.level(4), 60); // 10 s
    EXPECT_EQ(day.statistics().sync.size(), 3u);
}

// Lists of universes, polls, universes that nobody asked for.
void run_lists(Day& day, int cycle) {
    Sending teller{.id = 31, .universe = 40};
    const std::uint16_t listed[] = {40};
    day.take(build_sacn_discovery(listed, 0, 0, teller.cid(), "desk"), teller);
    day.send(teller);
    const std::uint64_t replies = day.replies;
    Sending asker{.protocol = Protocol::artnet, .id = 32};
    for (int i = 0; i < 10; ++i) {
        day.take({'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x20, 0, 14, 0, 0}, asker);
        day.run(kEvery);
    }
    EXPECT_EQ(day.replies - replies, 3u * 3u) << "once in two seconds, cycle " << cycle;
    EXPECT_EQ(day.statistics().unlisted_universes.size(), 1u);
    AFTER(6s, day.statistics().unlisted_universes.size(), 0u);
    EXPECT_EQ(day.statistics().discovered.size(), 1u);
    AFTER(13s, day.statistics().discovered.size(), 1u);
    AFTER(3s, day.statistics().discovered.size(), 0u);
}

double memory_mb() {
    std::ifstream status("/proc/self/statm");
    long total = 0, resident = 0;
    status >> total >> resident;
    return static_cast<double>(resident) * 4096e-6;
}

TEST(Day, every_time_out_288_times) {
    Day day;
    double memory_before_mb = 0;
    for (int cycle = 0; cycle < kCycles && !testing::Test::HasFailure(); ++cycle) {
        if (cycle == 10) memory_before_mb = memory_mb();
        day.shift(nanoseconds(cycle) * 7'310'000 % kTick);
        run_sacn(day, cycle);
        run_artnet(day, cycle);
        run_synchronised(day, cycle);
        run_lists(day, cycle);
        day.forget_desks();
        day.run(kStart + (cycle + 1) * kCycle - day.now());
        const Statistics rest = day.statistics();
        EXPECT_TRUE(rest.sources.empty()) << cycle;
        EXPECT_TRUE(rest.sync.empty()) << cycle;
        EXPECT_EQ(rest.lost.size(), 5u) << cycle;
        EXPECT_EQ(rest.merge.missed, 0u) << cycle;
        EXPECT_EQ(rest.merge.out_of_sequence, 0u) << cycle;
    }
    EXPECT_GE(day.now() - kStart, 24h);
    EXPECT_GT(day.statistics().packets_sacn + day.statistics().packets_artnet, 100'000u);
    const MergeCounters counters = day.statistics().merge;
    EXPECT_EQ(counters.sources_terminated, static_cast<std::uint64_t>(kCycles));
    EXPECT_LT(memory_mb() - memory_before_mb, 2.0 + kKeptFreed_mb);
}

#undef AFTER

} // namespace
} // namespace ghost::dmx
