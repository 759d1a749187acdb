// SPDX-License-Identifier: Apache-2.0
#include "net/tcp.h"

#include "net/socket.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <thread>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kLoopback = 0x7F000001;

bool within_5_s(const std::function<bool()>& holds) {
    for (int i = 0; i < 1000; ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(5ms);
    }
    return false;
}

struct Pair {
    std::unique_ptr<TcpListener> listener = must(TcpListener::open(kLoopback, 0));
    std::unique_ptr<TcpStream> caller = must(TcpStream::connect(kLoopback, listener->port())), called;
    Pair() {
        within_5_s([&] { return (called = listener->accept()) != nullptr; });
    }
};

TEST(Tcp, what_is_sent_arrives_and_an_end_is_seen) {
    Pair pair;
    ASSERT_NE(pair.called, nullptr);
    EXPECT_EQ(pair.called->peer(), IpAddress(kLoopback));
    EXPECT_EQ(pair.listener->accept(), nullptr);
    std::vector<std::uint8_t> bytes(300'000), got;
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * 13);
    std::size_t sent = 0;
    EXPECT_TRUE(within_5_s([&] {
        if (sent < bytes.size()) sent += pair.caller->send(Bytes(bytes).subspan(sent)).value_or(0);
        if (const auto part = pair.called->read()) got.insert(got.end(), part->begin(), part->end());
        return got.size() >= bytes.size();
    }));
    EXPECT_EQ(got, bytes);
    EXPECT_TRUE(pair.called->read().has_value());
    pair.caller->finish();
    EXPECT_TRUE(within_5_s([&] { return !pair.called->read(); }));
    EXPECT_EQ(pair.called->problem(), "");
    // The other direction goes on.
    EXPECT_EQ(pair.called->send(Bytes(bytes).first(3)), 3u);
    EXPECT_TRUE(within_5_s([&] { return pair.caller->read().value_or(Bytes()).size() == 3; }));
}

TEST(Tcp, a_connection_that_does_not_come_about_says_why) {
    const std::uint16_t port = must(TcpListener::open(kLoopback, 0))->port(); // closed again
    const auto stream = TcpStream::connect(kLoopback, port);
    if (!stream.ok()) return; // said at once
    EXPECT_TRUE(within_5_s([&] { return !(*stream)->read(); }));
    EXPECT_NE((*stream)->problem(), "");
}

TEST(Tcp, a_port_belongs_to_one_listener) {
    const auto listener = must(TcpListener::open(kLoopback, 0));
    EXPECT_FALSE(TcpListener::open(kLoopback, listener->port()).ok());
}

TEST(Tcp, waiting_ends_when_something_comes_or_somebody_calls) {
    Pair pair;
    ASSERT_NE(pair.called, nullptr);
    const auto wake = must(StreamWake::open());
    const std::array<WaitFor, 3> all{{{pair.called->handle()}, {wake->handle()}, {-1}}};
    const auto waited = [&](std::chrono::milliseconds most) {
        const auto begin = std::chrono::steady_clock::now();
        wait_for_streams(all, most);
        return std::chrono::steady_clock::now() - begin;
    };
    EXPECT_GE(waited(50ms), 40ms);
    wake->raise();
    wake->raise();
    EXPECT_LT(waited(5s), 4s);
    wake->clear();
    EXPECT_GE(waited(50ms), 40ms);
    std::jthread other([&] {
        std::this_thread::sleep_for(20ms);
        wake->raise();
    });
    EXPECT_LT(waited(5s), 4s);
    wake->clear();
    const std::uint8_t byte = 1;
    pair.caller->send({&byte, 1});
    EXPECT_LT(waited(5s), 4s);
    EXPECT_EQ(pair.called->read().value_or(Bytes()).size(), 1u);
    const std::array<WaitFor, 1> to_send{{{pair.caller->handle(), true}}};
    const auto begin = std::chrono::steady_clock::now();
    wait_for_streams(to_send, 5s);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 4s);
}

} // namespace
} // namespace ghost::dmx
