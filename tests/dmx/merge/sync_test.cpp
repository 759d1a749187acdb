// SPDX-License-Identifier: Apache-2.0
// Universe synchronisation (E1.31-2018 6.2.4.1 and 6.3) and ArtSync (Art-Net 4): what is held, until when.
#include "support/desk.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

TEST(Sync, levels_show_at_once_until_the_first_sync_packet) {
    Merge merge;
    Desk a;
    merge.feed(a.synchronised(50, {10}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(a.synchronised(50, {11}), 9s); // a sender that never sends one must not freeze (PyArtNet)
    EXPECT_EQ(levels(merge, 1), Ints{11});
}

TEST(Sync, two_universes_change_together) {
    Merge merge;
    Desk a{1, 100, 1}, b{1, 100, 2}; // one desk, two universes
    merge.feed(a.sync(50), 0s);
    merge.feed(a.synchronised(50, {10}), 0s);
    merge.feed(b.synchronised(50, {20}), 0s);
    EXPECT_FALSE(merge.pending());
    EXPECT_TRUE(merge.universes().list.empty());
    EXPECT_TRUE(merge.sources(0s).at(0).held);
    merge.feed(a.sync(50), 20ms);
    EXPECT_EQ(levels(merge, 1, 1), Ints{10});
    EXPECT_EQ(levels(merge, 1, 2), Ints{20});
    EXPECT_FALSE(merge.sources(0s).at(0).held);
    EXPECT_EQ(merge.counters().held, 2u);
    // Of two packets between two syncs the newer is shown.
    merge.feed(a.synchronised(50, {11}), 30ms);
    merge.feed(a.synchronised(50, {12}), 30ms);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(a.sync(50), 40ms);
    EXPECT_EQ(levels(merge, 1), Ints{12});
}

TEST(Sync, only_that_source_and_that_universe) {
    Merge merge;
    Desk a{1}, other{2};
    merge.feed(a.sync(50), 0s);
    merge.feed(a.synchronised(50, {10}), 0s);
    merge.feed(other.sync(50), 0s);
    merge.feed(a.sync(51), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{0});
    merge.feed(other.synchronised(0, {5}), 0s); // not synchronised: at once
    EXPECT_EQ(levels(merge, 1), Ints{5});
    merge.feed(a.sync(50), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    EXPECT_EQ(merge.sync_universes(), std::vector<std::uint16_t>{50});
}

// Each number costs a group on each interface: of a thousand forged ones few are joined, and the desk's
// stays.
TEST(Sync, forged_sync_universes_are_bounded_and_do_not_drive_out_the_desk) {
    Merge merge;
    for (std::uint16_t k = 0; k < 1000; ++k) {
        Desk forged{static_cast<std::uint8_t>(10 + k % 100), 100, static_cast<std::uint16_t>(1 + k / 8)};
        merge.feed(forged.synchronised(static_cast<std::uint16_t>(1000 + k), {1}), 0s);
    }
    for (std::uint16_t universe = 200; universe < 204; ++universe) {
        Desk desk{1, 100, universe};
        merge.feed(desk.synchronised(60'000, {1}), 0s);
    }
    const std::vector<std::uint16_t> joined = merge.sync_universes();
    EXPECT_EQ(joined.size(), kMaxSyncGroups);
    EXPECT_TRUE(std::is_sorted(joined.begin(), joined.end()));
    EXPECT_TRUE(std::binary_search(joined.begin(), joined.end(), 60'000));
}

TEST(Sync, a_late_or_repeated_sync_packet_shows_nothing) {
    Merge merge;
    Desk a;
    const SyncPacket first = a.sync(50);
    merge.feed(first, 0s);
    merge.feed(a.synchronised(50, {10}), 0s);
    merge.feed(first, 1s);
    EXPECT_EQ(levels(merge, 1), Ints{0});
    EXPECT_EQ(merge.sync().list(1s).at(0).late, 1u);
}

TEST(Sync, after_loss_a_source_that_forces_goes_on_after_2500ms) {
    Merge merge;
    Desk a;
    merge.feed(a.sync(50), 0s);
    merge.feed(a.synchronised(50, {10}, true), 2500ms);
    merge.tick(2500ms);
    EXPECT_EQ(levels(merge, 1), Ints{0});
    merge.tick(2501ms); // what waited is shown ...
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(a.synchronised(50, {11}, true), 2600ms); // ... and the next at once
    EXPECT_EQ(levels(merge, 1), Ints{11});
    merge.feed(a.sync(50), 3s); // synchronisation resumes
    merge.feed(a.synchronised(50, {12}, true), 3s);
    EXPECT_EQ(levels(merge, 1), Ints{11});
}

TEST(Sync, after_loss_one_that_does_not_force_holds_but_not_for_ever) {
    Merge merge;
    Desk a;
    merge.feed(a.sync(50), 0s);
    for (auto t = 0ms; t <= 12s; t += 500ms) {
        merge.feed(a.synchronised(50, {static_cast<int>(t / 100ms)}), t);
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{t <= 10s ? 0 : static_cast<int>(t / 100ms)}) << t.count();
    }
}

TEST(Sync, how_long_levels_wait_is_told) {
    Merge merge;
    Desk desk{1};
    merge.feed(desk.packet({1}), 0s);
    merge.feed(desk.sync(9), 0s);
    for (const auto now : {100ms, 600ms, 1100ms}) merge.feed(desk.synchronised(9, {2}), now);
    EXPECT_EQ(merge.sources(1200ms).at(0).held_for, 1100ms) << "the first of them";
    merge.feed(desk.sync(9), 1300ms);
    EXPECT_FALSE(merge.sources(1300ms).at(0).held);
    merge.feed(desk.synchronised(9, {3}), 1400ms);
    EXPECT_EQ(merge.sources(1450ms).at(0).held_for, 50ms);
}

TEST(Sync, priorities_wait_too) {
    Merge merge;
    Desk a{1}, b{2};
    merge.feed(b.packet({7}), 0s);
    merge.feed(a.sync(50), 0s);
    Packet zero = a.priorities({0});
    zero.sync_universe = 50;
    merge.feed(zero, 0s);
    merge.feed(a.synchronised(50, {99}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{7});
    merge.feed(a.sync(50), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{7}) << "its priority 0 came into force with its levels";
}

TEST(Sync, what_waited_is_the_look_that_is_held_after_goodbye) {
    Merge merge;
    Desk a;
    merge.feed(a.sync(50), 0s);
    merge.feed(a.synchronised(50, {10}), 0s);
    merge.feed(a.goodbye(), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    EXPECT_TRUE(merge.universes().find(1)->lost);
}

TEST(Sync, streams_are_limited_and_forgotten) {
    Merge merge;
    for (int i = 0; i < 1000; ++i) {
        SyncPacket sync;
        sync.source.id[0] = static_cast<std::uint8_t>(i);
        sync.source.id[1] = static_cast<std::uint8_t>(i >> 8);
        sync.universe = 5;
        merge.feed(sync, 0s);
    }
    EXPECT_EQ(merge.sync().list(0s).size(), kMaxSyncStreams);
    EXPECT_EQ(merge.sync().too_many(), 1000 - kMaxSyncStreams);
    merge.tick(61s);
    EXPECT_TRUE(merge.sync().list(61s).empty());
}

TEST(ArtSync, holds_the_levels_of_its_sender_from_the_first_on) {
    Merge merge;
    merge.feed(art(1, 0, {10}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(art_sync(1), 0s);
    merge.feed(art(1, 0, {11}), 1s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(art_sync(2), 1s); // of somebody else: ignored
    EXPECT_EQ(levels(merge, 1), Ints{10});
    merge.feed(art_sync(1), 1s);
    EXPECT_EQ(levels(merge, 1), Ints{11});
    merge.feed(art(1, 0, {12}), 5001ms); // 4 s after the last one: as before
    EXPECT_EQ(levels(merge, 1), Ints{12});
}

TEST(ArtSync, whatever_the_physical_port) {
    Merge merge;
    merge.feed(art_sync(1), 0s);
    Packet packet = art(1, 0, {10});
    packet.source.id[4] = 3;
    merge.feed(packet, 0s);
    EXPECT_EQ(levels(merge, 1), Ints{0});
    merge.feed(art_sync(1), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
}

TEST(ArtSync, is_ignored_while_two_sources_merge) {
    Merge merge;
    merge.feed(art(1, 0, {10}), 0s);
    merge.feed(art(2, 0, {20}), 0s);
    merge.feed(art_sync(1), 0s);
    merge.feed(art(1, 0, {30}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{30});
}

} // namespace
} // namespace ghost::dmx
