// SPDX-License-Identifier: Apache-2.0
// What only sockets show: IPv6 by unicast and multicast, the group of a synchronisation universe that is
// joined when somebody needs it, what the receiver says of its sockets.
#include "dmx/receive/receiver.h"
#include "dmx/wire/build.h"
#include "net/socket.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <thread>
#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Buffer = std::vector<std::uint8_t>;

// Ports that differ between test processes running at the same time.
ReceiverOptions sacn_on_loopback() {
    ReceiverOptions options;
    options.universes = {1, 2};
    options.artnet = false;
    options.sampling = 0s;
    options.sacn_port = static_cast<std::uint16_t>(41000 + getpid() % 10000);
    return options;
}

bool wait_for(const std::function<bool()>& done) {
    for (int i = 0; i < 1000; ++i) {
        if (done()) return true;
        std::this_thread::sleep_for(5ms);
    }
    return false;
}

std::optional<NetInterface> loopback6() {
    for (const NetInterface& interface : list_interfaces())
        if (interface.loopback && interface.ipv6) return interface;
    return std::nullopt;
}

// Multicast needs a route that the loopback interface has not: tests/scripts/network_test.py.
TEST(Receiver, ipv6_unicast) {
    if (!loopback6()) GTEST_SKIP() << "the loopback interface has no IPv6 here";
    const ReceiverOptions options = sacn_on_loopback();
    const auto receiver = Receiver::start(options);
    ASSERT_TRUE(receiver.ok()) << receiver.error().text();
    const auto out = UdpSocket::open_ipv6(0, 1 << 16);
    ASSERT_TRUE(out.ok()) << out.error().text();
    const auto self = parse_address("::1");
    ASSERT_TRUE(self.ok());

    std::uint8_t sequence = 0;
    Universes seen;
    Statistics statistics;
    EXPECT_TRUE(wait_for([&] {
        const auto bytes = build_sacn(1, Buffer(512, 11), ++sequence, {100, {1}, "Six"});
        EXPECT_TRUE((*out)->send(bytes, *self, options.sacn_port).ok());
        if (auto newest = (*receiver)->take()) seen = *newest;
        if (auto newest = (*receiver)->take_statistics()) statistics = *newest;
        return seen.level(1, 512) == 11 && !statistics.sources.empty();
    }));
    ASSERT_EQ(statistics.sources.size(), 1u);
    EXPECT_EQ(statistics.sources[0].from, *self);
    EXPECT_TRUE(std::any_of(statistics.sockets.begin(), statistics.sockets.end(), [](const auto& socket) {
        return socket.ipv6 && socket.groups >= 3; // of universes 1 and 2 and of discovery
    }));
}

TEST(Receiver, joins_the_group_of_a_synchronisation_universe) {
    ReceiverOptions options = sacn_on_loopback();
    options.interface = "127.0.0.1";
    const auto receiver = Receiver::start(options);
    ASSERT_TRUE(receiver.ok()) << receiver.error().text();
    const auto loopback = find_interface("127.0.0.1");
    const auto out = UdpSocket::open(0, 0, 1 << 16);
    ASSERT_TRUE(out.ok() && loopback.ok() && (*out)->send_multicast_through(*loopback).ok());
    const std::array<std::uint8_t, 16> cid{7};
    std::uint8_t sequence = 0;
    Statistics statistics;
    // Universe 900 is nobody's, so its group is joined for its sync packets only.
    EXPECT_TRUE(wait_for([&] {
        ++sequence;
        EXPECT_TRUE(
            (*out)
                ->send(build_sacn(1, Buffer(512, sequence), sequence, {100, cid, "Sync"}, {0, 0, 900}),
                       sacn_group(1), options.sacn_port)
                .ok());
        EXPECT_TRUE(
            (*out)->send(build_sacn_sync(900, sequence, cid), sacn_group(900), options.sacn_port).ok());
        if (auto newest = (*receiver)->take_statistics()) statistics = *newest;
        return !statistics.sync.empty() && statistics.merge.held > 5;
    }));
    ASSERT_EQ(statistics.sync.size(), 1u);
    EXPECT_EQ(statistics.sync[0].universe, 900);
    EXPECT_EQ(statistics.unlisted, 0u);
    EXPECT_EQ(statistics.sources.at(0).sync_universe, 900);
}

TEST(Receiver, finds_out_who_sends_before_it_shows_anything) {
    ReceiverOptions options = sacn_on_loopback();
    options.interface = "127.0.0.1";
    options.sampling = 300s; // no machine is that slow
    const auto receiver = Receiver::start(options);
    ASSERT_TRUE(receiver.ok()) << receiver.error().text();
    const auto out = UdpSocket::open(0, 0, 1 << 16);
    ASSERT_TRUE(out.ok());
    std::uint8_t sequence = 0;
    Statistics statistics;
    EXPECT_TRUE(wait_for([&] {
        EXPECT_TRUE((*out)
                        ->send(build_sacn(1, Buffer(512, 11), ++sequence, {100, {1}, "Desk"}), 0x7F000001,
                               options.sacn_port)
                        .ok());
        if (auto newest = (*receiver)->take_statistics()) statistics = *newest;
        return !statistics.sources.empty() && statistics.sources[0].packets > 3;
    }));
    EXPECT_TRUE(statistics.sampling);
    EXPECT_TRUE((*receiver)->sampling());
    EXPECT_FALSE((*receiver)->take().has_value());
}

} // namespace
} // namespace ghost::dmx
