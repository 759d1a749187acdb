// SPDX-License-Identifier: Apache-2.0
// Sequence numbers that do not count up, and senders that share an identity.
#include "dmx/merge/merge.h"
#include "support/desk.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

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
    EXPECT_EQ(sources[0].back_hz, 0.0);
    EXPECT_NEAR(sources[1].back_hz, 40.0, 2.0) << "at each turn";
    EXPECT_NEAR(sources[2].late_hz, 40.0, 1.0);
    EXPECT_NEAR(sources[2].rate_hz, 40.0, 1.0);
}

TEST(Merge, who_sends_other_packets_under_the_same_identity) {
    const auto double_of = [](int behind, bool other_levels, bool both_speak) {
        Merge merge;
        Desk desk{1};
        for (int i = 0; i < 40; ++i) {
            Packet packet = desk.packet({10});
            packet.from = IpAddress(0x0A000001);
            if (i < 10 || both_speak) merge.feed(packet, i * 25ms);
            packet.sequence = static_cast<std::uint8_t>(packet.sequence - behind);
            packet.from = IpAddress(0x0A000002);
            if (other_levels) packet.slots[0] = 99;
            merge.feed(packet, i * 25ms + 1ms);
        }
        return merge.sources(1s).at(0).double_from;
    };
    EXPECT_EQ(double_of(100, false, true), IpAddress(0x0A000002));
    EXPECT_EQ(double_of(0, true, true), IpAddress(0x0A000002)) << "numbered alike by chance";
    EXPECT_FALSE(double_of(0, false, true)) << "a desk with two network cards";
    EXPECT_FALSE(double_of(2, false, true)) << "of which one is slower";
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

} // namespace
} // namespace ghost::dmx
