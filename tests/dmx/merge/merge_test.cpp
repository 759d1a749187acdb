// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/merge.h"
#include "support/desk.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

TEST(Merge, one_source) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({20, 30}), 5s);
    EXPECT_EQ(levels(merge, 3), (Ints{20, 30, 0}));
    const Universe* universe = merge.universes().find(1);
    ASSERT_NE(universe, nullptr);
    EXPECT_EQ(universe->arrival, nanoseconds(5s));
    EXPECT_FALSE(universe->lost);
    EXPECT_EQ(merge.universes().find(2), nullptr);
    EXPECT_EQ(merge.universes().level(1, 0), 0);
    EXPECT_EQ(merge.universes().level(1, 513), 0);
}

TEST(Merge, equal_priority_is_highest_takes_precedence) {
    Merge merge;
    Desk a{1, 20}, b{2, 20};
    merge.feed(a.packet({1, 1, 100, 100}), 0s);
    merge.feed(b.packet({100, 100, 1, 1}), 0s);
    EXPECT_EQ(levels(merge, 4), (Ints{100, 100, 100, 100}));
    merge.feed(a.packet({1, 1, 100, 0}), 0s);
    merge.feed(b.packet({100, 0, 1, 1}), 0s);
    EXPECT_EQ(levels(merge, 4), (Ints{100, 1, 100, 1}));
}

TEST(Merge, higher_priority_wins_and_may_change) {
    Merge merge;
    Desk a{1, 20}, b{2, 10};
    merge.feed(a.packet({20}), 0s);
    merge.feed(b.packet({10}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{20});
    b.priority = 30;
    merge.feed(b.packet({10}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{10});
    b.priority = 10;
    merge.feed(b.packet({10}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{20});
}

TEST(Merge, one_source_may_lower_its_priority) {
    Merge merge;
    Desk a{1, 100};
    merge.feed(a.packet({5}), 0s);
    a.priority = 99;
    merge.feed(a.packet({99}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{99});
    a.priority = 0;
    merge.feed(a.packet({7}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{7});
}

TEST(Merge, a_short_source_does_not_hold_the_slots_it_does_not_send) {
    Merge merge;
    Desk full{1, 100}, remote{2, 150};
    merge.feed(full.packet({11, 12, 13, 14, 15, 16}), 0s);
    merge.feed(remote.packet({1, 2, 3, 4}), 0s);
    EXPECT_EQ(levels(merge, 6), (Ints{1, 2, 3, 4, 15, 16}));
}

TEST(Merge, slots_of_each_source_on_request) {
    Merge merge(MergeOptions{.slot_status = true});
    Desk a{1, 100}, b{2, 0};
    merge.feed(a.packet({10, 20, 30}), 1s);
    merge.feed(b.packet({99}), 1s);
    Packet priorities = a.packet({150, 0});
    priorities.start_code = 0xDD;
    merge.feed(priorities, 1s);
    const std::vector<SourceStatus> sources = merge.sources(1s);
    ASSERT_EQ(sources.size(), 2u);
    ASSERT_TRUE(sources[0].slots && sources[1].slots);
    EXPECT_EQ(sources[0].slots->levels[1], 20);
    EXPECT_EQ(sources[0].slots->rank[0], 151);
    EXPECT_EQ(sources[0].slots->rank[1], 0) << "not its own by its own word";
    EXPECT_EQ(sources[0].slots->rank[2], 0) << "fewer priorities than levels";
    EXPECT_EQ(sources[1].slots->rank[0], 1) << "a priority of 0 still holds the slot";
    EXPECT_EQ(sources[1].slots->rank[1], 0) << "not sent";
    Merge plain;
    plain.feed(a.packet({1}), 1s);
    EXPECT_EQ(plain.sources(1s)[0].slots, nullptr);
}

TEST(Merge, per_address_priority) {
    Merge merge;
    Desk a{1, 100}, b{2, 100};
    merge.feed(a.packet({10, 10, 10, 10}), 0s);
    merge.feed(b.packet({20, 20, 20, 20}), 0s);
    Packet priorities = b.packet({0, 99, 101}); // not ours, below, above; the fourth is missing: not ours
    priorities.start_code = 0xDD;
    merge.feed(priorities, 0s);
    EXPECT_EQ(levels(merge, 4), (Ints{10, 10, 20, 10}));
    merge.feed(a.packet({10, 10, 10, 10}), 2600ms);
    merge.feed(b.packet({20, 20, 20, 20}), 2600ms);
    merge.tick(2600ms); // priorities stopped: back to the packet's
    EXPECT_EQ(levels(merge, 4), (Ints{20, 20, 20, 20}));
}

TEST(Merge, priorities_alone_make_no_universe) {
    Merge merge;
    Desk a;
    Packet priorities = a.packet({100});
    priorities.start_code = 0xDD;
    merge.feed(priorities, 0s);
    EXPECT_TRUE(merge.universes().list.empty());
}

TEST(Merge, last_look_is_held_after_loss) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({20}), 0s);
    merge.tick(2500ms);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    merge.tick(2501ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(levels(merge, 1), Ints{20});
    EXPECT_EQ(merge.counters().sources_lost, 1u);
    merge.feed(a.packet({21}), 9s);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    EXPECT_EQ(levels(merge, 1), Ints{21});
}

TEST(Merge, loss_of_one_of_two_leaves_the_other) {
    Merge merge;
    Desk a{1, 150}, b{2, 100};
    merge.feed(a.packet({100}), 0s);
    for (auto t = 0ms; t <= 2600ms; t += 100ms) {
        merge.feed(b.packet({10}), t);
        merge.tick(t);
        EXPECT_EQ(levels(merge, 1), Ints{t <= 2500ms ? 100 : 10}) << t.count();
    }
    EXPECT_FALSE(merge.universes().find(1)->lost);
}

TEST(Merge, termination_is_immediate_and_its_slots_are_never_used) {
    Merge merge;
    Desk a, b{2, 100};
    merge.feed(a.packet({30}), 0s);
    Packet bye = a.packet({10});
    bye.terminated = true;
    merge.feed(bye, 0s);
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(levels(merge, 1), Ints{30});
    merge.feed(bye, 0s); // sent three times
    EXPECT_EQ(merge.counters().sources_terminated, 1u);
    merge.feed(a.packet({30}), 1s);
    merge.feed(b.packet({5}), 1s);
    bye = a.packet({200});
    bye.terminated = true;
    merge.feed(bye, 1s);
    EXPECT_FALSE(merge.universes().find(1)->lost); // one of two went
    EXPECT_EQ(levels(merge, 1), Ints{5});
}

TEST(Merge, late_and_repeated_packets_are_dropped) {
    Merge merge;
    Desk a;
    a.sequence = 99;
    merge.feed(a.packet({255}), 0s); // 100
    for (const int late : {100, 99, 90, 81}) {
        a.sequence = static_cast<std::uint8_t>(late - 1);
        merge.feed(a.packet({0}), 0s);
        EXPECT_EQ(levels(merge, 1), Ints{255}) << late;
    }
    EXPECT_EQ(merge.counters().out_of_sequence, 4u);
    a.sequence = 79; // 80 is 20 behind: the source started again
    merge.feed(a.packet({1}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{1});
}

TEST(Merge, sequence_wraps_to_0_or_1_without_loss) {
    for (const int after : {0, 1}) {
        Merge merge;
        Desk a;
        a.sequence = 253;
        merge.feed(a.packet({1}), 0s); // 254
        merge.feed(a.packet({2}), 0s); // 255
        a.sequence = static_cast<std::uint8_t>(after - 1);
        merge.feed(a.packet({3}), 0s);
        EXPECT_EQ(levels(merge, 1), Ints{3}) << after;
        EXPECT_EQ(merge.counters().missed, 0u);
        a.sequence = static_cast<std::uint8_t>(after + 3);
        merge.feed(a.packet({4}), 0s);
        EXPECT_EQ(merge.counters().missed, 3u);
    }
}

TEST(Merge, sequences_are_per_source_and_universe) {
    Merge merge;
    Desk a{1, 100, 1, 50}, b{2, 100, 1, 10}, c{1, 100, 2, 20};
    merge.feed(a.packet({1}), 0s);
    merge.feed(b.packet({2}), 0s);
    merge.feed(c.packet({3}), 0s);
    EXPECT_EQ(merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(levels(merge, 1), Ints{2});
    EXPECT_EQ(levels(merge, 1, 2), Ints{3});
}

TEST(Merge, a_dropped_packet_does_not_keep_a_source_alive) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({9}), 0s);
    a.sequence = 0;
    merge.feed(a.packet({9}), 2s); // the same number again
    merge.tick(2600ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
}

TEST(Merge, artnet_zero_sequence_is_not_numbered) {
    Merge merge;
    for (const int level : {1, 2, 3}) merge.feed(art(1, 0, {level}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{3});
    for (const int sequence : {254, 255, 0, 1, 2})
        merge.feed(art(1, static_cast<std::uint8_t>(sequence), {sequence}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{2});
    EXPECT_EQ(merge.counters().out_of_sequence, 0u);
    merge.feed(art(1, 1, {77}), 0s);
    EXPECT_EQ(levels(merge, 1), Ints{2});
}

TEST(Merge, artnet_lives_ten_seconds_and_merges_two) {
    Merge merge;
    merge.feed(art(1, 0, {10, 0}), 0s);
    merge.feed(art(2, 0, {0, 20}), 0s);
    merge.feed(art(3, 0, {99, 99}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{10, 20}));
    EXPECT_EQ(merge.counters().too_many_sources, 1u);
    merge.tick(10s);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    merge.tick(10s + 1ms);
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(levels(merge, 2), (Ints{10, 20}));
}

TEST(Merge, artnet_and_sacn_share_a_universe) {
    Merge merge;
    Desk a{1, 101};
    merge.feed(art(1, 0, {10, 200}), 0s);
    merge.feed(a.packet({50, 50}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{50, 50}));
    a.priority = 100;
    merge.feed(a.packet({50, 50}), 0s);
    EXPECT_EQ(levels(merge, 2), (Ints{50, 200}));
}

TEST(Merge, preview_is_left_out_unless_asked_for) {
    Merge merge, curious(MergeOptions{true});
    Desk a;
    Packet packet = a.packet({9});
    packet.source.preview = true;
    merge.feed(packet, 0s);
    curious.feed(packet, 0s);
    EXPECT_TRUE(merge.universes().list.empty());
    EXPECT_EQ(merge.counters().preview, 1u);
    EXPECT_EQ(levels(curious, 1), Ints{9});
}

// A desk in blind numbers live and preview packets in one row.
TEST(Merge, preview_in_one_row_of_numbers_is_no_loss) {
    for (const bool shown : {false, true}) {
        MergeOptions options;
        options.show_preview = shown;
        Merge merge(options);
        Desk desk{1};
        for (int i = 0; i < 1000; ++i) {
            Packet packet = desk.packet({i & 255});
            packet.source.preview = i % 3 == 1;
            if (i % 3 == 2) {
                merge.pass({packet.source, 1, packet.sequence}); // a start code that we do not use
                continue;
            }
            if (i == 300 || i == 601) continue; // lost: one live, one preview
            merge.feed(packet, std::chrono::milliseconds(10 * i));
        }
        EXPECT_EQ(merge.counters().out_of_sequence, 0u);
        EXPECT_EQ(merge.counters().missed, 2u) << "and each is told once";
    }
}

// There are programs with a row for each.
TEST(Merge, preview_with_a_row_of_its_own_drops_nothing) {
    Merge merge;
    Desk live{1}, preview{1};
    preview.sequence = 3;
    for (int i = 0; i < 500; ++i) {
        Packet blind = preview.packet({1});
        blind.source.preview = true;
        merge.feed(blind, std::chrono::milliseconds(20 * i));
        merge.feed(live.packet({i & 255}), std::chrono::milliseconds(20 * i));
        EXPECT_EQ(merge.universes().level(1, 1), i & 255);
    }
    EXPECT_EQ(merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(merge.counters().missed, 0u);
}

TEST(Merge, preview_by_universe) {
    Merge merge(MergeOptions{.show_preview = true, .preview_universes = {2, 5}});
    Desk a;
    for (const std::uint16_t universe : std::initializer_list<std::uint16_t>{1, 2}) {
        a.universe = universe;
        Packet packet = a.packet({9});
        packet.source.preview = true;
        packet.source_name = "Eos";
        merge.feed(packet, 1s);
        merge.feed(packet, 2s);
    }
    EXPECT_EQ(merge.universes().find(1), nullptr);
    EXPECT_EQ(levels(merge, 1, 2), Ints{9});
    const auto ignored = merge.ignored(3s);
    ASSERT_EQ(ignored.size(), 1u);
    EXPECT_EQ(ignored[0].universe, 1);
    EXPECT_EQ(ignored[0].why, IgnoredSource::Why::preview);
    EXPECT_EQ(ignored[0].name, "Eos");
    EXPECT_EQ(ignored[0].packets, 2u);
    EXPECT_EQ(ignored[0].age, nanoseconds(1s));
    merge.tick(12s + 1ms);
    EXPECT_TRUE(merge.ignored(13s).empty());
}

TEST(Merge, ignored_sources_are_told_of_to_a_limit) {
    Merge merge;
    for (int id = 0; id < 200; ++id) {
        Packet packet = Desk{static_cast<std::uint8_t>(id)}.packet({1});
        packet.source.preview = true;
        merge.feed(packet, 1s);
    }
    EXPECT_EQ(merge.ignored(1s).size(), kMaxIgnored);
    EXPECT_EQ(merge.counters().preview, 200u);
}

TEST(Merge, forgets_universes_that_are_not_kept) {
    Merge merge;
    Desk a{1, 100, 1}, b{1, 100, 2};
    merge.feed(a.packet({10}), 1s);
    merge.feed(b.synchronised(7, {20}), 1s);
    merge.feed(b.sync(7), 1s);
    merge.feed(b.synchronised(7, {30}), 1s); // waits
    EXPECT_EQ(merge.universes().list.size(), 2u);
    const std::uint64_t before = merge.universes().revision;
    merge.feed(b.packet({1}), 1s); // due, when it is forgotten
    merge.keep_only({1, 3});
    EXPECT_FALSE(merge.pending());
    ASSERT_EQ(merge.universes().list.size(), 1u);
    EXPECT_GT(merge.universes().revision, before);
    EXPECT_EQ(merge.sources(1s).size(), 1u);
    merge.feed(b.sync(7), 1s); // of what waited there
    merge.feed(a.packet({11}), 1s);
    EXPECT_EQ(levels(merge, 1), Ints{11});
    merge.tick(10s);
    EXPECT_EQ(merge.counters().sources_lost, 1u);
    EXPECT_EQ(merge.lost(11s).size(), 1u);
    merge.feed(b.packet({40}), 10s); // patched again
    EXPECT_EQ(levels(merge, 1, 2), Ints{40});
}

TEST(Merge, revision_grows_with_the_levels_only) {
    Merge merge;
    Desk a, b{2, 100, 2};
    merge.feed(a.packet({1}), 1s);
    merge.feed(b.packet({1}), 1s);
    const Universes first = merge.universes();
    merge.feed(a.packet({1}), 2s);
    EXPECT_TRUE(merge.pending());
    const Universes second = merge.universes();
    EXPECT_FALSE(merge.pending());
    EXPECT_EQ(second.revision, first.revision);
    EXPECT_EQ(second.find(1)->levels, first.find(1)->levels); // shared
    EXPECT_EQ(second.find(1)->arrival, nanoseconds(2s));
    merge.feed(a.packet({2}), 3s);
    const Universes third = merge.universes();
    EXPECT_GT(third.revision, second.revision);
    EXPECT_GT(third.find(1)->revision, second.find(1)->revision);
    EXPECT_EQ(third.find(2)->revision, second.find(2)->revision);
    EXPECT_EQ(second.level(1, 1), 1); // a copy stays what it was
}

TEST(Merge, a_first_look_of_all_zero_counts_as_a_look) {
    Merge merge;
    Desk a;
    merge.feed(a.packet({0}), 0s);
    ASSERT_NE(merge.universes().find(1), nullptr);
    EXPECT_GT(merge.universes().find(1)->revision, 0u);
}

// Sixteen of priority 1 at 20 Hz; the seventeenth rests, as a desk does between two looks.
TEST(Merge, who_has_the_higher_priority_keeps_its_place_while_it_rests) {
    for (const bool per_address : {false, true}) {
        Merge merge;
        std::vector<Desk> dark;
        for (int i = 0; i < 16; ++i) dark.push_back(Desk{static_cast<std::uint8_t>(2 + i), 1});
        Desk main{1, static_cast<std::uint8_t>(per_address ? 1 : 200)};
        int shown = 0;
        for (int i = 0; i < 200; ++i) {
            const nanoseconds now = i * 50ms;
            for (Desk& desk : dark) merge.feed(desk.packet({0}), now);
            if (i % 16 == 8) {
                if (per_address) merge.feed(main.priorities({200}), now);
                merge.feed(main.packet({255}), now);
            }
            merge.tick(now);
            if (i >= 60) shown += levels(merge, 1) == Ints{255} ? 1 : 0;
        }
        EXPECT_EQ(shown, 140) << per_address;
    }
}

TEST(Merge, sources_are_limited) {
    Merge merge;
    for (int i = 0; i < 20; ++i) {
        Desk desk{static_cast<std::uint8_t>(i)};
        merge.feed(desk.packet({i}), 0s);
    }
    EXPECT_EQ(merge.sources(0s).size(), kMaxSourcesPerUniverse);
    EXPECT_EQ(merge.counters().too_many_sources, 20 - kMaxSourcesPerUniverse);
    EXPECT_EQ(levels(merge, 1), Ints{15});
}

TEST(Merge, universes_are_limited) {
    Merge merge;
    for (std::size_t i = 1; i <= kMaxUniverses + 10; ++i) {
        Desk desk{1, 100, static_cast<std::uint16_t>(i)};
        merge.feed(desk.packet({1}), 0s);
    }
    EXPECT_EQ(merge.universes().list.size(), kMaxUniverses);
    EXPECT_EQ(merge.counters().too_many_universes, 10u);
}

// Of a storm of universes: those that are patched get in whatever came before, others when one falls silent.
TEST(Merge, universes_that_were_asked_for_always_find_a_place) {
    Merge merge(MergeOptions{.asked = {60000, 60001}});
    const auto send = [&](int universe, std::chrono::nanoseconds now) {
        Desk desk{1, 100, static_cast<std::uint16_t>(universe)};
        merge.feed(desk.packet({universe % 200 + 1}), now);
    };
    const auto shows = [&](int universe) {
        const auto number = static_cast<std::uint16_t>(universe);
        return merge.universes().level(number, 1) == universe % 200 + 1;
    };
    for (int i = 1; i <= 5000; ++i) send(i, std::chrono::microseconds(i));
    EXPECT_EQ(merge.universes().list.size(), kMaxUniverses);
    EXPECT_FALSE(shows(5000));
    EXPECT_EQ(merge.counters().too_many_universes, 5000 - kMaxUniverses);
    send(60001, 10ms);
    send(60000, 10ms);
    EXPECT_TRUE(shows(60000) && shows(60001));
    EXPECT_EQ(merge.universes().list.size(), kMaxUniverses);
    EXPECT_FALSE(shows(1) || shows(2)) << "the longest silent made room";
    EXPECT_EQ(merge.counters().universes_forgotten, 2u);
    // A real desk on one of the first and on one that found no place; the others were sent once.
    for (auto t = 100ms; t <= 3s; t += 50ms) {
        Desk real{7, 100, 100, static_cast<std::uint8_t>(t / 50ms)};
        merge.feed(real.packet({99}), t);
        real.universe = 5000;
        merge.feed(real.packet({99}), t);
        merge.tick(t);
        EXPECT_LE(merge.universes().list.size(), kMaxUniverses);
    }
    EXPECT_EQ(levels(merge, 1, 100), Ints{99});
    EXPECT_EQ(levels(merge, 1, 5000), Ints{99}) << "there is room as soon as others are silent";
    EXPECT_TRUE(shows(60000)) << "lost, and held";
    EXPECT_GE(merge.counters().universes_forgotten, 3u);
    const auto forgotten = merge.counters().universes_forgotten;
    for (auto t = 4s; t <= 10s; t += 1s) merge.tick(t);
    EXPECT_EQ(merge.counters().universes_forgotten, forgotten) << "nobody else wants in";
}

TEST(Merge, status_of_a_source) {
    Merge merge;
    Desk a{0xAB, 120, 7};
    for (int i = 0; i <= 44; ++i) {
        Packet packet = a.packet({1, 2, 3});
        packet.source_name = "Desk";
        packet.from = 0x0A000001;
        merge.feed(packet, std::chrono::milliseconds(i * 1000 / 44));
    }
    merge.tick(1s);
    const auto sources = merge.sources(1500ms);
    ASSERT_EQ(sources.size(), 1u);
    EXPECT_EQ(sources[0].universe, 7);
    EXPECT_EQ(sources[0].id, "ab000000000000000000000000000000");
    EXPECT_EQ(sources[0].name, "Desk");
    EXPECT_EQ(sources[0].priority, 120);
    EXPECT_EQ(sources[0].slot_count, 3);
    EXPECT_EQ(sources[0].packets, 45u);
    EXPECT_NEAR(sources[0].rate_hz, 45.0, 0.01);
    EXPECT_EQ(sources[0].age, nanoseconds(500ms));

    EXPECT_EQ(sources[0].slots_held, 3u);
    EXPECT_LT(sources[0].jitter_ms, 1.0);

    Merge nodes;
    Packet packet = art(10, 0, {1});
    packet.source.id[3] = 2;
    packet.source.id[4] = 1;
    nodes.feed(packet, 0s);
    EXPECT_EQ(nodes.sources(0s).at(0).id, "10.0.0.2/1");
}

TEST(Merge, jitter_is_the_mean_way_from_an_even_beat) {
    Merge merge;
    Desk a;
    for (int i = 0; i < 400; ++i) // every 25 ms, each other one 5 ms late
        merge.feed(a.packet({1}), std::chrono::milliseconds(25 * i + (i % 2) * 5));
    EXPECT_NEAR(merge.sources(10s).at(0).jitter_ms, 5.0, 0.5);
}

TEST(Merge, slots_where_another_of_equal_rank_has_its_way) {
    Merge merge;
    Desk a{1}, b{2}, low{3, 50};
    merge.feed(a.packet({10, 200, 5, 7}), 0s);
    merge.feed(b.packet({20, 100, 5}), 0s);
    merge.feed(low.packet({99, 99, 99, 99}), 0s);
    (void)merge.universes();
    const std::vector<SourceStatus> sources = merge.sources(0s);
    EXPECT_EQ(sources[0].slots_overruled, 1u);
    EXPECT_EQ(sources[1].slots_overruled, 1u);
    EXPECT_EQ(sources[2].slots_overruled, 0u);
    EXPECT_EQ(sources[0].slots_contested, 1u) << "it sends 10 where 20 shows";
    merge.feed(a.packet({0, 200, 5}), 0s);
    EXPECT_EQ(merge.sources(0s)[0].slots_overruled, 0u) << "it moves";
    for (const nanoseconds now : {1s, 2s}) {
        merge.feed(a.packet({0, 200, 5}), now);
        merge.feed(b.packet({20, 100, 5}), now);
        merge.tick(now);
    }
    EXPECT_EQ(merge.sources(2s)[0].slots_overruled, 1u);
    EXPECT_EQ(merge.sources(2s)[0].slots_contested, 0u) << "it leaves the channel to the other";
}

TEST(Merge, slots_where_another_has_its_way_are_counted_while_looks_wait_to_be_shown) {
    Merge merge;
    Desk a{1}, b{2};
    merge.feed(a.packet({10, 200}), 0s);
    merge.feed(b.packet({10, 200}), 0s);
    (void)merge.universes();
    EXPECT_EQ(merge.sources(0s)[0].slots_overruled, 0u);
    for (const nanoseconds now : {1s, 2s}) {
        merge.feed(a.packet({10, 200}), now);
        merge.feed(b.packet({30, 200}), now);
        merge.tick(now);
    }
    merge.feed(b.packet({30, 200}), 2s);
    EXPECT_EQ(merge.sources(2s)[0].slots_overruled, 1u);
    EXPECT_EQ(merge.sources(2s)[1].slots_overruled, 0u);
}

TEST(Merge, a_desk_that_follows_another_is_in_no_fight_with_it) {
    Merge merge;
    Desk main{1}, tracks{2};
    std::size_t differs = 0;
    for (int i = 0; i < 160; ++i) {
        const nanoseconds now = i * 25ms;
        merge.feed(main.packet({i % 200 + 1, 255}), now);
        const auto between = merge.sources(now + 2ms);
        differs += between.size() > 1 ? between[0].slots_overruled + between[1].slots_overruled : 0;
        merge.feed(tracks.packet({i % 200 + 1, 255}), now + 4ms);
        merge.tick(now + 5ms);
    }
    EXPECT_EQ(differs, 0u);
}

TEST(Merge, slots_that_a_source_holds) {
    Merge merge;
    Desk main{1, 100}, backup{2, 90}, equal{3, 100};
    merge.feed(main.packet({1, 1}), 0s);
    merge.feed(backup.packet({1, 1, 1, 1}), 0s);
    const auto held = [&] {
        Ints result;
        for (const SourceStatus& source : merge.sources(0s))
            result.push_back(static_cast<int>(source.slots_held));
        return result;
    };
    EXPECT_EQ(held(), (Ints{2, 2}));
    merge.feed(equal.packet({0, 0, 0, 0}), 0s);
    EXPECT_EQ(held(), (Ints{2, 0, 4}));
    merge.feed(equal.priorities({100, 0, 0, 0}), 0s);
    EXPECT_EQ(held(), (Ints{2, 2, 1}));
}

} // namespace
} // namespace ghost::dmx
