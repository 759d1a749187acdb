// SPDX-License-Identifier: Apache-2.0
// On the loopback interface, on ports of its own.
#include "live/engine/desk_listener.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ghost::app {
namespace {

// Whoever has a port and does not share it.
class Taken {
public:
    explicit Taken(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        is_bound_ = ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~Taken() { ::close(socket_); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;
    bool is_bound() const { return is_bound_; }

private:
    int socket_;
    bool is_bound_ = false;
};

dmx::ReceiverOptions on_loopback() {
    dmx::ReceiverOptions options;
    options.interface = "127.0.0.1";
    options.sacn_port = static_cast<std::uint16_t>(20000 + (getpid() % 10000) * 2);
    options.artnet_port = static_cast<std::uint16_t>(options.sacn_port + 1);
    options.answer_polls = false;
    return options;
}

TEST(DeskListener, a_port_that_is_taken_is_said_and_tried_again) {
    ui::Link link;
    link.on_news = [] {};
    DeskRecorder recorder(link);
    MessageBoard messages(link);
    const dmx::ReceiverOptions options = on_loopback();
    DeskListener desk(options, recorder, messages, link);
    {
        const Taken taken(options.artnet_port);
        ASSERT_TRUE(taken.is_bound());
        EXPECT_FALSE(desk.listen(10));
        EXPECT_EQ(desk.receiver(), nullptr);
        const auto network = link.network.take();
        ASSERT_TRUE(network);
        EXPECT_NE(network->listening.problem.find(std::to_string(options.artnet_port)), std::string::npos);
        EXPECT_TRUE(messages.has_network());
    }
    EXPECT_FALSE(desk.listen(12)) << "too early";
    EXPECT_TRUE(desk.listen(14));
    EXPECT_NE(desk.receiver(), nullptr);
    EXPECT_FALSE(messages.has_network());
    EXPECT_FALSE(desk.listen(20)) << "it does already";
}

TEST(DeskListener, time_code_is_followed_where_it_is_asked_for) {
    ui::Link link;
    link.on_news = [] {};
    DeskRecorder recorder(link);
    MessageBoard messages(link);
    DeskListener desk(on_loopback(), recorder, messages, link);
    desk.follow({});
    EXPECT_EQ(desk.timecode(), nullptr);
    desk.follow({.begin = "01:00:00:00"});
    ASSERT_NE(desk.timecode(), nullptr);
    ASSERT_TRUE(desk.options().on_timecode);
    EXPECT_FALSE(desk.timecode()->at_s(100).has_value()) << "none was heard yet";
}

} // namespace
} // namespace ghost::app
