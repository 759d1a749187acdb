// SPDX-License-Identifier: Apache-2.0
// The server as a stateful peer sees it: pages, pictures, limits.
#include "server_peer.h"

#include <algorithm>

namespace ghost::web {
namespace {

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
    EXPECT_EQ(peer.text().find(server->keys().token), std::string::npos);
}

TEST_F(WebServer, a_picture_comes_acknowledged_ones_are_followed_and_no_others) {
    put_picture(64, 200);
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    EXPECT_EQ(peer.hear("hello")["right"], "view");
    const Buffer first = peer.hear_bytes(1);
    ASSERT_GT(first.size(), 32u);
    const auto image = image::decode_ldr(Bytes(first).subspan(32), "picture");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 64);
    EXPECT_EQ(image->height, 32);
    EXPECT_NEAR(image->at(20, 20)[0], 200, 4);
    EXPECT_LT(image->at(20, 20)[1], 6);
    EXPECT_TRUE(peer.hear_bytes(1, 500ms).empty()) << "who painted nothing yet gets one";
    peer.paint(number_of(first));
    // At rest it comes once more, with all its colours.
    const Buffer rest = peer.hear_bytes(1);
    ASSERT_GT(rest.size(), 32u);
    EXPECT_EQ(rest[1] & 4, 4);
    put_picture();
    put_picture(32);
    EXPECT_TRUE(peer.hear_bytes(1, 1s).empty()) << "one, or two, are on the way";
    peer.paint(number_of(rest));
    const Buffer newest = peer.hear_bytes(1);
    ASSERT_GT(newest.size(), 32u);
    EXPECT_EQ(newest[24], 32) << "the newest; what came meanwhile is skipped";
}

TEST_F(WebServer, pictures_that_come_slowly_are_not_at_rest) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    int came = 0, at_rest = 0;
    put_picture(64, 0); // nobody knows yet how fast others follow
    for (int i = 1; i <= 5; ++i) {
        std::this_thread::sleep_for(400ms);
        put_picture(64, static_cast<std::uint8_t>(40 * i));
        for (;;) {
            const Buffer picture = peer.hear_bytes(1, 10ms);
            if (picture.empty()) break;
            peer.paint(number_of(picture));
            ++came;
            at_rest += (picture[1] & 4) != 0;
        }
    }
    EXPECT_GE(came, 4);
    EXPECT_LE(at_rest, 1);
    EXPECT_EQ(peer.hear_bytes(1, 3s)[1] & 4, 4) << "the last one does rest";
}

TEST_F(WebServer, one_who_reads_nothing_holds_nobody_up) {
    Peer deaf(server->port()), quick(server->port());
    ASSERT_EQ(deaf.look_on(server->keys().token), 101);
    ASSERT_EQ(quick.look_on(server->keys().token), 101);
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
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
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

TEST_F(WebServer, folders_of_this_machine_are_told_nobody) {
    link.messages.put({{Severity::warning, "/srv/tour/band.mvr: scene.xml:7", "'/srv/tour/a.gdtf' is odd"}});
    server->news();
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    const auto said = peer.hear("messages")["messages"];
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0]["where"], "band.mvr: scene.xml:7");
    EXPECT_EQ(said[0]["what"], "'a.gdtf' is odd");
}

TEST_F(WebServer, what_is_malformed_ends_that_viewer_alone) {
    Peer good(server->port()), bad(server->port()), wide(server->port()), eager(server->port());
    for (Peer* peer : {&good, &bad, &wide, &eager}) ASSERT_EQ(peer->look_on(server->keys().token), 101);
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

TEST_F(WebServer, twenty_look_on_and_the_next_one_does_not) {
    std::vector<std::unique_ptr<Peer>> peers;
    for (std::size_t i = 0; i < kMostViewers; ++i) {
        peers.push_back(std::make_unique<Peer>(server->port()));
        ASSERT_EQ(peers.back()->look_on(server->keys().token), 101) << i;
    }
    Peer late(server->port());
    EXPECT_EQ(late.look_on(server->keys().token), 503);
    EXPECT_EQ(Peer(server->port()).get("/"), 200) << "the page still comes";
    peers.pop_back();
    int status = 503;
    for (int tries = 0; tries < 200 && status == 503; ++tries) {
        std::this_thread::sleep_for(20ms);
        status = Peer(server->port()).look_on(server->keys().token);
    }
    EXPECT_EQ(status, 101) << "one has left";
}

TEST_F(WebServer, connections_that_say_nothing_have_a_limit_and_an_end) {
    std::vector<std::unique_ptr<Peer>> idle;
    for (std::size_t i = 0; i < kMostViewers + kMostOthers; ++i) {
        idle.push_back(std::make_unique<Peer>(server->port()));
        idle.back()->send("GET");
    }
    std::this_thread::sleep_for(1200ms); // all are in, and had their second
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(Peer(server->port()).get("/"), 200) << "who asks is answered at once";
        std::this_thread::sleep_for(100ms);
    }
    // Each time the oldest left; who was answered did, too, so that it is one at least.
    EXPECT_EQ(idle.front()->status(), 503);
    EXPECT_TRUE(idle.front()->is_closed());
    for (auto& peer : idle) EXPECT_TRUE(peer->is_closed());
}

TEST_F(WebServer, a_flood_of_connections_puts_no_viewer_out) {
    Peer viewer(server->port());
    ASSERT_EQ(viewer.look_on(server->keys().token), 101);
    std::vector<std::unique_ptr<Peer>> flood;
    for (std::size_t i = 0; i < 3 * (kMostViewers + kMostOthers); ++i)
        flood.push_back(std::make_unique<Peer>(server->port()));
    EXPECT_EQ(Peer(server->port()).get("/"), 200);
    EXPECT_FALSE(viewer.is_closed(300ms));
}

TEST_F(WebServer, the_port_is_ours_alone) {
    ServerOptions same = options;
    same.port = server->port();
    const auto second = Server::open(link, same);
    ASSERT_FALSE(second.ok());
    EXPECT_NE(second.error().text().find(std::to_string(same.port)), std::string::npos);
}

TEST_F(WebServer, who_has_left_is_on_no_list) {
    {
        Peer peer(server->port());
        ASSERT_EQ(peer.look_on(server->keys().token), 101);
        ASSERT_FALSE(peer.hear("state").is_null());
        ASSERT_EQ(server->lookers().size(), 1u);
        EXPECT_EQ(server->lookers().front().from, "127.0.0.1");
        EXPECT_FALSE(server->lookers().front().controls);
    }
    for (int tries = 0; tries < 400 && !server->lookers().empty(); ++tries) std::this_thread::sleep_for(10ms);
    EXPECT_TRUE(server->lookers().empty());
}

TEST_F(WebServer, who_closes_his_half_is_gone) {
    Peer good(server->port()), viewer(server->port()), idle(server->port());
    ASSERT_EQ(good.look_on(server->keys().token), 101);
    ASSERT_EQ(viewer.look_on(server->keys().token), 101);
    viewer.close_half();
    EXPECT_TRUE(viewer.is_closed());
    idle.send("GET / HT");
    idle.close_half();
    EXPECT_TRUE(idle.is_closed(3s)) << "before the five seconds that a head has";
    for (int tries = 0; tries < 400 && server->lookers().size() != 1; ++tries)
        std::this_thread::sleep_for(10ms);
    EXPECT_EQ(server->lookers().size(), 1u);
    const double cpu_s = server->cpu_s();
    std::this_thread::sleep_for(1s);
    EXPECT_LT(server->cpu_s() - cpu_s, 0.5) << "nobody is waited for without a rest";
}

TEST_F(WebServer, ten_thousand_lamps_with_endless_names_come_whole) {
    constexpr std::size_t kLamps = 10'000, kLongNames = 500, kLetters = 10'000;
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    auto show = std::make_shared<scene::Show>();
    show->fixtures.resize(kLamps);
    for (std::size_t i = 0; i < kLongNames; ++i) show->fixtures[i].name = std::string(kLetters, 'Z');
    ui::Opened opened;
    opened.show = show;
    link.opened.put(opened);
    server->news();
    Peer::Frame frame;
    do frame = peer.frame();
    while (frame.opcode != 0 && frame.opcode != 8 && frame.payload.size() < kLongNames * kLetters);
    ASSERT_EQ(frame.opcode, 1);
    EXPECT_EQ(std::count(frame.payload.begin(), frame.payload.end(), 'Z'),
              static_cast<std::ptrdiff_t>(kLongNames * kLetters));
    put_picture();
    EXPECT_FALSE(peer.hear_bytes(1).empty()) << "and the line goes on";
}

TEST_F(WebServer, ends_with_viewers_in_it) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    server.reset();
    EXPECT_TRUE(peer.is_closed());
}

TEST(WebSilence, who_says_nothing_is_gone_after_a_time) {
    ui::Link link;
    ServerOptions options;
    EXPECT_EQ(options.silence_s, 120);
    options.silence_s = 6;
    auto opened = Server::open(link, options);
    ASSERT_TRUE(opened.ok());
    const std::unique_ptr<Server> server = std::move(*opened);
    Peer silent(server->port()), alive(server->port());
    for (Peer* peer : {&silent, &alive}) ASSERT_EQ(peer->look_on(server->keys().token), 101);
    const auto begin = Clock::now();
    EXPECT_FALSE(silent.is_closed(1ms));
    while (Clock::now() < begin + 9s) {
        alive.say(Opcode::pong, {});
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_EQ(silent.close_code(), kCloseGoingAway);
    EXPECT_FALSE(alive.is_closed(1ms));
}

} // namespace
} // namespace ghost::web
