// SPDX-License-Identifier: Apache-2.0
// Many at once: who opens the page, who holds places without a word, and who shares a small ration.
#include "server_peer.h"

#include <array>
#include <atomic>
#include <netinet/in.h>
#include <unistd.h>

namespace ghost::web {
namespace {

constexpr std::size_t kMostIn = kMostViewers + kMostOthers;

// A connection from an address of this machine that says nothing.
class Silent {
public:
    Silent(std::uint32_t from, std::uint16_t port) : handle_(::socket(AF_INET, SOCK_STREAM, 0)) {
        const auto name = [](std::uint32_t address, std::uint16_t at) {
            sockaddr_in in{};
            in.sin_family = AF_INET;
            in.sin_port = htons(at);
            in.sin_addr.s_addr = htonl(address);
            return in;
        };
        const sockaddr_in own = name(from, 0), other = name(0x7F000001, port);
        is_in_ = ::bind(handle_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0 &&
                 ::connect(handle_, reinterpret_cast<const sockaddr*>(&other), sizeof other) == 0;
    }
    ~Silent() { ::close(handle_); }
    Silent(const Silent&) = delete;
    Silent& operator=(const Silent&) = delete;

    bool is_in() const { return is_in_; }
    // What was said to it so far.
    std::string text() const {
        std::array<char, 4096> bytes{};
        const ssize_t came = ::recv(handle_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_PEEK);
        return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(came, 0))};
    }
    bool is_refused() const { return text().starts_with("HTTP/1.1 503"); }

private:
    int handle_;
    bool is_in_ = false;
};

TEST(WebCrowd, a_small_ration_is_shared_evenly) {
    constexpr std::size_t kPeers = 6;
    ui::Link link;
    ServerOptions options;
    options.mbit = 0.1;
    const std::unique_ptr<Server> server = must(Server::open(link, options));
    std::vector<std::unique_ptr<Peer>> peers;
    for (std::size_t i = 0; i < kPeers; ++i) {
        peers.push_back(std::make_unique<Peer>(server->port()));
        ASSERT_EQ(peers.back()->look_on(server->keys().token), 101);
    }
    std::atomic<bool> ends = false;
    std::thread engine([&] {
        for (std::uint8_t level = 0; !ends; level = static_cast<std::uint8_t>(level + 7)) {
            image::Image8 image(64, 32, 4);
            std::fill(image.samples.begin(), image.samples.end(), level);
            ui::Picture picture;
            picture.image = std::make_shared<const image::Image8>(std::move(image));
            link.picture.put(std::move(picture));
            server->news();
            std::this_thread::sleep_for(20ms);
        }
    });
    std::array<int, kPeers> seen{};
    for (const auto end = Clock::now() + 8s; Clock::now() < end;)
        for (std::size_t i = 0; i < kPeers; ++i) {
            const Buffer picture = peers[i]->hear_bytes(1, 1ms);
            if (picture.empty()) continue;
            peers[i]->paint(number_of(picture));
            ++seen[i];
        }
    ends = true;
    engine.join();
    const auto [least, most] = std::minmax_element(seen.begin(), seen.end());
    EXPECT_GE(*least, 8);
    EXPECT_GE(*least, 0.8 * *most) << testing::PrintToString(seen);
}

TEST_F(WebServer, all_who_open_the_page_at_once_get_it) {
    constexpr std::size_t kConnections = 20 * 6; // of twenty browsers
    const std::string request =
        "GET /a/stage.js HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) + "\r\n\r\n";
    std::vector<std::unique_ptr<Peer>> peers;
    for (std::size_t i = 0; i < kConnections; ++i) {
        peers.push_back(std::make_unique<Peer>(server->port()));
        peers.back()->send(request);
    }
    std::size_t well = 0;
    for (auto& peer : peers) {
        well += peer->status() == 200;
        peer.reset();
    }
    EXPECT_EQ(well, kConnections);
}

TEST_F(WebServer, who_came_less_than_a_second_ago_keeps_his_place) {
    std::vector<std::unique_ptr<Peer>> idle;
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < kMostIn; ++i) idle.push_back(std::make_unique<Peer>(server->port()));
    EXPECT_EQ(Peer(server->port()).get("/"), 200) << "who comes waits until somebody has had his second";
    EXPECT_GE(Clock::now() - begin, 950ms);
}

TEST_F(WebServer, the_network_that_has_most_places_gives_one_up) {
    constexpr std::uint32_t kFlood = 0x7F000101, kOther = 0x7F000201; // 127.0.1.1 and so on, 127.0.2.1
    std::vector<std::unique_ptr<Silent>> others, flood;
    for (int i = 0; i < 2; ++i) others.push_back(std::make_unique<Silent>(kOther, server->port()));
    for (std::uint32_t i = 0; i + others.size() < kMostIn; ++i)
        flood.push_back(std::make_unique<Silent>(kFlood + i, server->port()));
    for (const auto& one : others) ASSERT_TRUE(one->is_in());
    for (const auto& one : flood) ASSERT_TRUE(one->is_in());
    std::this_thread::sleep_for(1200ms);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(Peer(server->port()).get("/"), 200);
    for (const auto& one : others) EXPECT_FALSE(one->is_refused());
    EXPECT_TRUE(flood.front()->is_refused()) << "the oldest of the network that has most";
}

} // namespace
} // namespace ghost::web
