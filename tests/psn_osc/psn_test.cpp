// SPDX-License-Identifier: Apache-2.0
#include "psn_osc/psn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Buffer = std::vector<std::uint8_t>;

Buffer chunk(std::uint16_t id, const Buffer& data, bool has_chunks = false) {
    const auto length = static_cast<std::uint16_t>(data.size() | (has_chunks ? 0x8000u : 0u));
    Buffer result{static_cast<std::uint8_t>(id & 255), static_cast<std::uint8_t>(id >> 8),
                  static_cast<std::uint8_t>(length & 255), static_cast<std::uint8_t>(length >> 8)};
    result.insert(result.end(), data.begin(), data.end());
    return result;
}

Buffer floats(std::initializer_list<float> values) {
    Buffer result;
    for (const float value : values)
        for (int shift = 0; shift < 32; shift += 8)
            result.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(value) >> shift));
    return result;
}

Buffer operator+(Buffer a, const Buffer& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const Buffer kHeader = chunk(0, {1, 0, 0, 0, 0, 0, 0, 0, 2, 3, 7, 1});

Buffer data_packet(const Buffer& trackers) {
    return chunk(0x6755, kHeader + chunk(1, trackers, true), true);
}

const Buffer kData = data_packet(
    chunk(3, chunk(0, floats({1, 2, 3})) + chunk(1, floats({0, 0, 1})) + chunk(3, floats({1})), true) +
    chunk(9, chunk(0, floats({-4.5f, 0, 6})), true));
const Buffer kInfo = chunk(0x6756,
                           kHeader + chunk(1, {'S', 'y', 's'}) +
                               chunk(2, chunk(3, chunk(0, {'S', 'i', 'n', 'g', 'e', 'r'}), true), true),
                           true);

TEST(Psn, positions_and_names) {
    const auto data = parse_psn(kData);
    ASSERT_TRUE(data.has_value());
    ASSERT_EQ(data->positions.size(), 2u);
    EXPECT_EQ(data->positions[0].id, 3);
    EXPECT_EQ(data->positions[0].position_m, (std::array{1.0f, 2.0f, 3.0f}));
    EXPECT_EQ(data->positions[1].position_m, (std::array{-4.5f, 0.0f, 6.0f}));
    const auto info = parse_psn(kInfo);
    ASSERT_TRUE(info.has_value());
    EXPECT_EQ(info->names, (std::map<std::uint16_t, std::string>{{3, "Singer"}}));

    Trackers trackers;
    trackers.feed(*info, 1s);
    EXPECT_EQ(trackers.find(3), nullptr) << "named, but nowhere yet";
    trackers.feed(*data, 2s);
    ASSERT_NE(trackers.find("Singer"), nullptr);
    EXPECT_EQ(trackers.find("Singer"), trackers.find(3));
    EXPECT_EQ(trackers.find("Singer")->seen, 2s);
    EXPECT_EQ(trackers.find(4), nullptr);
}

TEST(Psn, a_tracker_that_is_not_seen_has_no_position) {
    for (const Buffer& fields :
         {chunk(0, floats({1, 2, 3})) + chunk(3, floats({0})),
          chunk(0, floats({1, std::numeric_limits<float>::quiet_NaN(), 3})), chunk(2, floats({1, 2, 3}))}) {
        const auto packet = parse_psn(data_packet(chunk(3, fields, true)));
        ASSERT_TRUE(packet.has_value());
        EXPECT_TRUE(packet->positions.empty());
    }
}

TEST(Psn, a_position_that_is_too_short_spoils_the_packet) {
    EXPECT_FALSE(parse_psn(data_packet(chunk(3, chunk(0, floats({1, 2})), true))).has_value());
}

TEST(Psn, cut_and_damaged_packets) {
    for (const Buffer& packet : {kData, kInfo}) {
        for (std::size_t length = 0; length < packet.size(); ++length)
            EXPECT_FALSE(parse_psn(Bytes(packet).first(length)).has_value()) << length;
        for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
            Buffer damaged = packet;
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
            if (const auto parsed = parse_psn(damaged)) {
                EXPECT_LE(parsed->positions.size(), 2u);
                EXPECT_LE(parsed->names.size(), 1u);
            }
        }
    }
}

TEST(Psn, memory_is_bounded) {
    Trackers trackers;
    for (std::uint32_t first = 0; first < 65536; first += 64) {
        PsnPacket packet;
        for (std::uint32_t id = first; id < first + 64; ++id)
            packet.positions.push_back({static_cast<std::uint16_t>(id), {}});
        trackers.feed(packet, 1s);
    }
    EXPECT_EQ(trackers.all().size(), kMostTrackers);
}

// A neighbour who sends a thousand other numbers a second takes nobody's place.
TEST(Psn, forged_ids_do_not_lock_real_ones_out) {
    Trackers trackers;
    std::uint16_t forged = 1000;
    const auto flood = [&](std::chrono::nanoseconds now) {
        for (int packets = 0; packets < 40; ++packets) {
            PsnPacket packet;
            for (int k = 0; k < 30; ++k) packet.positions.push_back({forged++, {9, 9, 9}});
            trackers.feed(packet, now);
        }
    };
    for (int frame = 0; frame < 60; ++frame) { // the flood is there first, 72,000 ids a second
        const auto now = frame * 16ms;
        flood(now);
        if (frame < 10) continue;
        trackers.feed({{{7, {1, 2, 3}}}, {}}, now);
        trackers.feed({{{7, {1, 2, 3}}}, {{7, "Singer"}}}, now);
        ASSERT_TRUE(trackers.find(7)) << frame;
    }
    flood(2s);
    ASSERT_TRUE(trackers.find(7)) << "one that is known stays where it was";
    EXPECT_EQ(trackers.find("Singer"), trackers.find(7));
    EXPECT_EQ(trackers.all().size(), kMostTrackers);
    for (auto now = 62s; now < 72s; now += 1s) flood(now);
    EXPECT_FALSE(trackers.find(7)) << "one that was silent for a minute makes room";
}

TEST(Psn, forged_ids_that_go_on_do_not_lock_out_those_that_a_show_names) {
    Trackers trackers;
    trackers.expect({7}, {"Singer"});
    const auto flood = [&](std::chrono::nanoseconds now) {
        for (std::uint16_t first = 1000; first < 1000 + kMostTrackers; first += 32) {
            PsnPacket packet;
            for (std::uint16_t k = 0; k < 32; ++k)
                packet.positions.push_back({static_cast<std::uint16_t>(first + k), {9, 9, 9}});
            trackers.feed(packet, now);
        }
    };
    for (int frame = 0; frame < 100; ++frame) {
        const auto now = frame * 16ms;
        flood(now);
        if (frame < 20) continue;
        trackers.feed({{{7, {1, 2, 3}}}, {}}, now);
        if (frame % 60 == 20) trackers.feed({{{8, {4, 5, 6}}}, {{8, "Singer"}}}, now);
        flood(now);
        ASSERT_TRUE(trackers.find(7)) << frame;
        ASSERT_TRUE(trackers.find("Singer")) << frame;
    }
    EXPECT_EQ(trackers.all().size(), kMostTrackers);
}

// One packet, which gives a thousand numbers the name that a show asks for.
TEST(Psn, forged_names_do_not_lock_real_ones_out) {
    Trackers trackers;
    trackers.expect({7}, {"Singer", "Dancer"});
    PsnPacket forged;
    for (std::uint16_t id = 1000; id < 1000 + kMostTrackers; ++id) forged.names[id] = "Singer";
    trackers.feed(forged, 1s);
    ASSERT_EQ(trackers.all().size(), kMostTrackers);
    trackers.feed({{{7, {1, 2, 3}}, {8, {4, 5, 6}}, {9, {7, 8, 9}}}, {{8, "Singer"}, {9, "Dancer"}}}, 2s);
    EXPECT_TRUE(trackers.find(7)) << "a number that the show names";
    EXPECT_EQ(trackers.find("Singer"), trackers.find(8));
    EXPECT_TRUE(trackers.find("Dancer"));
    trackers.feed({{{10, {1, 1, 1}}}, {}}, 2s);
    EXPECT_TRUE(trackers.find(10)) << "one that the show does not name";
    const auto later = [&](std::chrono::nanoseconds now) {
        for (std::uint16_t first = 3000; first < 3000 + 2 * kMostTrackers; first += 4) {
            PsnPacket packet;
            for (std::uint16_t id = first; id < first + 4; ++id) packet.positions.push_back({id, {9, 9, 9}});
            trackers.feed(packet, now);
        }
    };
    later(3s);
    later(200s);
    EXPECT_TRUE(trackers.find(7)) << "those that a show names stay, even where they are silent";
    EXPECT_TRUE(trackers.find("Singer"));
    EXPECT_TRUE(trackers.find("Dancer"));
    EXPECT_EQ(std::count_if(trackers.all().begin(), trackers.all().end(),
                            [](const auto& entry) { return entry.second.name == "Singer"; }),
              static_cast<std::ptrdiff_t>(kMostOfAName));
}

// What the reference encoder sends: four trackers, three seconds.
TEST(Psn, capture_of_the_reference_encoder) {
    const auto path =
        std::filesystem::path(GHOST_SOURCE_DIR) / "../shared/control/data/captures/psn_vyv_4trackers.pcap";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no ../shared beside the checkout";
    std::ifstream file(path, std::ios::binary);
    const Buffer bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    ByteReader reader(bytes);
    reader.skip(24);
    Trackers trackers;
    int data = 0, info = 0;
    while (reader.left() >= 16) {
        reader.skip(8);
        const std::size_t length = reader.u32_le();
        reader.skip(4);
        const Bytes frame = reader.take(length);
        constexpr std::size_t kHeads = 14 + 20 + 8; // Ethernet, IPv4, UDP
        if (frame.size() < kHeads) continue;
        const auto packet = parse_psn(frame.subspan(kHeads));
        ASSERT_TRUE(packet.has_value());
        data += packet->positions.empty() ? 0 : 1;
        info += packet->names.empty() ? 0 : 1;
        trackers.feed(*packet, 1s);
    }
    EXPECT_GT(data, 150);
    EXPECT_GE(info, 3);
    ASSERT_EQ(trackers.all().size(), 4u);
    ASSERT_NE(trackers.find("Singer"), nullptr);
    EXPECT_FLOAT_EQ(trackers.find("Singer")->position_m[1], 1.7f) << "the second axis points up there";
}

} // namespace
} // namespace ghost::dmx
