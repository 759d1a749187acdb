// SPDX-License-Identifier: Apache-2.0
// The server as a stateful peer: over loopback, with news that the test puts in the place of an engine.
#include "image/ldr.h"
#include "json_xml_toml/json.h"
#include "show/show.h"
#include "web/server.h"
#include "web/websocket.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <thread>

namespace ghost::web {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Buffer = std::vector<std::uint8_t>;

constexpr auto kLong = 20s; // for what a busy machine may take

// A browser, or somebody who is none.
class Peer {
public:
    explicit Peer(std::uint16_t port) : port_(port) {
        auto stream = dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), port);
        EXPECT_TRUE(stream.ok());
        stream_ = std::move(*stream);
    }

    void send(Bytes bytes) {
        for (const auto until = Clock::now() + kLong; !bytes.empty() && Clock::now() < until;) {
            const auto sent = stream_->send(bytes);
            if (!sent) return;
            bytes = bytes.subspan(*sent);
            if (*sent == 0) std::this_thread::sleep_for(1ms);
        }
    }
    void send(const std::string& text) {
        send(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }

    // Reads until it holds. False: it was closed, or never held.
    bool until(const std::function<bool()>& holds, Clock::duration time = kLong) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            if (holds()) return true;
            if (is_closed_) return false;
            const dmx::WaitFor wait{stream_->handle()};
            dmx::wait_for_streams({&wait, 1}, 20ms);
            if (const auto came = stream_->read())
                in_.insert(in_.end(), came->begin(), came->end());
            else
                is_closed_ = true;
        }
        return holds();
    }
    bool is_closed(Clock::duration time = kLong) {
        return until([&] { return is_closed_; }, time);
    }

    // Of an answer; 0: none came.
    int status() {
        until([&] { return std::string(in_.begin(), in_.end()).find("\r\n\r\n") != std::string::npos; });
        const std::string text(in_.begin(), in_.end());
        return text.size() > 12 && text.starts_with("HTTP/1.1 ") ? std::stoi(text.substr(9, 3)) : 0;
    }
    std::string text() const { return {in_.begin(), in_.end()}; }

    int get(const std::string& target) {
        send("GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n\r\n");
        return status();
    }

    // Becomes a viewer. Returns the status.
    int look_on(const std::string& token) {
        const std::string host = "127.0.0.1:" + std::to_string(port_);
        send("GET /live HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
             "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: ghostlight.1, t." +
             token + "\r\n\r\n");
        const int code = status();
        const std::string all = text();
        if (code == 101)
            in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(all.find("\r\n\r\n") + 4));
        return code;
    }

    void say(Opcode opcode, const Buffer& payload) {
        Buffer frame{static_cast<std::uint8_t>(0x80 | static_cast<int>(opcode)),
                     static_cast<std::uint8_t>(0x80 | payload.size()),
                     0,
                     0,
                     0,
                     0};
        ASSERT_LT(payload.size(), 126u);
        frame.insert(frame.end(), payload.begin(), payload.end());
        send(frame);
    }
    void say(const std::string& text) { say(Opcode::text, Buffer(text.begin(), text.end())); }
    void paint(std::uint32_t number) {
        say(Opcode::binary,
            {1, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8), 0, 0});
    }

    struct Frame {
        int opcode = 0; // 0: none came
        Buffer payload;
    };
    Frame frame(Clock::duration time = kLong) {
        Frame frame;
        const auto size_at = [&]() -> std::pair<std::size_t, std::size_t> { // of the head, of the payload
            if (in_.size() < 2) return {SIZE_MAX, 0};
            const std::size_t bytes = in_[1] < 126 ? 0 : in_[1] == 126 ? 2 : 8;
            if (in_.size() < 2 + bytes) return {SIZE_MAX, 0};
            std::size_t size = bytes == 0 ? in_[1] : 0;
            for (std::size_t i = 0; i < bytes; ++i) size = size << 8 | in_[2 + i];
            return {2 + bytes, size};
        };
        const auto is_whole = [&] {
            const auto [head, size] = size_at();
            return head != SIZE_MAX && in_.size() >= head + size;
        };
        if (!until(is_whole, time) && !is_whole()) return frame;
        const auto [head, size] = size_at();
        frame.opcode = in_[0] & 15;
        const auto begin = in_.begin() + static_cast<std::ptrdiff_t>(head),
                   end = begin + static_cast<std::ptrdiff_t>(size);
        frame.payload.assign(begin, end);
        in_.erase(in_.begin(), end);
        return frame;
    }
    // The next text of that type; null: none came.
    nlohmann::json hear(const std::string& type) {
        for (const auto end = Clock::now() + kLong; Clock::now() < end;) {
            const Frame next = frame();
            if (next.opcode == 0 || next.opcode == 8) return nullptr;
            if (next.opcode != 1) continue;
            auto json = read_json(std::string(next.payload.begin(), next.payload.end()), "frame");
            if (json.ok() && (*json)["type"] == type) return *json;
        }
        return nullptr;
    }
    // The next message of bytes of that kind; empty: none came.
    Buffer hear_bytes(std::uint8_t kind, Clock::duration time = kLong) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            const Frame next = frame(end - Clock::now());
            if (next.opcode == 0 || next.opcode == 8) return {};
            if (next.opcode == 2 && !next.payload.empty() && next.payload[0] == kind) return next.payload;
        }
        return {};
    }
    // Status of the frame that closes; 0: none came.
    int close_code() {
        for (;;) {
            const Frame next = frame();
            if (next.opcode == 0) return 0;
            if (next.opcode == 8) return next.payload[0] << 8 | next.payload[1];
        }
    }

private:
    std::uint16_t port_;
    std::unique_ptr<dmx::TcpStream> stream_;
    Buffer in_;
    bool is_closed_ = false;
};

std::uint32_t number_of(const Buffer& picture) {
    return picture.size() < 32 ? 0
                               : static_cast<std::uint32_t>(picture[4] | picture[5] << 8 | picture[6] << 16);
}

class WebServer : public ::testing::Test {
protected:
    WebServer() {
        auto opened = Server::open(link, options);
        EXPECT_TRUE(opened.ok());
        server = std::move(*opened);
    }

    void open_show(std::size_t fixtures) {
        auto show = std::make_shared<scene::Show>();
        show->name = "tour";
        show->fixtures.resize(fixtures);
        ui::Opened opened;
        opened.show = show;
        link.opened.put(opened);
        server->news();
    }
    void put_picture(int width = 64, std::uint8_t red = 200) {
        image::Image8 image(width, width / 2, 4);
        for (std::size_t i = 0; i < image.samples.size(); i += 4) image.samples[i] = red;
        ui::Picture picture;
        picture.image = std::make_shared<const image::Image8>(std::move(image));
        link.picture.put(std::move(picture));
        server->news();
    }

    ui::Link link;
    ServerOptions options;
    std::unique_ptr<Server> server;
};

TEST_F(WebServer, the_page_comes_and_the_connection_ends) {
    Peer peer(server->port());
    EXPECT_EQ(peer.get("/"), 200);
    EXPECT_TRUE(peer.is_closed());
    EXPECT_NE(peer.text().find("<!DOCTYPE html>"), std::string::npos);
    EXPECT_EQ(Peer(server->port()).get("/nothing"), 404);
}

TEST_F(WebServer, a_head_in_single_bytes_is_understood_and_rubbish_is_refused) {
    Peer slow(server->port());
    for (const char c : "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) + "\r\n\r\n")
        slow.send(std::string(1, c));
    EXPECT_EQ(slow.status(), 200);
    Peer rubbish(server->port());
    rubbish.send("\x16\x03\x01\x02 TLS\n\r\n\r\n");
    EXPECT_EQ(rubbish.status(), 400);
    EXPECT_TRUE(rubbish.is_closed());
    Peer endless(server->port());
    endless.send("GET / HTTP/1.1\r\nA: " + std::string(200'000, 'a'));
    EXPECT_EQ(endless.status(), 431);
}

TEST_F(WebServer, a_head_that_does_not_end_has_five_seconds) {
    Peer peer(server->port());
    peer.send("GET / HTTP/1.1\r\nHo");
    const auto begin = Clock::now();
    EXPECT_EQ(peer.status(), 408);
    EXPECT_TRUE(peer.is_closed());
    EXPECT_GT(Clock::now() - begin, 4s);
}

TEST_F(WebServer, a_wrong_token_sees_nothing) {
    put_picture();
    Peer peer(server->port());
    EXPECT_EQ(peer.look_on(std::string(32, '0')), 401);
    EXPECT_TRUE(peer.is_closed());
    EXPECT_EQ(peer.text().find(server->token()), std::string::npos);
}

TEST_F(WebServer, a_picture_comes_acknowledged_ones_are_followed_and_no_others) {
    put_picture(64, 200);
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->token()), 101);
    EXPECT_EQ(peer.hear("hello")["right"], "view");
    const Buffer first = peer.hear_bytes(1);
    ASSERT_GT(first.size(), 32u);
    const auto image = image::decode_ldr(Bytes(first).subspan(32), "picture");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 64);
    EXPECT_EQ(image->height, 32);
    EXPECT_NEAR(image->at(20, 20)[0], 200, 4);
    EXPECT_LT(image->at(20, 20)[1], 6);
    // At rest it comes once more, with all its colours: the second one, and the last before one is painted.
    const Buffer rest = peer.hear_bytes(1);
    ASSERT_GT(rest.size(), 32u);
    EXPECT_EQ(rest[1] & 4, 4);
    put_picture();
    put_picture(32);
    EXPECT_TRUE(peer.hear_bytes(1, 1s).empty()) << "two are on the way";
    peer.paint(number_of(rest));
    const Buffer newest = peer.hear_bytes(1);
    ASSERT_GT(newest.size(), 32u);
    EXPECT_EQ(newest[24], 32) << "the newest; what came meanwhile is skipped";
}

TEST_F(WebServer, one_who_reads_nothing_holds_nobody_up) {
    Peer deaf(server->port()), quick(server->port());
    ASSERT_EQ(deaf.look_on(server->token()), 101);
    ASSERT_EQ(quick.look_on(server->token()), 101);
    int seen = 0;
    for (int i = 0; i < 40; ++i) {
        put_picture(640, static_cast<std::uint8_t>(i));
        const Buffer picture = quick.hear_bytes(1, 2s);
        if (picture.empty()) break;
        quick.paint(number_of(picture));
        ++seen;
    }
    EXPECT_GE(seen, 40);
}

TEST_F(WebServer, the_show_levels_and_an_explanation_come) {
    open_show(3);
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->token()), 101);
    EXPECT_EQ(peer.hear("show")["fixtures"].size(), 3u);
    peer.say(R"({"type":"levels","on":true})");
    peer.say(R"({"type":"ping","t":7})");
    EXPECT_EQ(peer.hear("pong")["t"], 7);
    Buffer levels;
    for (int tries = 0; tries < 100 && levels.empty(); ++tries) { // the engine goes on saying
        ui::RigNow rig;
        rig.fixtures.resize(3);
        link.rig.put(rig);
        server->news();
        levels = peer.hear_bytes(2, 200ms);
    }
    EXPECT_EQ(levels.size(), 16u + 3 * 8);
    peer.say(R"({"type":"explain","fixture":2})");
    std::optional<std::size_t> asked;
    for (int tries = 0; tries < 500 && !asked; ++tries) {
        asked = link.question.take();
        std::this_thread::sleep_for(10ms);
    }
    ASSERT_EQ(asked, 2u);
    ui::Explained explained;
    explained.fixture = 2;
    explained.words = "dark because the test says so";
    link.answer.put(explained);
    server->news();
    EXPECT_EQ(peer.hear("explained")["words"], "dark because the test says so");
    peer.say(R"({"type":"explain","fixture":3})");
    EXPECT_EQ(peer.hear("explained")["verdict"], "the show has no such fixture");
}

TEST_F(WebServer, what_is_malformed_ends_that_viewer_alone) {
    Peer good(server->port()), bad(server->port()), wide(server->port()), eager(server->port());
    for (Peer* peer : {&good, &bad, &wide, &eager}) ASSERT_EQ(peer->look_on(server->token()), 101);
    bad.say("{]");
    EXPECT_EQ(bad.close_code(), kClosePolicy);
    EXPECT_TRUE(bad.is_closed());
    wide.send(Buffer{0x81, 0xFF, 0, 0, 0, 1, 0, 0, 0, 0});
    EXPECT_EQ(wide.close_code(), kCloseTooBig);
    for (int i = 0; i < 200; ++i) eager.say(R"({"type":"ping","t":1})");
    EXPECT_EQ(eager.close_code(), kClosePolicy);
    good.say(Opcode::ping, {1, 2, 3});
    Peer::Frame frame;
    do frame = good.frame();
    while (frame.opcode != 10 && frame.opcode != 0 && frame.opcode != 8);
    EXPECT_EQ(frame.payload, (Buffer{1, 2, 3}));
    good.say(Opcode::close, {});
    EXPECT_EQ(good.close_code(), 1000);
    EXPECT_TRUE(good.is_closed());
}

TEST_F(WebServer, sixteen_look_on_and_the_seventeenth_does_not) {
    std::vector<std::unique_ptr<Peer>> peers;
    for (int i = 0; i < kMostViewers; ++i) {
        peers.push_back(std::make_unique<Peer>(server->port()));
        ASSERT_EQ(peers.back()->look_on(server->token()), 101) << i;
    }
    Peer late(server->port());
    EXPECT_EQ(late.look_on(server->token()), 503);
    EXPECT_EQ(Peer(server->port()).get("/"), 200) << "the page still comes";
    peers.pop_back();
    int status = 503;
    for (int tries = 0; tries < 200 && status == 503; ++tries) {
        std::this_thread::sleep_for(20ms);
        status = Peer(server->port()).look_on(server->token());
    }
    EXPECT_EQ(status, 101) << "one has left";
}

TEST_F(WebServer, connections_that_say_nothing_have_a_limit_and_an_end) {
    std::vector<std::unique_ptr<Peer>> idle;
    for (std::size_t i = 0; i < kMostConnections; ++i) {
        idle.push_back(std::make_unique<Peer>(server->port()));
        idle.back()->send("GET");
    }
    std::this_thread::sleep_for(1s); // all are in
    Peer late(server->port());
    EXPECT_TRUE(late.is_closed(3s));
    for (auto& peer : idle) EXPECT_TRUE(peer->is_closed());
    int status = 503;
    for (int tries = 0; tries < 100 && status == 503; ++tries) { // they are waited for a moment, to read why
        std::this_thread::sleep_for(100ms);
        status = Peer(server->port()).get("/");
    }
    EXPECT_EQ(status, 200);
}

TEST_F(WebServer, the_port_is_ours_alone) {
    ServerOptions same = options;
    same.port = server->port();
    const auto second = Server::open(link, same);
    ASSERT_FALSE(second.ok());
    EXPECT_NE(second.error().text().find(std::to_string(same.port)), std::string::npos);
}

TEST_F(WebServer, ends_with_viewers_in_it) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->token()), 101);
    server.reset();
    EXPECT_TRUE(peer.is_closed());
}

} // namespace
} // namespace ghost::web
