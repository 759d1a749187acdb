// SPDX-License-Identifier: Apache-2.0
// Who may control, and who may look on: tokens that are allowed, renewed and taken back.
#include "server_peer.h"

namespace ghost::web {
namespace {

class WebControl : public WebServer {
protected:
    WebControl() {
        server->allow_control(true);
        open_show(2);
        scene::StoredLook look;
        look.name = "Verse";
        link.looks.put({std::make_shared<const std::vector<scene::StoredLook>>(1, look), ""});
        server->news();
    }
    // What the engine gets; without its number.
    std::optional<ui::Command> command(Clock::duration time = kLong) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            const auto came = link.commands.take();
            if (!came.empty()) return came.front();
            std::this_thread::sleep_for(5ms);
        }
        return std::nullopt;
    }
};

TEST_F(WebControl, who_may_is_obeyed_and_answered) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().control_token), 101);
    EXPECT_EQ(peer.hear("hello")["right"], "control");
    EXPECT_EQ(peer.hear("looks")["looks"][0]["name"], "Verse");
    peer.say(R"({"type":"do","n":9,"what":"look","args":["Verse",3]})");
    const auto asked = command();
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->what, "look");
    EXPECT_EQ(std::get<double>(asked->arguments.at(1)), 3);
    ASSERT_TRUE(link.command_answers.put({asked->number, ""}));
    server->news();
    EXPECT_EQ(peer.hear("done")["n"], 9);
    peer.say(R"({"type":"do","n":10,"what":"nothing","args":[]})");
    const auto wrong = command();
    ASSERT_TRUE(wrong);
    ASSERT_TRUE(link.command_answers.put({wrong->number, "is no address of ours"}));
    ASSERT_TRUE(link.command_answers.put({wrong->number + 100, "of nobody"}));
    server->news();
    EXPECT_EQ(peer.hear("refused")["why"], "is no address of ours");
    peer.say(R"({"type":"do","n":11,"what":"look","args":["Chorus"]})");
    EXPECT_EQ(peer.hear("refused")["why"], "the show has no such look");
    EXPECT_FALSE(command(100ms)) << "it was not asked for";
}

TEST_F(WebControl, who_may_not_is_not_read) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    peer.say(R"({"type":"do","n":9,"what":"blackout","args":[1]})");
    peer.say(R"({"type":"do","n":"rubbish"})");
    peer.say(R"({"type":"ping","t":7})");
    EXPECT_EQ(peer.hear("pong")["t"], 7) << "it goes on";
    EXPECT_TRUE(link.commands.take().empty());
}

TEST_F(WebControl, the_right_ends_with_the_token) {
    Peer peer(server->port());
    const std::string before = server->keys().control_token;
    ASSERT_EQ(peer.look_on(before), 101);
    EXPECT_EQ(peer.hear("hello")["right"], "control");
    server->allow_control(false);
    EXPECT_EQ(peer.hear("hello")["right"], "view");
    peer.say(R"({"type":"do","n":9,"what":"blackout","args":[1]})");
    peer.say(R"({"type":"ping","t":7})");
    EXPECT_EQ(peer.hear("pong")["t"], 7);
    EXPECT_TRUE(link.commands.take().empty());
    for (const bool allowed : {false, true}) {
        server->allow_control(allowed);
        EXPECT_NE(server->keys().control_token, before);
        Peer again(server->port()); // after a reload, or a lost line
        ASSERT_EQ(again.look_on(before), 101);
        EXPECT_EQ(again.hear("hello")["right"], "view");
    }
    server->renew_token();
    EXPECT_EQ(Peer(server->port()).look_on(before), 401);
}

TEST_F(WebControl, more_than_fits_is_refused_and_nothing_waits) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().control_token), 101);
    for (std::size_t n = 1; n <= ui::kMostCommands + 1; ++n) {
        if (n % 40 == 0) { // 60 messages a second, counted when they are read
            peer.say(R"({"type":"ping","t":7})");
            EXPECT_EQ(peer.hear("pong")["t"], 7);
            std::this_thread::sleep_for(1100ms);
        }
        peer.say(R"({"type":"do","n":)" + std::to_string(n) + R"(,"what":"haze","args":[1]})");
    }
    const auto refused = peer.hear("refused");
    EXPECT_EQ(refused["n"], ui::kMostCommands + 1);
    EXPECT_EQ(link.commands.take().size(), ui::kMostCommands);
}

TEST_F(WebServer, all_are_sent_away_and_no_address_that_was_lets_in) {
    Peer peer(server->port());
    const std::string before = server->keys().token;
    ASSERT_EQ(peer.look_on(before), 101);
    const std::string digits = server->keys().digits;
    ASSERT_EQ(digits.size(), 6u);
    server->send_all_away();
    EXPECT_EQ(server->keys().digits, "");
    EXPECT_EQ(Peer(server->port()).pair(digits), 401);
    EXPECT_FALSE(peer.hear("bye").is_null());
    EXPECT_TRUE(peer.is_closed());
    EXPECT_EQ(Peer(server->port()).look_on(before), 401);
    EXPECT_EQ(Peer(server->port()).look_on(server->keys().token), 101);
}

TEST_F(WebServer, digits_let_one_in) {
    const std::string digits = server->keys().digits;
    EXPECT_EQ(Peer(server->port()).pair(digits), 200);
    EXPECT_EQ(Peer(server->port()).pair(digits), 401);
}

TEST_F(WebControl, a_new_token_leaves_who_is_in) {
    Peer peer(server->port()), other(server->port());
    const Keys before = server->keys();
    ASSERT_EQ(peer.look_on(before.token), 101);
    ASSERT_EQ(other.look_on(before.control_token), 101);
    server->renew_token();
    EXPECT_EQ(Peer(server->port()).look_on(before.token), 401);
    EXPECT_EQ(Peer(server->port()).look_on(before.control_token), 401);
    EXPECT_EQ(Peer(server->port()).look_on(server->keys().control_token), 101);
    EXPECT_EQ(Peer(server->port()).pair(before.digits), 401);
    peer.say(R"({"type":"ping","t":7})");
    EXPECT_EQ(peer.hear("pong")["t"], 7);
    other.say(R"({"type":"do","n":1,"what":"haze","args":[1]})");
    EXPECT_TRUE(command()) << "he still controls";
    server->show_digits(false);
    EXPECT_EQ(server->keys().digits, "");
    server->show_digits(true);
    EXPECT_EQ(server->keys().digits.size(), 6u);
}

} // namespace
} // namespace ghost::web
