// SPDX-License-Identifier: Apache-2.0
#include "dmx/send/sender.h"

#include "net/socket.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

const auto kPort = static_cast<std::uint16_t>(20000 + getpid() % 20000 * 2);

// The first datagram, copied.
struct Arrived {
    std::vector<std::uint8_t> bytes;
    std::uint16_t from_port = 0;
};

Arrived receive(std::unique_ptr<UdpSocket>& socket) {
    std::vector<std::unique_ptr<UdpSocket>> sockets;
    sockets.push_back(std::move(socket));
    Arrived result;
    for (int i = 0; i < 100 && result.bytes.empty(); ++i) {
        (void)wait_for_packets(sockets, {}, 100ms);
        for (const Datagram& datagram : sockets[0]->receive())
            result = {{datagram.bytes.begin(), datagram.bytes.end()}, datagram.from_port};
    }
    socket = std::move(sockets[0]);
    return result;
}

Universes look(std::uint16_t slot_count) {
    Universes universes;
    universes.at(1).slot_count = slot_count;
    return universes;
}

Sender open(Protocol protocol) {
    SenderOptions options;
    options.protocol = protocol;
    options.destination = "127.0.0.1";
    options.port = kPort;
    return must(Sender::open(options));
}

TEST(Sender, artdmx_leaves_from_its_own_port_where_that_is_free) {
    Sender sender = open(Protocol::artnet);
    auto later = UdpSocket::open(0x7F000001, kPort, 64 << 10); // who comes later may listen there
    ASSERT_TRUE(later.ok()) << later.error().text();
    ASSERT_TRUE(sender.send(look(512)).ok());
    EXPECT_EQ(receive(*later).from_port, kPort);
    Sender second = open(Protocol::artnet);
    ASSERT_TRUE(second.send(look(512)).ok());
    const Arrived arrived = receive(*later);
    EXPECT_EQ(arrived.bytes.size(), 530u);
    EXPECT_NE(arrived.from_port, kPort);
}

TEST(Sender, packets_have_as_many_slots_as_the_universe) {
    auto socket = UdpSocket::open(0x7F000001, kPort, 64 << 10);
    ASSERT_TRUE(socket.ok());
    Sender sacn = open(Protocol::sacn), artnet = open(Protocol::artnet);
    for (const std::uint16_t slots : std::vector<std::uint16_t>{1, 63, 64, 512}) {
        ASSERT_TRUE(sacn.send(look(slots)).ok());
        EXPECT_EQ(receive(*socket).bytes.size(), 126u + slots);
        ASSERT_TRUE(artnet.send(look(slots)).ok());
        EXPECT_EQ(receive(*socket).bytes.size(), 18u + slots + slots % 2u);
    }
}

} // namespace
} // namespace ghost::dmx
