// SPDX-License-Identifier: Apache-2.0
// Sequence numbers that do not count up, and senders that share an identity.
#include "dmx/merge/merge.h"
#include "net/socket.h"
#include "support/desk.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

std::uint8_t flash(int i) {
    return static_cast<std::uint8_t>(i % 2 * 255);
}

TEST(Merge, numbers_that_stand_still_and_that_jump) {
    Merge merge;
    Desk standing{1}, one{2}, other{2}, twice{3};
    other.sequence = static_cast<std::uint8_t>(one.sequence + 120);
    std::uint8_t number = 0;
    for (int i = 0; i < 88; ++i) {
        const nanoseconds now = i * 25ms;
        Packet packet = standing.packet({1});
        if (i == 0) number = packet.sequence;
        packet.sequence = number;
        merge.feed(packet, now);
        merge.feed(one.packet({2}), now);
        merge.feed(other.packet({3}), now);
        packet = twice.packet({4});
        merge.feed(packet, now);
        merge.feed(packet, now);
        merge.tick(now);
    }
    const std::vector<SourceStatus> sources = merge.sources(88 * 25ms);
    ASSERT_EQ(sources.size(), 3u);
    EXPECT_NEAR(sources[0].late_hz, 40.0, 1.0);
    EXPECT_LT(sources[0].rate_hz, 1.0);
    EXPECT_FALSE(sources[0].is_shared);
    EXPECT_TRUE(sources[1].is_shared);
    EXPECT_FALSE(sources[2].is_shared);
    EXPECT_NEAR(sources[2].late_hz, 40.0, 1.0);
    EXPECT_NEAR(sources[2].rate_hz, 40.0, 1.0);
}

TEST(Merge, one_row_of_numbers_for_several_universes_is_no_loss) {
    Merge merge;
    Desk shared{1}, losing{2}, swapping{3}, random{4};
    for (int i = 0; i < 240; ++i) {
        const nanoseconds now = i * 25ms;
        ++shared.sequence; // that of another universe
        merge.feed(shared.packet({1}), now);
        const Packet packet = losing.packet({2});
        if (i >= 120 || i % 10 != 9) merge.feed(packet, now);
        if (i % 2 == 1) {
            const Packet first = swapping.packet({3}), second = swapping.packet({3});
            merge.feed(second, now);
            merge.feed(first, now);
        }
        random.sequence = static_cast<std::uint8_t>(i * 7919 % 251);
        merge.feed(random.packet({4}), now);
        merge.tick(now);
    }
    const std::vector<SourceStatus> sources = merge.sources(6s);
    ASSERT_EQ(sources.size(), 4u);
    EXPECT_TRUE(sources[0].has_gaps);
    EXPECT_FALSE(sources[1].has_gaps);
    EXPECT_TRUE(sources[2].has_gaps);
    EXPECT_TRUE(sources[3].is_reordered) << "they come two by two";
    EXPECT_FALSE(sources[3].has_gaps);
    EXPECT_FALSE(sources[3].is_shared) << "its look does not jump with its numbers";
    EXPECT_GE(merge.counters().lost, 8u);
    EXPECT_LE(merge.counters().lost, 12u) << "of the one that loses a tenth";
}

// Two exchanged on the way, wherever the second that is counted begins; and a late one of every five.
TEST(Merge, packets_that_come_late_are_not_lost) {
    for (const auto interval : {25ms, 23ms, 7ms})
        for (const int every : {40, 33, 5}) {
            Merge merge;
            Desk desk{1};
            std::vector<Packet> waiting;
            for (int i = 0; i < 2000; ++i) {
                const nanoseconds now = i * interval;
                const Packet packet = desk.packet({1});
                if (i % every == 0)
                    waiting.push_back(packet);
                else
                    merge.feed(packet, now);
                if (i % every == (every > 5 ? 1 : 2) && !waiting.empty()) {
                    merge.feed(waiting.back(), now);
                    waiting.clear();
                }
                merge.tick(now);
            }
            EXPECT_EQ(merge.counters().lost, 0u) << every << " " << interval.count();
        }
}

// All arrive: each late by up to 90 ms, or a third of them two places, or two by two.
TEST(Merge, packets_of_two_paths_come_in_another_order_and_are_not_lost) {
    enum class Way { random, third, pairs };
    for (const Way way : {Way::random, Way::third, Way::pairs}) {
        Merge merge;
        Desk desk{1};
        std::multimap<nanoseconds, Packet> arrivals;
        std::minstd_rand random;
        for (int i = 0; i < 1200; ++i) {
            const nanoseconds late = way == Way::random  ? static_cast<int>(random() % 91) * 1ms
                                     : way == Way::third ? (i % 3 == 0 ? 60ms : 0ms)
                                                         : (i % 2 == 0 ? 30ms : 0ms);
            arrivals.emplace(i * 25ms + late, desk.packet({1}));
        }
        for (const auto& [now, packet] : arrivals) {
            merge.feed(packet, now);
            merge.tick(now);
        }
        const SourceStatus source = merge.sources(30s).at(0);
        EXPECT_EQ(merge.counters().lost, 0u) << static_cast<int>(way);
        EXPECT_GT(source.missed, 200u);
        EXPECT_TRUE(source.is_reordered) << static_cast<int>(way);
        EXPECT_FALSE(source.has_gaps);
        for (int i = 1; i <= 4; ++i) {
            merge.feed(desk.packet({1}), 30s + i * 1s);
            merge.tick(30s + i * 1s);
        }
        EXPECT_FALSE(merge.sources(34s).at(0).is_reordered) << "it rests, and nothing is late";
    }
}

TEST(Merge, one_row_of_numbers_of_which_few_are_another_universe_s_is_no_loss) {
    // Universe 1 forty times a second, others by turns or now and then, merged or not; one of its own packets
    // is lost twice a second.
    for (const int every : {6, 44})
        for (const bool is_merged : {true, false})
            for (const bool loses : {false, true}) {
                Merge merge;
                Desk desk{1};
                int lost = 0;
                for (int i = 0; i < 400; ++i) {
                    const nanoseconds now = i * 25ms;
                    const Packet packet = desk.packet({1});
                    if (loses && i < 300 && i % 20 == 13)
                        ++lost;
                    else
                        merge.feed(packet, now);
                    if (i % every == 0) {
                        Packet other = desk.packet({0});
                        other.universe = static_cast<std::uint16_t>(2 + i / every % 3);
                        is_merged ? merge.feed(other, now + 1ms) : merge.pass_elsewhere(other.source);
                    }
                    merge.tick(now);
                }
                EXPECT_NEAR(static_cast<double>(merge.counters().lost), lost, loses ? 3 : 0)
                    << every << is_merged;
            }
}

TEST(Merge, numbers_that_others_have_who_do_not_come_here_leave_no_pause) {
    // A desk counts all its universes in one row, of which we hear one; its packets come a bit early and
    // late, and of its own some are lost or not.
    for (const int every : {6, 44})
        for (const nanoseconds early : {0ms, 4ms})
            for (const bool loses : {false, true}) {
                Merge merge;
                Desk desk{1};
                int lost = 0;
                for (int i = 0; i < 400; ++i) {
                    const nanoseconds now = i * 25ms - i * 7919 % 3 * early / 2;
                    const Packet packet = desk.packet({1});
                    if (loses && i < 300 && i % 20 == 13)
                        ++lost;
                    else
                        merge.feed(packet, now);
                    if (i % every == 0) ++desk.sequence;
                    merge.tick(now);
                }
                EXPECT_NEAR(static_cast<double>(merge.counters().lost), lost, loses ? 6 : 0)
                    << every << (early > 0ms);
            }
}

TEST(Merge, what_gets_lost_of_a_sender_that_comes_in_bunches_is_told) {
    // As by Wi-Fi: four packets at once, a tenth of them lost.
    Merge merge;
    Desk desk{1};
    int lost = 0;
    for (int i = 0; i < 800; ++i) {
        const nanoseconds now = i / 4 * 100ms + i % 4 * 1ms;
        const Packet packet = desk.packet({1});
        if (i < 700 && i * 7919 % 10 == 3)
            ++lost;
        else
            merge.feed(packet, now);
        merge.tick(now);
    }
    EXPECT_NEAR(static_cast<double>(merge.counters().lost), lost, 8);
}

TEST(Merge, what_is_lost_beside_other_universes_of_the_sender_is_told) {
    // Each universe counts for itself, and a tenth of what is sent for one of them does not come.
    for (const int every : {1, 6, 44}) {
        Merge merge;
        Desk losing{1}, other{1, 100, 2};
        for (int i = 0; i < 480; ++i) {
            const nanoseconds now = i * 25ms;
            const Packet packet = losing.packet({1});
            if (i >= 360 || i % 10 != 9) merge.feed(packet, now);
            if (i % every == 0) merge.feed(other.packet({2}), now + 1ms);
            merge.tick(now);
        }
        EXPECT_NEAR(static_cast<double>(merge.counters().lost), 36, 5) << every;
    }
}

TEST(Merge, who_sends_other_packets_under_the_same_identity) {
    // A desk that fades, and what comes by another address: its packets so many later, numbered alike or in
    // a row of their own.
    const auto double_of = [](int late, bool other_levels, bool own_row) {
        Merge merge;
        Desk desk{1};
        std::vector<Packet> sent;
        for (int i = 0; i < 120; ++i) {
            sent.push_back(desk.packet({i}));
            sent.back().from = IpAddress(0x0A000001);
            merge.feed(sent.back(), i * 25ms);
            if (i < late) continue;
            Packet packet = sent[static_cast<std::size_t>(i - late)];
            packet.from = IpAddress(0x0A000002);
            if (other_levels) packet.slots[0] = 200;
            if (own_row) packet.sequence = static_cast<std::uint8_t>(packet.sequence + 100);
            merge.feed(packet, i * 25ms + 1ms);
        }
        return merge.sources(3s).at(0).double_from;
    };
    for (const int late : {0, 2, 7, 25}) {
        EXPECT_FALSE(double_of(late, false, false))
            << "two network cards of a desk, one is slower by " << late;
        EXPECT_EQ(double_of(late, true, false), IpAddress(0x0A000002))
            << "numbered alike by chance, " << late;
    }
    for (const int late : {0, 1, 3, 25}) {
        EXPECT_FALSE(double_of(late, false, true)) << "each card has numbers of its own, " << late;
        EXPECT_EQ(double_of(late, true, true), IpAddress(0x0A000002));
    }
    // A way that is slower by a second and a half, and a light that goes out meanwhile.
    for (const bool is_slow : {true, false}) {
        Merge merge;
        Desk desk{1};
        std::vector<Packet> sent;
        for (int i = 0; i < 240; ++i) {
            sent.push_back(desk.packet({i < 80 ? 255 : 0}));
            sent.back().from = IpAddress(0x0A000001);
            merge.feed(sent.back(), i * 25ms);
            if (i < 60) continue;
            Packet packet = sent[static_cast<std::size_t>(i - 60)];
            packet.from = IpAddress(0x0A000002);
            if (!is_slow) packet.slots[0] = 99;
            merge.feed(packet, i * 25ms + 1ms);
        }
        EXPECT_EQ(merge.sources(6s).at(0).double_from.has_value(), !is_slow);
    }
    // Of three ways, one by IPv6, each with its own numbers, none is another desk; a fourth one is.
    for (const bool is_cloned : {false, true}) {
        Merge merge;
        Desk rows[4] = {{1}, {1}, {1}, {1}};
        for (int i = 0; i < 400; ++i)
            for (int way = 0; way < (is_cloned ? 4 : 3); ++way) {
                rows[way].sequence = static_cast<std::uint8_t>(i + 50 * way);
                Packet packet = rows[way].packet({way == 3 ? 70 : flash(i / 3)});
                packet.from = IpAddress(0x0A000001 + static_cast<std::uint32_t>(way));
                if (way == 2) packet.from = must(parse_address("fe80::1"));
                merge.feed(packet, i * 25ms + way * 1ms);
            }
        EXPECT_EQ(merge.sources(10s).at(0).double_from.has_value(), is_cloned);
    }
    // Who sent once and went does not hide who came after.
    Merge later;
    Desk own{1}, gone{1}, clone{1};
    for (int i = 0; i < 400; ++i) {
        Packet packet = own.packet({10});
        packet.from = IpAddress(0x0A000001);
        later.feed(packet, i * 25ms);
        packet = i == 10 ? gone.packet({10}) : clone.packet({99});
        packet.from = IpAddress(i == 10 ? 0x0A000002 : 0x0A000003);
        if (i >= 10) later.feed(packet, i * 25ms + 1ms);
    }
    EXPECT_EQ(later.sources(10s).at(0).double_from, IpAddress(0x0A000003));
    // The other way may be the quicker one.
    Merge ahead;
    Desk quick{1}, slow{1};
    for (int i = 0; i < 120; ++i) {
        Packet packet = slow.packet({10});
        packet.from = IpAddress(0x0A000001);
        ahead.feed(packet, i * 25ms);
        packet = quick.packet({99});
        packet.sequence = static_cast<std::uint8_t>(packet.sequence + 3);
        packet.from = IpAddress(0x0A000002);
        ahead.feed(packet, i * 25ms + 1ms);
    }
    EXPECT_EQ(ahead.sources(3s).at(0).double_from, IpAddress(0x0A000002));
    Merge merge;
    Desk before{1}, after{1}; // it gets another address, and counts anew
    after.sequence = static_cast<std::uint8_t>(before.sequence + 100);
    for (int i = 0; i < 80; ++i) {
        Packet packet = (i < 20 ? before : after).packet({10});
        packet.from = IpAddress(i < 20 ? 0x0A000001 : 0x0A000002);
        merge.feed(packet, i * 25ms);
        EXPECT_FALSE(merge.sources(i * 25ms).at(0).double_from) << i;
    }
}

Packet unnumbered(std::uint8_t level, std::uint16_t port) {
    Packet packet;
    packet.protocol = Protocol::artnet;
    packet.source.protocol = Protocol::artnet;
    packet.source.id = {10, 0, 0, 7};
    packet.universe = 1;
    packet.slot_count = kSlots;
    packet.slots[0] = level;
    packet.from_port = port;
    return packet;
}

SourceStatus after_two_seconds(const std::function<void(Merge&, int, nanoseconds)>& feed) {
    Merge merge;
    for (int i = 0; i < 88; ++i) {
        feed(merge, i, i * 25ms);
        merge.tick(i * 25ms);
    }
    return merge.sources(88 * 25ms).at(0);
}

TEST(Merge, a_desk_that_begins_anew_lost_nothing) {
    Merge merge;
    Desk desk{1};
    std::uint64_t lost_before = 0;
    for (int i = 0; i < 400; ++i) {
        const nanoseconds now = i * 25ms;
        if (i == 100) desk.sequence = static_cast<std::uint8_t>(desk.sequence + 120); // and at once
        const Packet packet = desk.packet({1});
        const bool pulled = i >= 200 && i < 240; // a second
        if (!pulled) merge.feed(packet, now);
        merge.tick(now);
        if (i == 199) lost_before = merge.counters().lost;
    }
    EXPECT_EQ(lost_before, 0u) << "of the first five seconds";
    EXPECT_EQ(merge.counters().lost, 40u);
}

TEST(Merge, a_desk_that_is_back_after_a_second_by_another_port_lost_nothing) {
    for (const bool is_new : {true, false}) {
        Merge merge;
        Desk desk{1};
        for (int i = 0; i < 400; ++i) {
            Packet packet = desk.packet({1});
            packet.from_port = is_new && i >= 240 ? 50001 : 50000;
            if (i < 200 || i >= 240) merge.feed(packet, i * 25ms);
            merge.tick(i * 25ms);
        }
        EXPECT_EQ(merge.counters().lost, is_new ? 0u : 40u);
    }
}

Packet with_level(Packet packet, std::uint8_t level) {
    packet.slots[0] = level;
    return packet;
}

TEST(Merge, two_programs_without_numbers_are_told_by_their_ports) {
    for (const bool lower_moves : {false, true}) {
        const SourceStatus two = after_two_seconds([&](Merge& merge, int i, nanoseconds now) {
            const auto moving = static_cast<std::uint8_t>(100 + i);
            merge.feed(unnumbered(lower_moves ? moving : 10, 6454), now);
            merge.feed(unnumbered(lower_moves ? 10 : moving, 40021), now);
        });
        EXPECT_TRUE(two.is_shared) << lower_moves;
        EXPECT_EQ(two.port, 6454);
        EXPECT_EQ(two.other_port, 40021);
    }
    EXPECT_TRUE(after_two_seconds([](Merge& merge, int i, nanoseconds now) {
                    Packet numbered = unnumbered(10, 6454);
                    numbered.sequence = static_cast<std::uint8_t>(i % 255 + 1);
                    merge.feed(numbered, now);
                    merge.feed(unnumbered(99, 6454), now);
                }).is_shared)
        << "one numbered and one not, by one port";
    EXPECT_FALSE(after_two_seconds([&](Merge& merge, int i, nanoseconds now) {
                     merge.feed(unnumbered(flash(i), 40021), now);
                 }).is_shared)
        << "one that flashes";
    EXPECT_FALSE(after_two_seconds([&](Merge& merge, int i, nanoseconds now) {
                     merge.feed(unnumbered(flash(i / 2), static_cast<std::uint16_t>(1025 + i * 7919 % 64000)),
                                now);
                 }).is_shared)
        << "one that flashes and takes a new port for each packet";
    EXPECT_FALSE(after_two_seconds([](Merge& merge, int, nanoseconds now) {
                     merge.feed(unnumbered(10, 6454), now);
                     merge.feed(unnumbered(10, 40021), now);
                 }).is_shared)
        << "the same look by both";
    EXPECT_FALSE(after_two_seconds([](Merge& merge, int i, nanoseconds now) {
                     merge.feed(unnumbered(flash(i / 2), static_cast<std::uint16_t>(6454 + i % 2 * 100)),
                                now);
                 }).is_shared)
        << "two sockets by turns, and a strobe";
    EXPECT_FALSE(after_two_seconds([](Merge& merge, int i, nanoseconds now) {
                     merge.feed(unnumbered(static_cast<std::uint8_t>(i), 6454), now);
                     if (i > 3) merge.feed(unnumbered(static_cast<std::uint8_t>(i - 3), 40021), now);
                 }).is_shared)
        << "two sockets, a fade, and one of them is late";
}

// How far the numbers of the second are ahead, and every how many packets of the first it sends one.
TEST(Merge, a_program_that_was_started_twice_is_told_whatever_its_numbers) {
    for (const int every : {1, 4, 20})
        for (const int ahead : {0, 1, 2, 5, 19, 20, 64, 127, 128, 129, 192, 236, 237, 250, 254, 255})
            for (const bool moves : {false, true}) {
                Merge merge;
                Desk one{1}, other{1};
                other.sequence = static_cast<std::uint8_t>(one.sequence + ahead);
                for (int i = 0; i < 320; ++i) {
                    const nanoseconds now = i * 25ms;
                    merge.feed(
                        with_level(one.packet({2}), static_cast<std::uint8_t>(moves ? 100 + i % 100 : 9)),
                        now);
                    if (i % every == 0) merge.feed(with_level(other.packet({3}), 70), now + 3ms);
                    merge.tick(now + 5ms);
                }
                const std::string what = std::to_string(ahead) + " ahead, every " + std::to_string(every) +
                                         (moves ? ", moving" : "");
                EXPECT_TRUE(merge.sources(8s).at(0).is_shared) << what;
                EXPECT_EQ(merge.counters().lost, 0u) << what;
            }
}

TEST(Merge, one_sender_on_a_bad_network_is_one_whatever_it_shows) {
    // Every third packet comes twice, every fifth one after its successor, every eleventh never.
    const auto shared = [](const std::function<std::uint8_t(int)>& level, bool is_artnet) {
        Merge merge;
        Desk desk{1};
        std::vector<Packet> sent;
        for (int i = 0; i < 400; ++i) {
            Packet packet = is_artnet ? unnumbered(0, 6454) : desk.packet({0});
            if (is_artnet) packet.sequence = static_cast<std::uint8_t>(i % 255 + 1);
            sent.push_back(with_level(packet, level(i)));
        }
        for (int i = 0; i + 1 < 400; ++i) {
            const nanoseconds now = i * 25ms;
            const auto at = [&](int index) { return sent[static_cast<std::size_t>(index)]; };
            if (i % 5 == 0) merge.feed(at(i + 1), now);
            if (i % 11 != 0) merge.feed(at(i), now);
            if (i % 3 == 0) merge.feed(at(i), now + 1ms);
            merge.tick(now);
            if (merge.sources(now).at(0).is_shared) return true;
        }
        return false;
    };
    for (const bool is_artnet : {false, true}) {
        EXPECT_FALSE(shared([](int) { return std::uint8_t{9}; }, is_artnet)) << "at rest";
        EXPECT_FALSE(shared(flash, is_artnet)) << "flashes with every packet";
        EXPECT_FALSE(shared([](int i) { return flash(i / 3); }, is_artnet)) << "flashes";
        EXPECT_FALSE(shared([](int i) { return static_cast<std::uint8_t>(i / 2); }, is_artnet)) << "fades";
        EXPECT_FALSE(shared([](int i) { return static_cast<std::uint8_t>(i / 40); }, is_artnet)) << "steps";
    }
}

TEST(Merge, loss_is_told_beside_late_packets) {
    Merge merge;
    Desk desk{1};
    Packet late;
    for (int i = 0; i < 1200; ++i) {
        const Packet packet = desk.packet({i / 40});
        if (i % 40 == 20) late = packet;
        if (i % 10 != 0 && i % 40 != 20) merge.feed(packet, i * 25ms);
        if (i % 40 == 23) merge.feed(late, i * 25ms + 1ms);
        merge.tick(i * 25ms);
    }
    const std::uint64_t lost = merge.counters().lost;
    EXPECT_GE(lost, 60u);
    EXPECT_LE(lost, 150u) << "every tenth of 1200, and what came late";
}

TEST(Merge, the_same_packet_twice_is_no_second_sender) {
    Desk twice{1};
    EXPECT_FALSE(after_two_seconds([&](Merge& merge, int i, nanoseconds now) {
                     const Packet packet = with_level(twice.packet({4}), flash(i));
                     merge.feed(packet, now);
                     merge.feed(packet, now);
                 }).is_shared)
        << "the network brings every packet twice";
}

TEST(Merge, a_desk_that_begins_anew_is_one_desk) {
    for (const int back : {1, 5, 18, 19, 20, 100, 128}) {
        Merge merge;
        Desk desk{1};
        for (int i = 0; i < 300; ++i) {
            if (i == 120) desk.sequence = static_cast<std::uint8_t>(desk.sequence - back);
            merge.feed(with_level(desk.packet({0}), i < 120 ? 200 : 10), i * 25ms);
            merge.tick(i * 25ms);
            ASSERT_FALSE(merge.sources(i * 25ms).at(0).is_shared) << back << " back, " << i;
        }
    }
}

TEST(Merge, a_universe_without_a_single_slot_does_not_arrive) {
    Merge merge;
    Packet packet = unnumbered(10, 6454);
    packet.slot_count = 0;
    merge.feed(packet, 0ms);
    EXPECT_TRUE(merge.universes().list.empty());
    merge.feed(unnumbered(10, 6454), 25ms);
    EXPECT_EQ(merge.universes().list.size(), 1u);
}

TEST(Merge, who_sends_priorities_alone_stays) {
    Merge merge;
    Desk desk;
    for (int i = 0; i < 240; ++i) {
        merge.feed(desk.priorities({100}), i * 25ms);
        merge.tick(i * 25ms);
        ASSERT_EQ(merge.sources(i * 25ms).at(0).state, SourceState::live) << i;
    }
    merge.tick(9s);
    EXPECT_TRUE(merge.sources(9s).empty());
    EXPECT_TRUE(merge.universes().list.empty());
}

TEST(Merge, the_most_slots_of_late_are_told) {
    const auto with_slots = [](Merge& merge, int i, nanoseconds now) {
        Packet packet = unnumbered(10, 6454);
        packet.slot_count = i % 40 == 0 ? kSlots : 24;
        merge.feed(packet, now);
    };
    const SourceStatus mixed = after_two_seconds(with_slots);
    EXPECT_EQ(mixed.slot_count, 24);
    EXPECT_EQ(mixed.most_slots, kSlots);
    Merge merge;
    with_slots(merge, 0, 0ms);
    for (int i = 1; i < 40; ++i) with_slots(merge, i, i * 100ms);
    EXPECT_EQ(merge.sources(4s).at(0).most_slots, 24) << "whole ones are long ago";
}

} // namespace
} // namespace ghost::dmx
