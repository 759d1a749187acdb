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

struct Met {
    std::size_t covered = 0, shared = 0;
    bool operator==(const Met&) const = default;
};

void PrintTo(const Met& met, std::ostream* out) {
    *out << met.covered << " covered, " << met.shared << " shared";
}

// Channels on which two desks meet at the end of this time.
Met met(const Look& first, const Look& second, std::uint8_t priority = 100, nanoseconds time = 20s) {
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
    EXPECT_EQ(sources[0].slots_shared, sources[1].slots_shared);
    return {sources[0].slots_contested, sources[0].slots_shared};
}

TEST(Rivalry, a_forgotten_desk_at_full_under_a_chase) {
    const Look full = [](nanoseconds) { return Levels4{255, 255, 255, 255}; };
    EXPECT_EQ(met(chase, full), Met({.covered = 4}));
    EXPECT_EQ(met(full, chase), Met({.covered = 4}));
    EXPECT_EQ(met(chase, full, 90), Met{}) << "it has the lower priority";
}

TEST(Rivalry, one_chase_out_of_step) {
    EXPECT_EQ(met(chase, [](nanoseconds now) { return chase(now + 500ms); }), Met({.shared = 4}));
}

TEST(Rivalry, a_backup_that_follows) {
    for (const nanoseconds late : {25ms, 50ms, 75ms})
        EXPECT_EQ(met(chase, [&](nanoseconds now) { return chase(now + kSteps * kStep - late); }), Met{})
            << late.count();
}

TEST(Rivalry, a_backup_that_follows_what_flashes) {
    for (const nanoseconds period : {80ms, 100ms, 200ms, 240ms, 300ms})
        for (const nanoseconds late : {20ms, 40ms, 70ms}) {
            const auto flash = [&](nanoseconds now) {
                const int level = now % period < period / 2 ? 255 : 0;
                return Levels4{level, 255 - level, level, 255};
            };
            EXPECT_EQ(met(flash, [&](nanoseconds now) { return flash(now + 12 * period - late); }), Met{})
                << period.count() << ", " << late.count();
        }
}

TEST(Rivalry, a_forgotten_desk_that_is_not_full) {
    const Look low = [](nanoseconds) { return Levels4{100, 100, 100, 100}; };
    EXPECT_EQ(met(chase, low), Met({.shared = 4})) << "the chase is seen above it";
    const Look quiet = [](nanoseconds now) {
        Levels4 levels = chase(now);
        for (int& level : levels) level = level * 77 / 255;
        return levels;
    };
    const Look middle = [](nanoseconds) { return Levels4{153, 153, 153, 153}; };
    EXPECT_EQ(met(quiet, middle), Met({.covered = 4}));
}

TEST(Rivalry, a_lamp_that_two_operators_bump) {
    const auto bump = [](nanoseconds every) {
        return [every](nanoseconds now) { return Levels4{now % every < 300ms ? 255 : 0, 0, 0, 0}; };
    };
    EXPECT_EQ(met(bump(1500ms), bump(2000ms)), Met({.shared = 1}));
}

TEST(Rivalry, a_bump_over_a_look_that_stands) {
    const Look bump = [](nanoseconds now) { return Levels4{now % 2000ms < 300ms ? 255 : 0, 0, 0, 0}; };
    const Look stands = [](nanoseconds) { return Levels4{100, 0, 0, 0}; };
    EXPECT_EQ(met(bump, stands), Met({.shared = 1}));
}

TEST(Rivalry, a_forgotten_desk_behind_a_third_one) {
    Merge merge;
    Desk panel{1}, desk{2}, forgotten{3};
    for (nanoseconds now{0}; now < 20s; now += 25ms) {
        merge.feed(panel.packet({0, 0, 0, 0}), now);
        merge.feed(packet_of(desk, chase(now)), now);
        merge.feed(packet_of(forgotten, {255, 255, 255, 255}), now);
        merge.tick(now);
        (void)merge.universes();
    }
    const std::vector<SourceStatus> sources = merge.sources(20s);
    EXPECT_EQ(sources[0].slots_contested, 0u);
    EXPECT_EQ(sources[1].slots_contested, 4u);
    EXPECT_EQ(sources[2].slots_contested, 4u);
}

TEST(Rivalry, halves_of_a_universe) {
    const Look first = [](nanoseconds now) {
        return now / kStep % 2 ? Levels4{255, 0, 0, 0} : Levels4{0, 255, 0, 0};
    };
    const Look second = [](nanoseconds now) {
        return now / kStep % 2 ? Levels4{0, 0, 255, 0} : Levels4{0, 0, 0, 255};
    };
    EXPECT_EQ(met(first, second), Met{});
}

TEST(Rivalry, a_channel_that_is_handed_over) {
    const Look first = [](nanoseconds now) { return now < 12s ? Levels4{255} : Levels4{0}; };
    const Look second = [](nanoseconds now) { return now < 14s ? Levels4{0} : Levels4{255}; };
    EXPECT_EQ(met(first, second, 100, 15s), Met{});
}

TEST(Rivalry, what_was_mended_is_forgotten) {
    const Look full = [](nanoseconds now) {
        return now < 10s ? Levels4{255, 255, 255, 255} : Levels4{0, 0, 0, 0};
    };
    EXPECT_EQ(met(chase, full, 100, 15s).covered, 4u);
    EXPECT_EQ(met(chase, full, 100, 40s), Met{});
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
