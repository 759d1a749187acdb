// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/discovery.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Numbers = std::vector<std::uint16_t>;

DiscoveryPacket page(std::uint8_t id, int number, int last, Numbers universes) {
    DiscoveryPacket packet;
    packet.source.id[0] = id;
    packet.source_name = "Desk";
    packet.from = 0x0A000001;
    packet.page = static_cast<std::uint8_t>(number);
    packet.last_page = static_cast<std::uint8_t>(last);
    packet.universes = std::move(universes);
    return packet;
}

TEST(Discovery, a_list_counts_when_all_its_pages_came) {
    Discovery discovery;
    discovery.feed(page(0xAB, 0, 1, {1, 2}), 0s);
    ASSERT_EQ(discovery.list(1s).size(), 1u);
    EXPECT_TRUE(discovery.list(1s)[0].universes->empty());
    discovery.feed(page(0xAB, 1, 1, {700, 2}), 0s);
    const DiscoveredSource source = discovery.list(1s).at(0);
    EXPECT_EQ(*source.universes, (Numbers{1, 2, 700}));
    EXPECT_EQ(source.name, "Desk");
    EXPECT_EQ(source.id, "ab000000000000000000000000000000");
    EXPECT_EQ(source.age, std::chrono::nanoseconds(1s));
    discovery.feed(page(0xAB, 0, 1, {9}), 10s); // half of the next: the old one stands
    EXPECT_EQ(*discovery.list(10s)[0].universes, (Numbers{1, 2, 700}));
    discovery.feed(page(0xAB, 0, 0, {5, 0, 64000}), 20s); // a new list; no universe is called 0 or 64000
    EXPECT_EQ(*discovery.list(20s)[0].universes, Numbers{5});
}

TEST(Discovery, a_source_is_forgotten_after_two_announcements_missed) {
    Discovery discovery;
    discovery.feed(page(1, 0, 0, {1}), 0s);
    discovery.tick(25s);
    EXPECT_EQ(discovery.list(25s).size(), 1u);
    discovery.tick(25s + 1ms);
    EXPECT_TRUE(discovery.list(26s).empty());
}

TEST(Discovery, forged_sources_and_pages_are_limited) {
    Discovery discovery;
    for (int i = 0; i < 250; ++i) discovery.feed(page(static_cast<std::uint8_t>(i), 0, 0, {1}), 0s);
    EXPECT_EQ(discovery.list(0s).size(), kMaxDiscovered);
    EXPECT_EQ(discovery.too_many(), 250 - kMaxDiscovered);
    for (int i = 0; i <= 255; ++i) discovery.feed(page(1, i, 255, Numbers(512, 7)), 0s);
    EXPECT_EQ(*discovery.list(0s).at(1).universes, Numbers{7}) << "the pages that can be";
}

} // namespace
} // namespace ghost::dmx
