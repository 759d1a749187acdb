// SPDX-License-Identifier: Apache-2.0
// The receiver on the loopback interface, on ports of its own so that no desk or other test is in the way.
#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"
#include "dmx/wire/build.h"
#include "net/socket.h"
#include "support/must.h"
#include "support/wine.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <thread>
#include <unistd.h>
#if !defined(_WIN32)
#include <arpa/inet.h>
#include <sys/socket.h>
#endif

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr const char* kWineBinds = "Wine binds 127.0.0.3 to every address";

// Ports that differ between test processes running at the same time.
std::uint16_t port_of(int which) {
    return static_cast<std::uint16_t>(20000 + (getpid() % 10000) * 2 + which);
}

ReceiverOptions on_loopback() {
    ReceiverOptions options;
    options.interface = "127.0.0.1";
    options.sacn_port = port_of(0);
    options.artnet_port = port_of(1);
    options.answer_polls = false;
    options.sampling = 0s;
    return options;
}

std::unique_ptr<Receiver> start(const ReceiverOptions& options) {
    auto receiver = Receiver::start(options);
    EXPECT_TRUE(receiver.ok()) << receiver.error().text();
    return receiver.ok() ? std::move(*receiver) : nullptr;
}

Sender sender(Protocol protocol, const std::string& destination, const ReceiverOptions& options) {
    SenderOptions wanted;
    wanted.protocol = protocol;
    wanted.destination = destination;
    wanted.interface = "127.0.0.1";
    wanted.port = protocol == Protocol::sacn ? options.sacn_port : options.artnet_port;
    return must(Sender::open(wanted));
}

Universes look(std::uint16_t number, std::uint8_t level) {
    Universes result;
    auto levels = std::make_shared<Levels>();
    levels->fill(level);
    result.at(number).levels = levels;
    return result;
}

// The newest levels once done says so; what came last after two seconds.
Universes wait_for(Receiver& receiver, const std::function<bool(const Universes&)>& done) {
    Universes newest;
    for (const auto end = std::chrono::steady_clock::now() + 2s; std::chrono::steady_clock::now() < end;) {
        if (auto universes = receiver.take()) newest = std::move(*universes);
        if (done(newest)) break;
        std::this_thread::sleep_for(2ms);
    }
    return newest;
}

Statistics statistics_after(Receiver& receiver, nanoseconds wait) {
    std::this_thread::sleep_for(wait);
    (void)receiver.take_statistics();
    for (int i = 0; i < 200; ++i) {
        if (auto statistics = receiver.take_statistics()) return *statistics;
        std::this_thread::sleep_for(5ms);
    }
    ADD_FAILURE() << "no statistics within a second";
    return {};
}

TEST(Receiver, unicast_of_both_protocols) {
    const ReceiverOptions options = on_loopback();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender sacn = sender(Protocol::sacn, "127.0.0.1", options),
           artnet = sender(Protocol::artnet, "127.0.0.1", options);
    ASSERT_TRUE(sacn.send(look(7, 70)).ok());
    ASSERT_TRUE(artnet.send(look(9, 90)).ok());
    const Universes levels = wait_for(*receiver, [](const Universes& u) { return u.find(7) && u.find(9); });
    EXPECT_EQ(levels.level(7, 1), 70);
    EXPECT_EQ(levels.level(7, 512), 70);
    EXPECT_EQ(levels.level(9, 512), 90);
    ASSERT_EQ(sacn.terminate(), 3u);
    const Universes after =
        wait_for(*receiver, [](const Universes& u) { return u.find(7) && u.find(7)->lost; });
    ASSERT_NE(after.find(7), nullptr);
    EXPECT_TRUE(after.find(7)->lost);
    EXPECT_EQ(after.level(7, 1), 70);
}

TEST(Receiver, every_interface_when_none_is_chosen) {
    ReceiverOptions options = on_loopback();
    options.interface.clear();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender sacn = sender(Protocol::sacn, "127.0.0.1", options);
    ASSERT_TRUE(sacn.send(look(1, 11)).ok());
    EXPECT_EQ(wait_for(*receiver, [](const Universes& u) { return u.find(1) != nullptr; }).level(1, 1), 11);
}

TEST(Receiver, multicast_of_many_universes_each_once) {
    ReceiverOptions options = on_loopback();
    for (std::uint16_t universe = 1; universe <= 50; ++universe) options.universes.push_back(universe);
    const auto receiver = start(options); // 50 groups: three sockets
    ASSERT_TRUE(receiver);
    EXPECT_TRUE(receiver->warnings().empty()) << receiver->warnings()[0];
    Sender sacn = sender(Protocol::sacn, "", options);
    Universes all;
    for (std::uint16_t universe = 1; universe <= 51; ++universe) all.at(universe); // the last is not joined
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(sacn.send(all).ok());
    wait_for(*receiver, [](const Universes& u) { return u.list.size() >= 50; });
    const Statistics statistics = statistics_after(*receiver, 50ms);
    EXPECT_EQ(statistics.packets_sacn, 150u);
    EXPECT_EQ(statistics.merge.out_of_sequence, 0u); // no copies
    EXPECT_EQ(statistics.sources.size(), 50u);
}

TEST(Receiver, broadcast_counts_once) {
    const ReceiverOptions options = on_loopback();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender sacn = sender(Protocol::sacn, "127.255.255.255", options),
           artnet = sender(Protocol::artnet, "", options);
    ASSERT_TRUE(sacn.send(look(3, 30)).ok());
    ASSERT_TRUE(artnet.send(look(4, 40)).ok());
    const Universes levels = wait_for(*receiver, [](const Universes& u) { return u.find(3) && u.find(4); });
    EXPECT_EQ(levels.level(3, 1), 30);
    EXPECT_EQ(levels.level(4, 1), 40);
    const Statistics statistics = statistics_after(*receiver, 50ms);
    EXPECT_EQ(statistics.packets_sacn, 1u);
    EXPECT_EQ(statistics.packets_artnet, 1u);
}

TEST(Receiver, universes_nobody_asked_for_are_counted_and_left) {
    ReceiverOptions options = on_loopback();
    options.universes = {2};
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender sacn = sender(Protocol::sacn, "127.0.0.1", options);
    ASSERT_TRUE(sacn.send(look(1, 1)).ok());
    ASSERT_TRUE(sacn.send(look(2, 2)).ok());
    const Universes levels = wait_for(*receiver, [](const Universes& u) { return u.find(2) != nullptr; });
    EXPECT_EQ(levels.find(1), nullptr);
    EXPECT_EQ(statistics_after(*receiver, 0ms).unlisted, 1u);
}

TEST(Receiver, bad_packets_are_counters) {
    const ReceiverOptions options = on_loopback();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    const auto socket = UdpSocket::open(0, 0, 1 << 16);
    ASSERT_TRUE(socket.ok());
    const std::vector<std::uint8_t> junk(100, 0x55), huge(4000, 0x55);
    for (const auto& bytes : {junk, huge, std::vector<std::uint8_t>{}})
        for (const std::uint16_t port : {options.sacn_port, options.artnet_port})
            ASSERT_TRUE((*socket)->send(bytes, 0x7F000001, port).ok());
    const Statistics statistics = statistics_after(*receiver, 100ms);
    EXPECT_EQ(statistics.drops[static_cast<std::size_t>(Drop::not_ours)], 4u);
    EXPECT_EQ(statistics.drops[static_cast<std::size_t>(Drop::too_short)], 2u);
}

TEST(Receiver, of_a_cut_packet_what_came_is_shown_and_counted) {
    const ReceiverOptions options = on_loopback();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    const auto socket = UdpSocket::open(0, 0, 1 << 16);
    ASSERT_TRUE(socket.ok());
    const auto send_both = [&](std::uint8_t sequence, std::uint8_t level, std::size_t missing) {
        const std::vector<std::uint8_t> levels(512, level);
        auto sacn = build_sacn(1, levels, sequence, {100, {}, "Desk"});
        auto artdmx = build_artdmx(1, levels, sequence); // our universe 2
        sacn.resize(sacn.size() - missing);
        artdmx.resize(artdmx.size() - missing);
        return (*socket)->send(sacn, 0x7F000001, options.sacn_port).ok() &&
               (*socket)->send(artdmx, 0x7F000001, options.artnet_port).ok();
    };
    ASSERT_TRUE(send_both(1, 50, 0));
    wait_for(*receiver, [](const Universes& u) { return u.find(1) && u.find(2); });
    ASSERT_TRUE(send_both(2, 60, 412));
    const Universes cut = wait_for(
        *receiver, [](const Universes& u) { return u.level(1, 100) == 60 && u.level(2, 100) == 60; });
    for (const std::uint16_t universe : std::initializer_list<std::uint16_t>{1, 2})
        EXPECT_EQ(cut.level(universe, 101), 0) << "a source does not hold what it does not send";
    Statistics statistics = statistics_after(*receiver, 100ms);
    EXPECT_EQ(statistics.wrong_length, 2u);
    EXPECT_EQ(statistics.packets_sacn, 2u);
    EXPECT_EQ(statistics.packets_artnet, 2u);
    for (const std::uint64_t count : statistics.drops) EXPECT_EQ(count, 0u);
    ASSERT_TRUE(send_both(3, 70, 0));
    const Universes levels = wait_for(
        *receiver, [](const Universes& u) { return u.level(1, 512) == 70 && u.level(2, 512) == 70; });
    for (const std::uint16_t universe : std::initializer_list<std::uint16_t>{1, 2}) {
        EXPECT_EQ(levels.level(universe, 1), 70);
        EXPECT_EQ(levels.level(universe, 512), 70);
    }
}

TEST(Receiver, our_own_hello_is_no_traffic_and_no_answer) {
    if (is_wine()) GTEST_SKIP() << kWineBinds;
    ReceiverOptions options = on_loopback();
    options.answer_polls = true;
    for (std::uint16_t universe = 1; universe <= 40; ++universe) options.universes.push_back(universe);
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    const Statistics quiet = statistics_after(*receiver, 300ms);
    EXPECT_EQ(quiet.announcements_sent, 40u);
    EXPECT_EQ(quiet.packets_artnet, 0u);
    EXPECT_EQ(quiet.notices[static_cast<std::size_t>(Notice::poll_reply)], 0u);
    EXPECT_EQ(quiet.poll_replies_sent, 0u);

    // Others are heard: a node elsewhere, and a desk of this machine at our very address and port.
    const auto node = UdpSocket::open(0x7F000003, options.artnet_port, 1 << 16);
    const auto desk = UdpSocket::open(0x7F000001, options.artnet_port, 1 << 16);
    ASSERT_TRUE(node.ok() && desk.ok());
    ASSERT_TRUE((*node)->send(build_poll_reply({.ports = {{1}}}), 0x7FFFFFFF, options.artnet_port).ok());
    const std::vector<std::uint8_t> levels(512, 80);
    ASSERT_TRUE((*desk)->send(build_artdmx(0, levels, 1), 0x7FFFFFFF, options.artnet_port).ok());
    const Universes seen = wait_for(*receiver, [](const Universes& u) { return u.find(1) != nullptr; });
    EXPECT_EQ(seen.level(1, 1), 80);
    const Statistics later = statistics_after(*receiver, 100ms);
    EXPECT_EQ(later.packets_artnet, 2u);
    EXPECT_EQ(later.notices[static_cast<std::size_t>(Notice::poll_reply)], 1u);
}

TEST(Receiver, answers_a_poll_with_one_reply_per_universe) {
    if (is_wine()) GTEST_SKIP() << kWineBinds;
    ReceiverOptions options = on_loopback();
    options.answer_polls = true;
    for (std::uint16_t universe = 1; universe <= 40; ++universe) options.universes.push_back(universe);
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    const auto desk = UdpSocket::open(0x7F000003, options.artnet_port, 1 << 18);
    ASSERT_TRUE(desk.ok());
    std::this_thread::sleep_for(100ms); // past the hello
    Sender artnet = sender(Protocol::artnet, "127.0.0.1", options);
    ASSERT_TRUE(artnet.send(look(18, 1)).ok());
    const std::vector<std::uint8_t> poll = {'A', 'r',  't',  '-',  'N',  'e',  't',
                                            0,   0x00, 0x20, 0x00, 0x0e, 0x02, 0x00};
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE((*desk)->send(poll, 0x7F000001, options.artnet_port).ok()); // impatient
    std::set<int> ports, bind_indices;
    std::set<int> receiving;
    std::size_t replies = 0;
    for (const auto end = std::chrono::steady_clock::now() + 400ms; std::chrono::steady_clock::now() < end;) {
        for (const Datagram& datagram : (*desk)->receive()) {
            ASSERT_EQ(datagram.bytes.size(), 239u);
            EXPECT_EQ(datagram.bytes[13], 1); // 127.0.0.1
            const int port = datagram.bytes[18] << 8 | datagram.bytes[19] << 4 | datagram.bytes[190];
            ports.insert(port);
            bind_indices.insert(datagram.bytes[211]);
            if (datagram.bytes[182] & 0x80) receiving.insert(port);
            ++replies;
        }
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(replies, 40u);
    EXPECT_EQ(ports.size(), 40u);
    EXPECT_EQ(*ports.begin(), 0);
    EXPECT_EQ(*ports.rbegin(), 39);
    EXPECT_EQ(bind_indices.size(), 40u);
    EXPECT_EQ(*bind_indices.begin(), 1);
    EXPECT_EQ(receiving, std::set<int>{17});
    const Statistics statistics = statistics_after(*receiver, 0ms);
    EXPECT_EQ(statistics.poll_replies_sent, 40u);
    EXPECT_EQ(statistics.announcements_sent, 40u);
    EXPECT_EQ(statistics.notices[static_cast<std::size_t>(Notice::poll)], 3u);
    EXPECT_EQ(statistics.packets_artnet, 4u); // three polls and the levels
}

TEST(Receiver, what_goes_out_though_nobody_asks_is_bounded) {
    if (is_wine()) GTEST_SKIP() << kWineBinds;
    ReceiverOptions options = on_loopback();
    options.answer_polls = true;
    const std::vector<std::uint8_t> packet{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x81};
    std::optional<PollAnswers::Place> known, unknown;
    options.unasked = [&](nanoseconds, const ReceiverOptions::PlaceOf& place_of) {
        known = place_of(3);
        unknown = place_of(0x7000);
        return std::optional(ReceiverOptions::Unasked{0x7F000003, {packet}});
    };
    const auto desk = UdpSocket::open(0x7F000003, options.artnet_port, 1 << 18);
    ASSERT_TRUE(desk.ok());
    {
        const auto receiver = start(options);
        ASSERT_TRUE(receiver);
        std::this_thread::sleep_for(350ms);
    }
    ASSERT_TRUE(known);
    EXPECT_EQ(known->bind_index, 4);
    EXPECT_FALSE(unknown) << "no reply names it";
    std::size_t got = 0;
    for (auto datagrams = (*desk)->receive(); !datagrams.empty(); datagrams = (*desk)->receive())
        for (const Datagram& datagram : datagrams) got += std::ranges::equal(datagram.bytes, packet) ? 1 : 0;
    EXPECT_GE(got, kMaxAnswers / 2);
    EXPECT_LE(got, kMaxAnswers / 2 * 8) << "half of what may be, ten times a second";
}

#if !defined(_WIN32) // where one that asks for nothing keeps out nobody that shares
TEST(Receiver, a_taken_port_is_named) {
    const ReceiverOptions options = on_loopback();
    const int other = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(options.artnet_port);
    ASSERT_EQ(bind(other, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    const auto receiver = Receiver::start(options);
    close(other);
    ASSERT_FALSE(receiver.ok());
    EXPECT_NE(receiver.error().text().find("UDP port " + std::to_string(options.artnet_port)),
              std::string::npos);
    EXPECT_NE(receiver.error().text().find("taken"), std::string::npos);
}
#endif

// Levels of 1 and 2 go on while others come and go.
TEST(Receiver, other_universes_from_now_on) {
    ReceiverOptions options = on_loopback();
    options.universes = {1, 2};
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender desk = sender(Protocol::sacn, "127.0.0.1", options);
    std::uint8_t level = 0;
    const auto send = [&](std::initializer_list<std::uint16_t> universes) {
        ++level;
        for (const std::uint16_t universe : universes) ASSERT_TRUE(desk.send(look(universe, level)).ok());
    };
    send({1, 2, 5});
    Universes seen = wait_for(*receiver, [&](const Universes& now) { return now.level(2, 1) == level; });
    EXPECT_EQ(seen.list.size(), 2u);
    receiver->listen_to({5, 2, 5});
    seen = wait_for(*receiver, [](const Universes& now) { return now.list.size() == 1; });
    ASSERT_EQ(seen.list.size(), 1u);
    EXPECT_EQ(seen.list[0].number, 2) << "that of 1 is forgotten, not lost";
    for (int i = 0; i < 50; ++i) {
        send({1, 2, 5});
        if (i == 20) receiver->listen_to({2, 5, 6});
        if (i == 30) receiver->listen_to({2, 5});
        std::this_thread::sleep_for(2ms);
    }
    seen = wait_for(*receiver, [&](const Universes& now) { return now.level(5, 1) == level; });
    EXPECT_EQ(seen.level(2, 1), level);
    EXPECT_EQ(seen.list.size(), 2u);
    const Statistics statistics = statistics_after(*receiver, 300ms);
    ASSERT_EQ(statistics.sources.size(), 2u);
    EXPECT_EQ(statistics.sources[0].universe, 2);
    EXPECT_EQ(statistics.sources[0].packets, 51u) << "not one of those that stayed was lost";
    EXPECT_EQ(statistics.merge.missed, 0u);
    EXPECT_EQ(statistics.merge.sources_lost, 0u);
    EXPECT_TRUE(statistics.lost.empty());
    ASSERT_EQ(statistics.unlisted_universes.size(), 1u);
    EXPECT_EQ(statistics.unlisted_universes[0].universe, 1);
}

TEST(Receiver, groups_of_other_universes_are_joined_and_left) {
    ReceiverOptions options = on_loopback();
    options.artnet = false;
    for (std::uint16_t universe = 1; universe <= 30; ++universe) options.universes.push_back(universe);
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    const auto groups = [&] {
        std::size_t sum = 0;
        for (const SocketStatus& socket : statistics_after(*receiver, 300ms).sockets)
            sum += socket.ipv6 ? 0 : socket.groups;
        return sum;
    };
    EXPECT_EQ(groups(), 31u) << "and that of universe discovery";
    receiver->listen_to({30, 31, 32});
    EXPECT_EQ(groups(), 4u);
    std::vector<std::uint16_t> many;
    for (std::uint16_t universe = 1; universe <= 100; ++universe) many.push_back(universe);
    receiver->listen_to(many);
    EXPECT_EQ(groups(), 101u);
}

TEST(Receiver, an_unknown_interface_is_named_with_the_choice) {
    ReceiverOptions options = on_loopback();
    options.interface = "nosuch0";
    const auto receiver = Receiver::start(options);
    ASSERT_FALSE(receiver.ok());
    EXPECT_NE(receiver.error().what.find("nosuch0"), std::string::npos);
    EXPECT_NE(receiver.error().what.find("127.0.0.1"), std::string::npos);
}

TEST(Receiver, a_reader_that_slept_gets_the_newest_look) {
    const ReceiverOptions options = on_loopback();
    const auto receiver = start(options);
    ASSERT_TRUE(receiver);
    Sender sacn = sender(Protocol::sacn, "127.0.0.1", options);
    for (int level = 1; level <= 50; ++level) {
        ASSERT_TRUE(sacn.send(look(1, static_cast<std::uint8_t>(level))).ok());
        std::this_thread::sleep_for(2ms);
    }
    std::this_thread::sleep_for(50ms);
    const auto levels = receiver->take();
    ASSERT_TRUE(levels.has_value());
    EXPECT_EQ(levels->level(1, 1), 50);
    EXPECT_FALSE(receiver->take().has_value());
}

} // namespace
} // namespace ghost::dmx
