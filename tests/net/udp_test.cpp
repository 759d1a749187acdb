// SPDX-License-Identifier: Apache-2.0
#include "net/socket.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kHere = 0x7F000001;

// A port of the system's choice would not be known to the sender.
std::uint16_t udp_port(int which) {
    return static_cast<std::uint16_t>(
        52000 + std::chrono::steady_clock::now().time_since_epoch().count() / 1000 % 9000 + which);
}

TEST(Udp, a_packet_says_where_it_came_from_and_went_to) {
    const std::uint16_t port = udp_port(0);
    std::array sockets{must(UdpSocket::open(kHere, port, 1 << 16))};
    const auto sender = must(UdpSocket::open(0, 0, 1 << 16));
    EXPECT_FALSE(wait_for_packets(sockets, {}, 10ms)[0]);
    const std::vector<std::uint8_t> bytes{1, 2, 3};
    const auto before = std::chrono::steady_clock::now().time_since_epoch();
    ASSERT_TRUE(sender->send(bytes, kHere, port).ok());
    EXPECT_TRUE(wait_for_packets(sockets, {}, 5s)[0]);
    const auto got = sockets[0]->receive();
    ASSERT_EQ(got.size(), 1u);
    EXPECT_TRUE(std::ranges::equal(got[0].bytes, bytes));
    EXPECT_EQ(got[0].from, IpAddress(kHere));
    EXPECT_EQ(got[0].to, IpAddress(kHere));
    EXPECT_EQ(got[0].local_ipv4, kHere);
    EXPECT_EQ(got[0].interface_index, must(find_interface("127.0.0.1")).index);
    EXPECT_GE(got[0].time, before - 1ms);
    EXPECT_LE(got[0].time, std::chrono::steady_clock::now().time_since_epoch());
    EXPECT_EQ(sockets[0]->packets(), 1u);
    EXPECT_TRUE(sockets[0]->receive().empty());
    EXPECT_GT(sockets[0]->receive_buffer(), 0);
}

TEST(Udp, of_a_long_packet_the_beginning_is_kept) {
    const std::uint16_t port = udp_port(1);
    std::array sockets{must(UdpSocket::open(kHere, port, 1 << 16))};
    const auto sender = must(UdpSocket::open(0, 0, 1 << 16));
    const std::vector<std::uint8_t> bytes(4000, 7);
    ASSERT_TRUE(sender->send(bytes, kHere, port).ok());
    ASSERT_TRUE(wait_for_packets(sockets, {}, 5s)[0]);
    const auto got = sockets[0]->receive();
    ASSERT_EQ(got.size(), 1u);
    EXPECT_EQ(got[0].bytes.size(), 1536u);
}

TEST(Udp, groups_come_to_those_that_joined_them) {
    const std::uint16_t port = udp_port(2);
    const NetInterface loopback = must(find_interface("127.0.0.1"));
    std::array sockets{must(UdpSocket::open(0, port, 1 << 16)), must(UdpSocket::open(0, port, 1 << 16))};
    const IpAddress group(0xEFFF0001), other(0xEFFF0002);
    ASSERT_TRUE(sockets[0]->join(group, loopback).ok());
    ASSERT_TRUE(sockets[0]->join(group, loopback).ok()) << "twice is once";
    ASSERT_TRUE(sockets[1]->join(other, loopback).ok());
    const auto sender = must(UdpSocket::open(0, 0, 1 << 16));
    ASSERT_TRUE(sender->send_multicast_through(loopback).ok());
    const std::vector<std::uint8_t> bytes{9};
    const auto heard = [&](std::size_t which) {
        std::this_thread::sleep_for(50ms);
        return sockets[which]->receive().size();
    };
    ASSERT_TRUE(sender->send(bytes, group, port).ok());
    EXPECT_EQ(heard(0), 1u);
    EXPECT_EQ(heard(1), 0u);
    sockets[0]->leave(group, loopback);
    ASSERT_TRUE(sender->send(bytes, group, port).ok());
    EXPECT_EQ(heard(0), 0u);
}

TEST(Udp, a_port_that_is_free_is_had_once) {
    const std::uint16_t port = udp_port(3);
    const auto first = must(UdpSocket::open_if_free(port, 1 << 16));
    EXPECT_FALSE(UdpSocket::open_if_free(port, 1 << 16).ok());
    EXPECT_TRUE(UdpSocket::open(kHere, port, 1 << 16).ok()) << "those that share it come later";
}

} // namespace
} // namespace ghost::dmx
