// SPDX-License-Identifier: Apache-2.0
// Two desks that have the same say and move: which of them fight, and which share or follow each other.
#include "dmx/merge/merge.h"
#include "support/desk.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr int kSteps = 4;
constexpr nanoseconds kStep = 250ms;

using Levels4 = std::array<int, 4>;
using Look = std::function<Levels4(nanoseconds)>;

// One of the first four channels after the other, for a step each.
Levels4 chase(nanoseconds now) {
    Levels4 levels{};
    levels[static_cast<std::size_t>(now / kStep % kSteps)] = 255;
    return levels;
}

Packet packet_of(Desk& desk, const Levels4& levels) {
    return desk.packet({levels[0], levels[1], levels[2], levels[3]});
}

// Channels that two desks fight over at the end of this time.
std::size_t fought(const Look& first, const Look& second, std::uint8_t priority = 100,
                   nanoseconds time = 20s) {
    Merge merge;
    Desk a{1}, b{2, priority};
    for (nanoseconds now{0}; now < time; now += 25ms) {
        merge.feed(packet_of(a, first(now)), now);
        merge.feed(packet_of(b, second(now)), now);
        merge.tick(now);
        (void)merge.universes();
    }
    const std::vector<SourceStatus> sources = merge.sources(time);
    EXPECT_EQ(sources[0].slots_contested, sources[1].slots_contested);
    EXPECT_GE(sources[0].slots_overruled, sources[0].slots_contested);
    return sources[0].slots_contested;
}

TEST(Rivalry, a_forgotten_desk_at_full_under_a_chase) {
    const Look full = [](nanoseconds) { return Levels4{255, 255, 255, 255}; };
    EXPECT_EQ(fought(chase, full), 4u);
    EXPECT_EQ(fought(full, chase), 4u);
    EXPECT_EQ(fought(chase, full, 90), 0u) << "it has the lower priority";
}

TEST(Rivalry, one_chase_out_of_step) {
    EXPECT_EQ(fought(chase, [](nanoseconds now) { return chase(now + 500ms); }), 4u);
}

TEST(Rivalry, a_backup_that_follows) {
    for (const nanoseconds late : {25ms, 50ms, 75ms})
        EXPECT_EQ(fought(chase, [&](nanoseconds now) { return chase(now + kSteps * kStep - late); }), 0u)
            << late.count();
}

TEST(Rivalry, halves_of_a_universe) {
    const Look first = [](nanoseconds now) {
        return now / kStep % 2 ? Levels4{255, 0, 0, 0} : Levels4{0, 255, 0, 0};
    };
    const Look second = [](nanoseconds now) {
        return now / kStep % 2 ? Levels4{0, 0, 255, 0} : Levels4{0, 0, 0, 255};
    };
    EXPECT_EQ(fought(first, second), 0u);
}

TEST(Rivalry, a_channel_that_is_handed_over) {
    const Look first = [](nanoseconds now) { return now < 12s ? Levels4{255} : Levels4{0}; };
    const Look second = [](nanoseconds now) { return now < 14s ? Levels4{0} : Levels4{255}; };
    EXPECT_EQ(fought(first, second, 100, 15s), 0u);
}

TEST(Rivalry, what_was_mended_is_forgotten) {
    const Look full = [](nanoseconds now) {
        return now < 10s ? Levels4{255, 255, 255, 255} : Levels4{0, 0, 0, 0};
    };
    EXPECT_EQ(fought(chase, full, 100, 15s), 4u);
    EXPECT_EQ(fought(chase, full, 100, 40s), 0u);
}

TEST(Merge, a_universe_is_lost_as_soon_as_its_desk_says_goodbye) {
    Merge merge;
    Desk desk{1};
    merge.feed(desk.packet({255}), 0s);
    (void)merge.universes();
    merge.feed(desk.goodbye(), 1s);
    ASSERT_EQ(merge.lost(1s).size(), 1u) << "before the next tick, too";
    EXPECT_TRUE(merge.lost(1s)[0].ended);
    EXPECT_EQ(levels(merge, 1), Ints{255}) << "and its look is held";
}

} // namespace
} // namespace ghost::dmx
