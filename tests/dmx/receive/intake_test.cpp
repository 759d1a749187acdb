// SPDX-License-Identifier: Apache-2.0
// Bad input to everything behind the sockets: truncations and bit flips of every kind of packet, garbage,
// storms. Whatever comes, the patched universe shows what its desk sends, and memory is bounded.
#include "dmx/receive/intake.h"

#include "dmx/wire/build.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using Buffer = std::vector<std::uint8_t>;

constexpr std::uint32_t kDesk = 0x0A000001, kOther = 0x0A000066;

Arrival arrival(Protocol protocol, std::uint32_t from, nanoseconds now) {
    return {protocol, from, 0x0A000005, 0, 2, false, now};
}

struct Sample {
    const char* name;
    Protocol protocol;
    Buffer bytes;
};

// Of one that brings levels into Art-Net by its first port.
Buffer reply_of_a_sender() {
    const auto reply = build_poll_reply({.ports = {{1}}});
    Buffer bytes(reply.begin(), reply.end());
    bytes[174] = 0x40; // PortTypes
    bytes[186] = 6;    // SwIn
    return bytes;
}

Buffer artnet(std::initializer_list<int> rest) {
    Buffer bytes = {'A', 'r', 't', '-', 'N', 'e', 't', 0};
    for (const int byte : rest) bytes.push_back(static_cast<std::uint8_t>(byte));
    return bytes;
}

// One valid packet of each kind.
std::vector<Sample> samples() {
    const std::array<std::uint8_t, 16> cid{9, 9};
    const std::vector<std::uint16_t> universes(100, 7);
    const auto reply = build_poll_reply({.ports = {{1}}});
    return {
        {"sACN levels", Protocol::sacn, build_sacn(1, Buffer(512, 200), 1, {150, cid, "Other"})},
        {"sACN short", Protocol::sacn, build_sacn(1, Buffer(3, 200), 1, {150, cid, "Other"})},
        {"sACN synchronised", Protocol::sacn,
         build_sacn(1, Buffer(512, 200), 1, {150, cid, "Other"}, {0, 0, 50})},
        {"sACN priorities", Protocol::sacn,
         build_sacn(1, Buffer(512, 200), 1, {150, cid, "Other"}, {0, 0xDD})},
        {"sACN text", Protocol::sacn, build_sacn(1, Buffer(512, 200), 1, {150, cid, "Other"}, {0, 0x17})},
        {"sACN goodbye", Protocol::sacn, build_sacn(1, {}, 1, {150, cid, "Other"}, {0x40})},
        {"sACN sync", Protocol::sacn, build_sacn_sync(50, 1, cid)},
        {"sACN discovery", Protocol::sacn, build_sacn_discovery(universes, 0, 1, cid, "Other")},
        {"ArtDmx", Protocol::artnet, build_artdmx(0, Buffer(512, 200), 1)},
        {"ArtPoll", Protocol::artnet, artnet({0x00, 0x20, 0, 14, 0x20, 0, 0, 9, 0, 1})},
        {"ArtPollReply", Protocol::artnet, Buffer(reply.begin(), reply.end())},
        {"ArtPollReply of a sender", Protocol::artnet, reply_of_a_sender()},
        {"ArtSync", Protocol::artnet, artnet({0x00, 0x52, 0, 14, 0, 0})},
        {"ArtTimeCode", Protocol::artnet, artnet({0x00, 0x97, 0, 14, 0, 0, 4, 3, 2, 1, 1})},
        {"ArtTrigger", Protocol::artnet, artnet({0x00, 0x99, 0, 14, 0, 0, 255, 255, 1, 5})},
    };
}

IntakeOptions patched() {
    IntakeOptions options;
    options.universes = {1, 2};
    options.merge.priority_wait = kPriorityWait;
    return options;
}

// The desk of universe 1, and what must be seen of it.
struct Rig {
    Intake intake{patched()};
    nanoseconds now = 100s;
    std::uint8_t sequence = 0;

    void desk(std::uint8_t level) {
        const Buffer bytes = build_sacn(1, Buffer(512, level), ++sequence, {200, {1}, "Desk"});
        (void)intake.take(bytes, arrival(Protocol::sacn, kDesk, now));
        intake.tick(now);
    }
    int shown() { return intake.merge().universes().level(1, 512); }
    Statistics statistics() {
        Statistics result;
        intake.report(result, now);
        return result;
    }
};

TEST(Intake, what_is_wanted_finds_a_place_among_what_comes_elsewhere) {
    Intake intake{patched()}; // universes 1, 2
    const auto send = [&](std::uint16_t universe) {
        intake.take_elsewhere(build_sacn(universe, Buffer(512, 9), 1, {100, {1}, "Desk"}),
                              arrival(Protocol::sacn, kDesk, 100s));
    };
    for (std::uint16_t universe = 100; universe < 100 + kMaxUnlisted + 50; ++universe) send(universe);
    send(1);
    Statistics statistics;
    intake.report(statistics, 100s);
    EXPECT_EQ(statistics.elsewhere_universes.size(), kMaxUnlisted);
    EXPECT_TRUE(std::any_of(statistics.elsewhere_universes.begin(), statistics.elsewhere_universes.end(),
                            [](const ElsewhereUniverse& one) { return one.universe == 1; }));
}

TEST(Intake, who_sends_what_nobody_patched_stands_still) {
    Intake intake{patched()};
    const auto told = [&](nanoseconds now) {
        Statistics statistics;
        intake.report(statistics, now);
        return statistics.unlisted_universes.at(0);
    };
    const auto send = [&](const char* name, nanoseconds now) {
        (void)intake.take(build_sacn(9, Buffer(512, 9), 1, {100, {1}, name}),
                          arrival(Protocol::sacn, kDesk, now));
    };
    send("B", 100s);
    EXPECT_FALSE(told(100s).has_others);
    for (const char* name : {"A", "B"}) send(name, 101s);
    EXPECT_EQ(told(101s).name, "A") << "not the newest";
    EXPECT_TRUE(told(101s).has_others);
    send("B", 105s); // A is gone
    send("B", 109s);
    EXPECT_EQ(told(109s).name, "B");
    EXPECT_FALSE(told(109s).has_others);
}

TEST(Intake, one_time_code_is_followed_until_it_is_silent) {
    std::vector<int> followed;
    IntakeOptions options = patched();
    options.on_timecode = [&](const TimeCode& time, nanoseconds) { followed.push_back(time.hours); };
    Intake intake{options};
    nanoseconds now = 100s;
    const auto send = [&](std::uint8_t hours, std::uint32_t from, std::uint16_t port) {
        Arrival by = arrival(Protocol::artnet, from, now);
        by.from_port = port;
        (void)intake.take(artnet({0x00, 0x97, 0, 14, 0, 0, 4, 3, 2, hours, 1}), by);
    };
    send(1, kDesk, 6454);
    for (int k = 0; k < 3; ++k, now += 40ms) {
        send(1, kDesk, 6454);
        send(2, kDesk, 40000); // another program of that machine
        send(3, kOther, 6454);
    }
    EXPECT_EQ(followed, (std::vector<int>{1, 1, 1, 1}));
    Statistics statistics;
    intake.report(statistics, now);
    ASSERT_TRUE(statistics.followed_timecodes[1]);
    EXPECT_EQ(statistics.followed_timecodes[1]->time.hours, 3);
    now += 1100ms;
    send(3, kOther, 6454);
    EXPECT_EQ(followed.back(), 3);
}

TEST(Intake, a_time_code_that_opens_a_socket_for_each_packet_is_one) {
    std::vector<int> followed;
    IntakeOptions options = patched();
    options.on_timecode = [&](const TimeCode& time, nanoseconds) { followed.push_back(time.frames); };
    Intake intake{options};
    nanoseconds now = 100s;
    const auto send = [&](std::uint8_t frames, std::uint16_t port) {
        Arrival by = arrival(Protocol::artnet, kDesk, now += 40ms);
        by.from_port = port;
        (void)intake.take(artnet({0x00, 0x97, 0, 14, 0, 0, frames, 3, 2, 1, 1}), by);
    };
    for (std::uint8_t k = 0; k < 5; ++k) send(k, static_cast<std::uint16_t>(40000 + k));
    EXPECT_EQ(followed, (std::vector<int>{0, 1, 2, 3, 4}));
    Statistics statistics;
    intake.report(statistics, now);
    EXPECT_FALSE(statistics.followed_timecodes[1]) << "nobody is told of two";
    // Two programs that begin in one moment: after one jump it stays with one.
    for (std::uint8_t k = 0; k < 3; ++k) {
        send(20, 50000);
        send(21, 50001);
    }
    EXPECT_EQ(followed, (std::vector<int>{0, 1, 2, 3, 4, 20, 21, 21, 21}));
    intake.report(statistics, now);
    ASSERT_TRUE(statistics.followed_timecodes[1]);
    EXPECT_EQ(statistics.followed_timecodes[1]->time.frames, 20);
    // And so of three.
    followed.clear();
    now += 2s;
    for (std::uint8_t k = 0; k < 5; ++k)
        for (std::uint8_t program = 1; program <= 3; ++program)
            send(program, static_cast<std::uint16_t>(60000 + program));
    EXPECT_EQ(followed, (std::vector<int>{1, 2, 3, 3, 3, 3, 3}));
}

TEST(Intake, valid_packets_are_all_understood) {
    Rig rig;
    for (const Sample& sample : samples()) {
        (void)rig.intake.take(sample.bytes, arrival(sample.protocol, kOther, rig.now));
        const Statistics statistics = rig.statistics();
        for (const std::uint64_t count : statistics.drops) EXPECT_EQ(count, 0u) << sample.name;
    }
    const Statistics statistics = rig.statistics();
    EXPECT_EQ(statistics.packets_sacn, 8u);
    EXPECT_EQ(statistics.packets_artnet, 7u);
    ASSERT_TRUE(statistics.timecode.has_value());
    EXPECT_EQ(timecode_text(statistics.timecode->time), "01:02:03:04 EBU 25");
    ASSERT_EQ(statistics.triggers.size(), 1u);
    EXPECT_EQ(trigger_text(statistics.triggers[0].trigger), "macro 5");
    EXPECT_EQ(statistics.triggers[0].number, 1u);
    EXPECT_EQ(statistics.discovered.size(), 2u); // a list of sACN, an ArtPollReply
    EXPECT_EQ(statistics.sync.size(), 2u);
}

TEST(Intake, who_brings_levels_into_artnet_is_known_for_a_while_and_to_a_limit) {
    Rig rig;
    for (std::uint32_t k = 0; k < 1000; ++k)
        (void)rig.intake.take(reply_of_a_sender(), arrival(Protocol::artnet, kOther + k, rig.now));
    const std::vector<DiscoveredSource> senders = rig.statistics().discovered;
    ASSERT_EQ(senders.size(), kMaxDiscovered);
    EXPECT_EQ(senders[0].protocol, Protocol::artnet);
    EXPECT_EQ(*senders[0].universes, std::vector<std::uint16_t>{7});
    EXPECT_EQ(rig.statistics().notices[static_cast<std::size_t>(Notice::poll_reply)], 1000u);
    const Buffer list = build_sacn_discovery(std::vector<std::uint16_t>{7}, 0, 0, {9, 9}, "Other");
    (void)rig.intake.take(list, arrival(Protocol::sacn, kOther, rig.now));
    EXPECT_EQ(rig.statistics().discovered.size(), kMaxDiscovered + 1)
        << "a list of sACN has places of its own";
    rig.now += 26s;
    rig.intake.tick(rig.now);
    EXPECT_TRUE(rig.statistics().discovered.empty());
}

TEST(Intake, every_truncation_and_every_flipped_bit) {
    Rig rig;
    rig.desk(7);
    std::uint64_t fed = 0;
    for (const Sample& sample : samples()) {
        for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
            // A copy of its own, so that the address sanitizer sees a read past the end.
            const Buffer cut(sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(size));
            (void)rig.intake.take(cut, arrival(sample.protocol, kOther, rig.now));
            ++fed;
        }
        for (std::size_t bit = 0; bit < sample.bytes.size() * 8; ++bit) {
            Buffer flipped = sample.bytes;
            flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ (1 << bit % 8));
            (void)rig.intake.take(flipped, arrival(sample.protocol, kOther, rig.now));
            ++fed;
            if (bit % 50 == 0) {
                rig.now += 20ms;
                rig.desk(static_cast<std::uint8_t>(bit));
                ASSERT_EQ(rig.shown(), static_cast<std::uint8_t>(bit)) << sample.name << ", bit " << bit;
            }
        }
    }
    const Statistics statistics = rig.statistics();
    EXPECT_GT(fed, 20000u);
    std::uint64_t dropped = 0;
    for (const std::uint64_t count : statistics.drops) dropped += count;
    EXPECT_GT(dropped, 2500u);
    EXPECT_GT(statistics.wrong_length, 2000u);
    EXPECT_LE(statistics.sources.size(), 2 * kMaxSourcesPerUniverse);
}

TEST(Intake, garbage_is_counted) {
    Rig rig;
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        Buffer bytes(random() % 700);
        for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
        const Protocol protocol = i % 2 ? Protocol::sacn : Protocol::artnet;
        (void)rig.intake.take(bytes, arrival(protocol, kOther, rig.now));
    }
    const Statistics statistics = rig.statistics();
    std::uint64_t dropped = 0;
    for (const std::uint64_t count : statistics.drops) dropped += count;
    EXPECT_EQ(dropped, 20000u);
    EXPECT_TRUE(statistics.sources.empty());
}

TEST(Intake, a_storm_of_universes_nobody_patched) {
    Rig rig;
    for (int i = 0; i < 60000; ++i) {
        rig.now += 100us;
        const auto universe = static_cast<std::uint16_t>(3 + i % 60000);
        (void)rig.intake.take(build_sacn(universe, Buffer(8, 9), 1, {200, {7}, "Storm"}),
                              arrival(Protocol::sacn, kOther, rig.now));
        if (i % 200 == 0) {
            rig.desk(static_cast<std::uint8_t>(i));
            ASSERT_EQ(rig.shown(), static_cast<std::uint8_t>(i));
        }
    }
    const Statistics statistics = rig.statistics();
    EXPECT_EQ(statistics.unlisted, 60000u);
    ASSERT_EQ(statistics.unlisted_universes.size(), kMaxUnlisted);
    EXPECT_EQ(statistics.sources.size(), 1u);
    EXPECT_EQ(statistics.unlisted_universes[0].universe, 3);
    EXPECT_EQ(statistics.unlisted_universes[0].from, IpAddress(kOther));
    rig.now += 11s;
    rig.intake.tick(rig.now);
    EXPECT_TRUE(rig.statistics().unlisted_universes.empty()) << "it is over";
}

TEST(Intake, a_storm_of_sync_packets) {
    Rig rig;
    for (int i = 0; i < 20000; ++i) {
        rig.now += 100us;
        (void)rig.intake.take(
            build_sacn_sync(static_cast<std::uint16_t>(1 + i % 300), static_cast<std::uint8_t>(i), {8}),
            arrival(Protocol::sacn, kOther, rig.now));
        if (i % 200 == 0) {
            rig.desk(static_cast<std::uint8_t>(i));
            ASSERT_EQ(rig.shown(), static_cast<std::uint8_t>(i));
        }
    }
    EXPECT_EQ(rig.statistics().sync.size(), kMaxSyncStreams);
}

TEST(Intake, the_wrong_group_is_noted_and_the_levels_used) {
    Rig rig;
    Arrival wrong = arrival(Protocol::sacn, kDesk, rig.now);
    wrong.to = sacn_group(9);
    (void)rig.intake.take(build_sacn(1, Buffer(512, 20), 1, {100, {1}, "Desk"}), wrong);
    EXPECT_EQ(rig.shown(), 20);
    EXPECT_EQ(rig.statistics().wrong_group, 1u);
    EXPECT_TRUE(rig.statistics().sources[0].wrong_group);
    for (const bool ipv6 : {false, true}) {
        wrong.to = sacn_group_address(1, ipv6);
        (void)rig.intake.take(build_sacn(1, Buffer(512, 20), ipv6 ? 3 : 2, {100, {1}, "Desk"}), wrong);
        EXPECT_FALSE(rig.statistics().sources[0].wrong_group);
    }
}

TEST(Intake, a_wrong_length_is_noted_and_the_levels_that_came_are_used) {
    Rig rig;
    Buffer sacn = build_sacn(1, Buffer(512, 20), 1, {100, {1}, "Desk"});
    sacn.resize(126 + 400);
    (void)rig.intake.take(sacn, arrival(Protocol::sacn, kDesk, rig.now));
    EXPECT_EQ(rig.intake.merge().universes().level(1, 400), 20);
    EXPECT_EQ(rig.shown(), 0);
    Buffer artnet = build_artdmx(1, Buffer(512, 30), 1);
    artnet.resize(18 + 4);
    (void)rig.intake.take(artnet, arrival(Protocol::artnet, kDesk, rig.now));
    EXPECT_EQ(rig.intake.merge().universes().level(2, 4), 30);
    EXPECT_EQ(rig.statistics().wrong_length, 2u);
    ASSERT_EQ(rig.statistics().sources.size(), 2u);
    for (const SourceStatus& source : rig.statistics().sources) EXPECT_TRUE(source.wrong_length);
    rig.sequence = 1;
    rig.desk(40); // its own packets are right
    EXPECT_EQ(rig.shown(), 40);
    EXPECT_FALSE(rig.statistics().sources[0].wrong_length);
    EXPECT_EQ(rig.statistics().wrong_length, 2u);
}

TEST(Intake, triggers_are_remembered_to_a_limit) {
    Rig rig;
    Buffer bytes = samples().back().bytes;
    for (int i = 0; i < 100; ++i) {
        bytes.back() = static_cast<std::uint8_t>(i);
        (void)rig.intake.take(bytes, arrival(Protocol::artnet, kDesk, rig.now));
    }
    const auto triggers = rig.statistics().triggers;
    ASSERT_EQ(triggers.size(), kMaxRemembered);
    EXPECT_EQ(triggers.back().number, 100u);
    EXPECT_EQ(triggers.back().trigger.sub_key, 99);
}

TEST(Latency, percentiles) {
    Latency latency;
    EXPECT_EQ(latency.percentile_ms(0.5), 0.0);
    for (int i = 1; i <= 1000; ++i) latency.add(std::chrono::microseconds(i));
    EXPECT_NEAR(latency.percentile_ms(0.5), 0.5, 0.05);
    EXPECT_NEAR(latency.percentile_ms(0.99), 0.99, 0.1);
    EXPECT_EQ(latency.count(), 1000u);
    latency.add(100h);
    latency.add(-1s); // a clock that was set
    EXPECT_GT(latency.percentile_ms(1.0), 60000.0);
    EXPECT_EQ(latency.max_ms(), 3600e3 * 100);
    Latency one;
    one.add(1003us);
    EXPECT_EQ(one.percentile_ms(0.5), one.max_ms()) << "no step is above the maximum";
}

} // namespace
} // namespace ghost::dmx
