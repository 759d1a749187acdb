// SPDX-License-Identifier: Apache-2.0
// Packets of real consoles (OLA 0.10.9, QLC+ 4.12.6) and the standard's own example, where they lie beside
// the checkout. The expected counts were taken with tshark 4.0.
#include "dmx/merge/merge.h"
#include "support/pcap_file.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const fs::path kData = fs::path(GHOST_SOURCE_DIR) / "../shared/control/data";

struct Replay {
    Merge merge;
    std::map<std::string, int> seen; // "sACN 1", "notice poll", "drop ..."
    std::vector<Captured> packets;

    explicit Replay(const char* name) : packets(read_pcap(kData / name)) {}

    // Up to and with this long after the first packet.
    void run(std::chrono::nanoseconds until = 24h) {
        for (; next_ < packets.size() && packets[next_].time - packets[0].time <= until; ++next_) {
            const Captured& packet = packets[next_];
            if (packet.port != 5568 && packet.port != 6454) continue;
            const Parsed parsed = packet.port == 5568 ? parse_sacn(packet.payload, packet.from)
                                                      : parse_artnet(packet.payload, packet.from);
            if (const Packet* levels = std::get_if<Packet>(&parsed)) {
                ++seen[std::string(protocol_name(levels->protocol)) + " " + std::to_string(levels->universe)];
                merge.feed(*levels, packet.time);
                merge.tick(packet.time);
            } else if (const std::optional<Notice> notice = notice_of(parsed)) {
                ++seen[std::string("notice ") + notice_name(*notice)];
            } else {
                ++seen[std::string("drop ") + drop_name(std::get<Drop>(parsed))];
            }
        }
    }

private:
    std::size_t next_ = 0;
};

using Seen = std::map<std::string, int>;

class Captures : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(kData)) GTEST_SKIP() << kData << " is not there";
    }
};

TEST_F(Captures, example_of_the_standard) {
    Replay replay("pcap_from_hex/e131_2018_appendixB.pcap");
    replay.run();
    EXPECT_EQ(replay.seen, (Seen{{"sACN 1", 1}, {"notice sync", 1}, {"notice discovery", 1}}));
    EXPECT_EQ(replay.merge.universes().level(1, 1), 0);
    EXPECT_EQ(replay.merge.universes().level(1, 2), 1);
    EXPECT_EQ(replay.merge.universes().level(1, 512), 255);
    EXPECT_EQ(replay.merge.sources(0s).at(0).name, "Source_A");
}

TEST_F(Captures, ola_chase_and_termination) {
    Replay replay("captures/ola_0.10.9_sacn1_5_artnet1_chase_terminate.pcap");
    replay.run();
    EXPECT_EQ(replay.seen["sACN 1"], 184); // the last 3 say goodbye, with no slots
    EXPECT_EQ(replay.seen["notice discovery"], 3);
    EXPECT_EQ(replay.seen["sACN 5"], 1);      // sends a look once and no more
    EXPECT_EQ(replay.seen["Art-Net 2"], 181); // Port-Address 1
    EXPECT_EQ(replay.seen["notice poll"], 4);
    EXPECT_EQ(replay.seen["notice poll_reply"], 8);
    EXPECT_EQ(replay.merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(replay.merge.counters().missed, 0u);
    EXPECT_TRUE(replay.merge.universes().find(1)->lost);
    for (const auto& [what, count] : replay.seen) EXPECT_EQ(what.find("drop"), std::string::npos) << what;
}

TEST_F(Captures, qlcplus_multicast_and_broadcast) {
    Replay replay("captures/qlcplus_4.12.6_artnet0_bcast_sacn2_mcast.pcap");
    replay.run();
    EXPECT_EQ(replay.seen,
              (Seen{{"sACN 2", 449}, {"Art-Net 1", 449}, {"notice poll", 2}, {"notice poll_reply", 2}}));
    EXPECT_EQ(replay.merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(replay.merge.counters().missed, 0u);
}

TEST_F(Captures, two_sources_take_over_and_loss) {
    Replay replay("captures/two_sources_sacn2_qlc100_ola150_killed.pcap");
    replay.run();
    EXPECT_EQ(replay.seen["sACN 2"], 599 + 160);
    const auto& universes = replay.merge.universes();
    ASSERT_NE(universes.find(2), nullptr);
    EXPECT_EQ(replay.merge.counters().out_of_sequence, 0u);
    EXPECT_EQ(replay.merge.counters().sources_lost, 1u); // OLA was killed and said nothing
    ASSERT_EQ(replay.merge.sources(0s).size(), 2u);      // QLC+ on both protocols
}

TEST_F(Captures, while_two_sources_send_each_holds_its_slots) {
    Replay replay("captures/two_sources_sacn2_qlc100_ola150_killed.pcap");
    int both = 0;
    for (auto t = 0ms; t < 14s; t += 20ms) {
        replay.run(t);
        const std::chrono::nanoseconds now = replay.packets.at(0).time + t;
        int sacn = 0;
        for (const SourceStatus& source : replay.merge.sources(now))
            if (source.universe == 2 && source.age < 100ms) sacn += source.slot_count == 4 ? 1 : 10;
        if (sacn != 11) continue;
        ++both;
        EXPECT_EQ(replay.merge.universes().level(2, 2), 200); // "N,200,0,7" by OLA at priority 150
        EXPECT_EQ(replay.merge.universes().level(2, 3), 0);
        EXPECT_EQ(replay.merge.universes().level(2, 4), 7);
    }
    EXPECT_GT(both, 100);
}

TEST_F(Captures, ola_artnet_unit_test_packets) {
    Replay replay("pcap_from_hex/ola_artnet_tests.pcap");
    replay.run();
    EXPECT_EQ(replay.seen["Art-Net 1"], 5);
    EXPECT_EQ(replay.seen["Art-Net 1060"], 4);
    EXPECT_EQ(replay.seen["notice poll"], 1);
    EXPECT_EQ(replay.seen["notice poll_reply"], 6);
    EXPECT_EQ(replay.seen["notice timecode"], 1);
}

// The levels of a packet of either protocol, if these bytes are one.
std::optional<Packet> levels_of(const std::vector<std::uint8_t>& bytes) {
    for (const Parsed& parsed : {parse_sacn(bytes), parse_artnet(bytes)})
        if (const Packet* packet = std::get_if<Packet>(&parsed)) return *packet;
    return std::nullopt;
}

TEST_F(Captures, every_truncation_of_every_packet_is_harmless) {
    std::size_t cuts = 0, refused = 0, clipped = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(kData / "captures")) {
        std::map<std::size_t, int> sizes; // a few packets of each size are enough
        for (const Captured& packet : read_pcap(file.path())) {
            if (++sizes[packet.payload.size()] > 3) continue;
            const std::optional<Packet> whole = levels_of(packet.payload);
            for (std::size_t size = 0; size < packet.payload.size(); ++size) {
                // A copy of its own, so that the address sanitizer sees a read past the end.
                const std::vector<std::uint8_t> cut(
                    packet.payload.begin(), packet.payload.begin() + static_cast<std::ptrdiff_t>(size));
                ++cuts;
                if (!whole) continue;
                // None of these senders puts anything behind the levels.
                const std::size_t header = packet.payload.size() - whole->slot_count;
                const std::optional<Packet> part = levels_of(cut);
                ASSERT_EQ(part.has_value(), size > header) << size << " of " << packet.payload.size();
                ++(part ? clipped : refused);
                if (!part) continue;
                EXPECT_TRUE(part->wrong_length);
                ASSERT_EQ(part->slot_count, size - header);
                EXPECT_TRUE(std::equal(part->slots.begin(), part->slots.begin() + part->slot_count,
                                       whole->slots.begin()));
            }
        }
    }
    EXPECT_GT(cuts, 5000u);
    EXPECT_GT(refused, 1000u);
    EXPECT_GT(clipped, 1000u);
}

} // namespace
} // namespace ghost::dmx
