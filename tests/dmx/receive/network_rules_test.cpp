// SPDX-License-Identifier: Apache-2.0
// The rules that keep a rig from flashing: sampling period, waiting for priorities, settled loss, one way of
// two, what is shown on loss, and what forged sources cannot do.
#include "dmx/merge/settle.h"
#include "support/desk.h"

#include <gtest/gtest.h>

#include <set>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

MergeOptions as_the_receiver() {
    MergeOptions options;
    options.sampling = kSamplingPeriod;
    options.priority_wait = kPriorityWait;
    return options;
}

TEST(Sampling, nothing_shows_until_all_sources_are_known) {
    Merge merge(as_the_receiver());
    merge.listen(10s);
    Desk low{1, 50}, high{2, 150};
    merge.feed(low.packet({5}), 10s);
    EXPECT_FALSE(merge.pending());
    EXPECT_TRUE(merge.universes().list.empty());
    merge.feed(high.packet({9}), 11s);
    merge.tick(11400ms);
    EXPECT_TRUE(merge.sampling());
    merge.tick(11500ms);
    EXPECT_FALSE(merge.sampling());
    EXPECT_TRUE(merge.pending());
    EXPECT_EQ(levels(merge, 1), Ints{9}); // both at once: heard while sampling
    EXPECT_EQ(merge.sources(11500ms).at(1).state, SourceState::live);
}

TEST(Sampling, a_source_that_says_goodbye_meanwhile_was_never_there) {
    Merge merge(as_the_receiver());
    merge.listen(0s);
    Desk a;
    merge.feed(a.packet({5}), 0s);
    merge.feed(a.goodbye(), 1s);
    merge.tick(2s);
    EXPECT_TRUE(merge.universes().list.empty());
}

TEST(Priorities, a_newcomer_beside_others_waits_for_its_own) {
    Merge merge(as_the_receiver());
    Desk a{1}, b{2};
    merge.feed(a.packet({10, 10}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{10, 10})) << "alone: at once";
    merge.feed(b.packet({200, 200}), 1s);
    EXPECT_EQ(levels(merge, 2), (Ints{10, 10}));
    EXPECT_EQ(merge.sources(1s).at(1).state, SourceState::waiting);
    merge.feed(b.priorities({0, 150}), 1200ms); // they came
    EXPECT_EQ(levels(merge, 2), (Ints{10, 200}));
    EXPECT_EQ(merge.sources(1s).at(1).state, SourceState::live);
}

TEST(Priorities, without_them_it_takes_part_after_1500ms) {
    Merge merge(as_the_receiver());
    Desk a{1}, b{2};
    merge.feed(a.packet({10}), 0s);
    for (auto t = 0ms; t <= 3s; t += 100ms) {
        merge.feed(a.packet({10}), t);
        if (t >= 1s) merge.feed(b.packet({200}), t);
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{t < 2500ms ? 10 : 200}) << t.count();
    }
}

TEST(Priorities, a_waiting_source_takes_over_when_the_others_leave) {
    Merge merge(as_the_receiver());
    Desk a{1}, b{2};
    merge.feed(a.packet({10}), 0s);
    merge.feed(b.packet({20}), 0s);
    merge.feed(a.goodbye(), 100ms);
    EXPECT_EQ(levels(merge, 1), Ints{20});
    EXPECT_FALSE(merge.universes().find(1)->lost);
}

// ETC rule 15: without levels a source is lost, however many priorities it sends.
TEST(Priorities, alone_keep_no_source_alive) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({10}), 0s);
    for (auto t = 0ms; t <= 2600ms; t += 200ms) {
        merge.feed(a.priorities({100}), t);
        merge.tick(t);
    }
    merge.tick(2600ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
}

TEST(Priorities, values_over_200_hold_nothing) {
    Merge merge;
    Desk a{1}, b{2};
    merge.feed(a.packet({10, 10}), 0s);
    merge.feed(b.packet({20, 20}), 0s);
    merge.feed(b.priorities({201, 200}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{10, 20}));
}

// A switch loses power: all sources fall silent within a refresh of each other.
TEST(Loss, a_pulled_cable_shows_no_look_in_between) {
    Merge merge;
    Desk main{1, 150}, backup{2, 100};
    merge.feed(main.packet({200}), 0s);
    merge.feed(backup.packet({10}), 22ms);
    for (auto t = 100ms; t <= 4s; t += 10ms) {
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{200}) << t.count();
    }
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(merge.counters().sources_lost, 2u);
}

TEST(Loss, a_dead_desk_gives_way_with_the_next_packet_of_the_other) {
    Merge merge;
    Desk main{1, 150}, backup{2, 100};
    merge.feed(main.packet({200}), 0s);
    merge.feed(backup.packet({10}), 2400ms); // unchanged levels come once a second
    merge.tick(2600ms);
    EXPECT_EQ(levels(merge, 1), Ints{200});
    EXPECT_EQ(merge.sources(2600ms).at(0).state, SourceState::silent);
    merge.feed(backup.packet({10}), 3400ms);
    merge.tick(3500ms);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    EXPECT_FALSE(merge.universes().find(1)->lost);
}

TEST(Loss, one_that_comes_back_meanwhile_was_never_gone) {
    Merge merge;
    Desk main{1, 150}, backup{2, 100};
    merge.feed(main.packet({200}), 0s);
    merge.feed(backup.packet({10}), 2400ms);
    merge.tick(2600ms);
    merge.feed(main.packet({201}), 2700ms);
    merge.feed(backup.packet({10}), 3400ms);
    merge.tick(3500ms);
    EXPECT_EQ(levels(merge, 1), Ints{201});
    EXPECT_EQ(merge.counters().sources_lost, 0u);
}

TEST(Loss, universes_settle_on_their_own) {
    Merge merge;
    Desk one{1, 100, 1}, two{1, 100, 2};
    merge.feed(one.packet({1}), 0s);
    merge.feed(two.packet({2}), 2s);
    merge.tick(2600ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_FALSE(merge.universes().find(2)->lost);
}

TEST(Loss, black_by_choice_at_once_or_later) {
    for (const auto after : {0ms, 5000ms}) {
        MergeOptions options;
        options.loss.black_after = after;
        Merge merge(options);
        Desk a;
        merge.feed(a.packet({20}), 0s);
        for (auto t = 0ms; t <= 9s; t += 100ms) {
            merge.tick(t);
            const bool lost = t > 2500ms, black = lost && t >= 2600ms + after;
            EXPECT_EQ(levels(merge, 1), Ints{black ? 0 : 20}) << t.count() << " " << after.count();
            EXPECT_EQ(merge.universes().find(1)->lost, lost) << t.count();
            EXPECT_EQ(merge.universes().find(1)->black, black) << t.count();
        }
        merge.feed(a.packet({30}), 10s);
        EXPECT_EQ(levels(merge, 1), Ints{30});
        EXPECT_FALSE(merge.universes().find(1)->black);
    }
}

TEST(Ways, of_two_network_cards_the_first_counts_until_it_is_silent) {
    Merge merge;
    Desk desk;
    for (auto t = 0ms; t < 1s; t += 25ms) {
        Packet packet = desk.packet({static_cast<int>(t / 25ms)});
        packet.from = 0x0A000001;
        packet.interface_index = 2;
        merge.feed(packet, t);
        packet.interface_index = 3; // the same packet through the other card of ours
        merge.feed(packet, t);
    }
    EXPECT_EQ(merge.counters().other_way, 40u);
    EXPECT_EQ(merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(merge.counters().missed, 0u);
    EXPECT_EQ(merge.sources(1s).at(0).other_way, 40u);
    EXPECT_EQ(levels(merge, 1), Ints{39});
    // The first cable is pulled at 975 ms.
    for (auto t = 1000ms; t < 3s; t += 25ms) {
        Packet packet = desk.packet({static_cast<int>(t / 25ms)});
        packet.from = 0x0A000001;
        packet.interface_index = 3;
        merge.feed(packet, t);
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{t <= 975ms + kWaySilence ? 39 : static_cast<int>(t / 25ms)})
            << t.count();
    }
    EXPECT_EQ(merge.counters().sources_lost, 0u);
}

TEST(Ways, a_goodbye_from_elsewhere_is_not_believed) {
    Merge merge;
    Desk desk, forger;
    Packet packet = desk.packet({50});
    packet.from = 0x0A000001;
    merge.feed(packet, 0s);
    Packet bye = forger.goodbye();
    bye.from = 0x0A000066;
    merge.feed(bye, 100ms);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    EXPECT_EQ(merge.counters().other_way, 1u);
    EXPECT_EQ(merge.counters().sources_terminated, 0u);
}

TEST(Ways, a_storm_of_numbers_from_elsewhere_does_not_stop_the_desk) {
    Merge merge;
    Desk desk;
    for (int i = 0; i < 500; ++i) {
        Packet packet = desk.packet({i % 256});
        packet.from = 0x0A000001;
        merge.feed(packet, std::chrono::milliseconds(i * 20));
        for (int k = 0; k < 20; ++k) {
            packet.from = 0x0A000066;
            packet.sequence = static_cast<std::uint8_t>(packet.sequence + 13);
            packet.slots[0] = 99;
            merge.feed(packet, std::chrono::milliseconds(i * 20));
        }
        ASSERT_EQ(levels(merge, 1), Ints{i % 256});
    }
    EXPECT_EQ(merge.counters().out_of_sequence, 0u);
}

TEST(Pause, time_in_which_we_did_not_listen_is_no_loss) {
    MergeOptions options;
    options.loss.black_after = 0s;
    Merge merge(options);
    Desk a;
    merge.feed(a.packet({20}), 1s);
    merge.resume(30s, 31s); // stopped from 1 s to 31 s
    merge.tick(31s);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    EXPECT_EQ(levels(merge, 1), Ints{20});
    a.sequence = 0; // 1 again: by its number late
    merge.feed(a.packet({21}), 31s);
    EXPECT_EQ(levels(merge, 1), Ints{21});
    merge.tick(33600ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
}

TEST(Pause, what_was_read_in_the_middle_of_it_is_not_of_the_future) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({20}), 1s);
    merge.feed(a.packet({21}), 29s); // waited in the socket
    merge.resume(30s, 31s);
    merge.tick(33400ms);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    merge.tick(33600ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
}

TEST(Pause, all_sources_of_a_universe_were_heard_since) {
    Merge merge;
    Desk a{1}, b{2};
    merge.feed(a.packet({20}), 1s);
    merge.feed(b.packet({30}), 1s);
    merge.resume(30s, 31s);
    EXPECT_FALSE(merge.all_heard_since(1, 31s));
    merge.feed(a.packet({21}), 31010ms);
    EXPECT_FALSE(merge.all_heard_since(1, 31s));
    merge.feed(b.packet({31}), 31020ms);
    EXPECT_TRUE(merge.all_heard_since(1, 31s));
}

TEST(Preview, replaces_the_live_look_and_never_merges_with_it) {
    MergeOptions options;
    options.show_preview = true;
    Merge merge(options);
    Desk a{1}, b{2};
    merge.feed(a.packet({200, 200}), 0s);
    Packet blind = b.packet({5, 0});
    blind.source.preview = true;
    merge.feed(blind, 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{5, 0}));
    Packet bye = b.goodbye();
    bye.source.preview = true;
    merge.feed(bye, 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{200, 200}));
}

TEST(ArtnetMerge, latest_takes_precedence_by_choice_slot_by_slot) {
    MergeOptions options;
    options.artnet_ltp = true;
    Merge merge(options);
    merge.feed(art(1, 0, {200, 10}), 0s);
    merge.feed(art(2, 0, {50, 10}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{50, 10}));
    for (int i = 0; i < 5; ++i) { // repeating a level is no change
        merge.feed(art(1, 0, {200, 10}), 0s);
        EXPECT_EQ(levels(merge, 2), (Ints{50, 10}));
    }
    merge.feed(art(1, 0, {200, 3}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{50, 3}));
    Desk sacn; // and highest-takes-precedence with sACN of the same priority
    merge.feed(sacn.packet({20, 20}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{50, 20}));
}

TEST(Forged, ten_thousand_sources_change_nothing_and_lock_nobody_out) {
    Merge merge(as_the_receiver());
    Desk desk{1};
    desk.universe = 1;
    Packet forged;
    forged.universe = 1;
    forged.priority = 200;
    forged.slot_count = 1;
    forged.slots[0] = 255;
    for (int i = 0; i < 10000; ++i) {
        const auto now = std::chrono::milliseconds(i);
        if (i % 23 == 0) merge.feed(desk.packet({i % 200}), now);
        for (std::size_t byte = 0; byte < 4; ++byte)
            forged.source.id[byte + 4] = static_cast<std::uint8_t>((i + 1) >> (8 * byte));
        merge.feed(forged, now);
        if (i % 100 == 0) merge.tick(now);
        ASSERT_EQ(merge.universes().level(1, 1), i / 23 * 23 % 200);
    }
    EXPECT_LE(merge.sources(10s).size(), kMaxSourcesPerUniverse);
    EXPECT_GT(merge.counters().too_many_sources, 8000u);
    // A second desk gets in and, after the wait, takes part.
    Desk second{2, 200};
    for (int i = 10000; i < 13000; ++i) {
        const auto now = std::chrono::milliseconds(i);
        if (i % 23 == 0) {
            merge.feed(desk.packet({7}), now);
            merge.feed(second.packet({77}), now);
        }
        forged.source.id[9] = static_cast<std::uint8_t>(i);
        forged.source.id[10] = static_cast<std::uint8_t>(i >> 8);
        merge.feed(forged, now);
        if (i % 100 == 0) merge.tick(now);
    }
    EXPECT_EQ(levels(merge, 1), Ints{77});
}

// What nobody asked for has limits of its own, which those that are patched do not feel.
TEST(Forged, sources_elsewhere_lock_nobody_out_of_a_patched_universe) {
    Merge merge(MergeOptions{.asked = {1, 9000}});
    Packet forged;
    forged.slot_count = 1;
    for (int i = 0; i < 10000; ++i) {
        forged.universe = static_cast<std::uint16_t>(2 + i % 2000);
        forged.source.id[0] = static_cast<std::uint8_t>(1 + i / 2000);
        forged.source.id[1] = static_cast<std::uint8_t>(1 + i % 7);
        merge.feed(forged, 0s);
    }
    EXPECT_EQ(merge.sources(0s).size(), kMaxOtherSources);
    for (const std::uint16_t universe : {std::uint16_t{1}, std::uint16_t{9000}})
        for (int id = 1; id <= 3; ++id) {
            Desk desk{static_cast<std::uint8_t>(id), 100, universe};
            merge.feed(desk.packet({40 + id}), 1ms);
            EXPECT_EQ(levels(merge, 1, universe), Ints{40 + id});
        }
    // One that nobody asked for finds at least a place of its own.
    Desk late{1, 100, 8000};
    merge.feed(late.packet({50}), 2ms);
    EXPECT_EQ(levels(merge, 1, 8000), Ints{50});
    // The place of a source is free when it left, or when nobody asks for its universe any more.
    merge.tick(3s);
    EXPECT_TRUE(merge.sources(3s).empty());
    merge.ask_for({});
    Desk back{1, 100, 1};
    merge.feed(back.packet({60}), 3s);
    EXPECT_EQ(levels(merge, 1, 1), Ints{60});
}

TEST(Forged, a_full_universe_has_a_place_where_one_is_silent) {
    Merge merge;
    Desk steady{99};
    for (int id = 1; id < static_cast<int>(kMaxSourcesPerUniverse); ++id) {
        Desk forged{static_cast<std::uint8_t>(id)};
        merge.feed(forged.packet({id}), 0s);
        merge.feed(forged.packet({id}), 1ms); // heard twice: no place to take
    }
    for (const auto t : {2300ms, 2400ms}) merge.feed(steady.packet({99}), t);
    Desk late{200};
    merge.feed(late.packet({200}), 2450ms);
    EXPECT_EQ(levels(merge, 1), Ints{99});
    merge.feed(late.packet({200}), 2550ms); // the others are past their time, and have not left yet
    EXPECT_EQ(levels(merge, 1), Ints{200});
    EXPECT_EQ(merge.sources(2550ms).size(), kMaxSourcesPerUniverse);
    EXPECT_EQ(merge.counters().sources_replaced, 1u);
}

// Sixteen places: for the highest priority, and of equal ones for those that are there.
TEST(Places, the_highest_priority_has_one) {
    Merge merge;
    std::vector<Desk> many;
    for (int id = 1; id <= 16; ++id) many.push_back({static_cast<std::uint8_t>(id), 1});
    Desk desk{200, 200}, equal{201, 1}, last{202, 150};
    const auto ids = [&](nanoseconds now) {
        std::set<int> result;
        for (const SourceStatus& source : merge.sources(now))
            result.insert(static_cast<int>(std::stoul(source.id.substr(0, 2), nullptr, 16)));
        return result;
    };
    for (int i = 0; i < 100; ++i) {
        const auto now = std::chrono::milliseconds(25 * i);
        for (Desk& one : many) merge.feed(one.packet({10}), now + std::chrono::microseconds(one.id));
        merge.feed(equal.packet({99}), now + 1ms);
        if (i >= 10) merge.feed(desk.packet({200}), now + 1ms);
        if (i >= 20) merge.feed(last.packet({255}), now + 1ms);
        if (i % 4 == 0) merge.tick(now + 2ms);
        const std::set<int> there = ids(now + 2ms);
        EXPECT_EQ(there.size(), kMaxSourcesPerUniverse);
        EXPECT_FALSE(there.contains(201)) << "of equal priority: who was there first stays";
        EXPECT_TRUE(there.contains(1)) << "the longest known of the lowest priority goes last";
        EXPECT_EQ(there.contains(200) && !there.contains(16), i >= 11) << i;
        EXPECT_EQ(there.contains(202) && !there.contains(15), i >= 21) << i;
        EXPECT_EQ(merge.universes().level(1, 1), i < 11 ? 10 : 200) << i;
    }
    EXPECT_EQ(merge.counters().sources_replaced, 2u);
}

TEST(Places, forged_sources_of_the_highest_priority_evict_nobody) {
    Merge merge(as_the_receiver());
    std::vector<Desk> many;
    for (int id = 1; id <= 16; ++id) many.push_back({static_cast<std::uint8_t>(id)});
    Packet forged;
    forged.priority = 200;
    forged.universe = 1;
    forged.slot_count = 1;
    for (int i = 0; i < 2000; ++i) {
        const auto now = std::chrono::milliseconds(i);
        if (i % 25 == 0)
            for (Desk& one : many) merge.feed(one.packet({7}), now);
        forged.source.id[9] = static_cast<std::uint8_t>(i);
        forged.source.id[10] = static_cast<std::uint8_t>(1 + (i >> 8));
        merge.feed(forged, now);
        if (i % 100 == 0) merge.tick(now);
    }
    EXPECT_EQ(merge.counters().sources_replaced, 0u);
    EXPECT_EQ(levels(merge, 1), Ints{7});
}

// Art-Net merges two. A place is free after the time-out, also where the other one was heard since the first
// fell silent and says nothing more.
TEST(Forged, two_artnet_addresses_hold_a_universe_no_longer_than_their_time_out) {
    Merge merge(as_the_receiver());
    merge.feed(art(66, 0, {1}), 0s);
    for (auto t = 0ms; t <= 12s; t += 25ms) {
        if (t == 9s) merge.feed(art(77, 0, {2}), t);
        if (t == 8s) merge.feed(art(77, 0, {2}), t);
        if (t > 8s) merge.feed(art(3, 0, {200}), t);
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{t <= 10s ? (t < 8s ? 1 : 2) : 200}) << t.count();
        EXPECT_EQ(merge.ignored(t).empty(), t <= 8s || t > 10s) << t.count();
    }
    EXPECT_EQ(merge.sources(12s).size(), kMaxArtnetSources);
    EXPECT_EQ(merge.counters().sources_replaced, 1u);
    EXPECT_GT(merge.counters().too_many_sources, 70u);
}

TEST(Forged, sources_on_all_universes_are_limited_together) {
    Merge merge;
    Packet forged;
    forged.slot_count = 1;
    for (int i = 0; i < 40000; ++i) {
        forged.universe = static_cast<std::uint16_t>(1 + i % 4000);
        forged.source.id[0] = static_cast<std::uint8_t>(i / 4000);
        merge.feed(forged, 0s);
    }
    EXPECT_EQ(merge.sources(0s).size(), kMaxOtherSources);
    merge.tick(3s);
    EXPECT_TRUE(merge.sources(3s).empty());
    merge.feed(forged, 3s); // and there is room again
    EXPECT_EQ(merge.sources(3s).size(), 1u);
}

} // namespace
} // namespace ghost::dmx
