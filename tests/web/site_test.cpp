// SPDX-License-Identifier: Apache-2.0
#include "web/private/files.h"
#include "web/site.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";

class Site : public ::testing::Test {
protected:
    Access access{{{"127.0.0.1"}, 8010, ""}, kToken, Pairing("123456", 0)};
    std::string host = "127.0.0.1:8010", origin = "http://127.0.0.1:8010",
                protocols = "ghostlight.1, t." + kToken;

    Routed ask(const std::string& method, const std::string& target, const std::string& fields = {},
               const std::string& body = {}) {
        const ParsedHead parsed =
            parse_head(method + " " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + fields + "\r\n");
        EXPECT_EQ(parsed.status, 200);
        return route(parsed.head, body, access, 1);
    }
    int get(const std::string& target) { return ask("GET", target).answer.status; }
    Routed live(const std::string& fields = {}) {
        return ask("GET", "/live",
                   "Upgrade: websocket\r\nConnection: keep-alive, Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: " +
                       protocols + "\r\n" + (origin.empty() ? "" : "Origin: " + origin + "\r\n") + fields);
    }
    int pair(const std::string& body, const std::string& type = "application/json") {
        return ask("POST", "/pair",
                   (origin.empty() ? "" : "Origin: " + origin + "\r\n") + "Content-Type: " + type + "\r\n",
                   body)
            .answer.status;
    }
};

TEST_F(Site, the_page_is_there_without_a_token_and_has_no_secret) {
    EXPECT_EQ(get("/"), 200);
    ASSERT_GE(web_files().size(), 5u);
    for (const WebFile& file : web_files()) {
        EXPECT_EQ(get("/a/" + std::string(file.name)), 200) << file.name;
        EXPECT_EQ(file.bytes.find(kToken), std::string_view::npos);
    }
    EXPECT_EQ(ask("GET", "/a/main.js").answer.type, "text/javascript; charset=utf-8");
    EXPECT_TRUE(ask("GET", "/").answer.body.starts_with("<!DOCTYPE html>"));
}

// Else a module is asked for only when the one that needs it has come.
TEST_F(Site, the_page_names_every_module_at_once) {
    const std::string_view page = ask("GET", "/").answer.body;
    for (const WebFile& file : web_files()) {
        if (!file.name.ends_with(".js")) continue;
        EXPECT_NE(page.find("/a/" + std::string(file.name)), std::string_view::npos) << file.name;
    }
}

TEST_F(Site, nothing_else_is_there) {
    for (const char* target : {"/a/", "/a/../main.js", "/a/%2e%2e/show.toml", "/a/..%2fmain.js",
                               "/../etc/passwd", "/a//etc/passwd", "/a/main.js?x", "/main.js", "/A/main.js",
                               "/a/main.js/", "/live/", "/favicon.ico"})
        EXPECT_EQ(get(target), 404) << target;
    for (const char* method : {"HEAD", "OPTIONS", "PUT", "DELETE", "CONNECT", "get"})
        EXPECT_EQ(ask(method, "/").answer.status, 405) << method;
    EXPECT_EQ(ask("POST", "/").answer.status, 405);
    EXPECT_EQ(ask("POST", "/live").answer.status, 405);
    EXPECT_EQ(get("/pair"), 405);
}

TEST_F(Site, another_name_than_ours_gets_nothing) {
    host = "rebound.example:8010";
    origin = "http://rebound.example:8010";
    EXPECT_EQ(get("/"), 421);
    EXPECT_EQ(get("/a/main.js"), 421);
    EXPECT_EQ(live().answer.status, 421);
    EXPECT_EQ(pair(R"({"code":"123456"})"), 421);
}

TEST_F(Site, the_right_token_opens_the_live_line) {
    const Routed routed = live();
    EXPECT_TRUE(routed.is_live);
    const std::string text = answer_text(routed.answer);
    EXPECT_TRUE(text.starts_with("HTTP/1.1 101 "));
    EXPECT_NE(text.find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"), std::string::npos);
    EXPECT_NE(text.find("Sec-WebSocket-Protocol: ghostlight.1\r\n"), std::string::npos);
    EXPECT_EQ(text.find(kToken), std::string::npos);
}

TEST_F(Site, a_wrong_token_does_not) {
    for (const std::string& wrong : std::initializer_list<std::string>{
             "ghostlight.1", "ghostlight.1, t.", "ghostlight.1, t." + kToken.substr(1),
             "ghostlight.1, t." + kToken + "0", "ghostlight.1, t.1" + kToken.substr(1),
             "ghostlight.1, " + kToken, "ghostlight.2, t." + kToken, "t." + kToken,
             "ghostlight.1, t." + std::string(4000, 'a')}) {
        protocols = wrong;
        const Routed routed = live();
        EXPECT_EQ(routed.answer.status, 401) << wrong;
        EXPECT_FALSE(routed.is_live);
    }
}

TEST_F(Site, a_foreign_page_with_the_right_token_does_not_either) {
    for (const char* foreign : {"", "null", "http://127.0.0.1:8011", "https://evil.example"}) {
        origin = foreign;
        EXPECT_EQ(live().answer.status, 403) << foreign;
        EXPECT_EQ(pair(R"({"code":"123456"})"), 403) << foreign;
    }
}

TEST_F(Site, the_live_line_is_a_websocket_alone) {
    const auto with = [&](const std::string& fields) {
        return ask("GET", "/live",
                   "Origin: " + origin + "\r\nSec-WebSocket-Protocol: " + protocols + "\r\n" + fields)
            .answer.status;
    };
    EXPECT_EQ(with(""), 426);
    EXPECT_EQ(with("Upgrade: h2c\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"), 426);
    EXPECT_EQ(with("Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 8\r\n"), 426);
    EXPECT_EQ(with("Upgrade: websocket\r\nConnection: close\r\nSec-WebSocket-Version: 13\r\n"), 426);
    EXPECT_EQ(with("Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: "
                   "13\r\nSec-WebSocket-Key: short\r\n"),
              400);
}

TEST_F(Site, six_digits_become_a_token) {
    const Routed routed =
        ask("POST", "/pair", "Origin: " + origin + "\r\nContent-Type: application/json; charset=utf-8\r\n",
            R"({"code":"123456"})");
    EXPECT_EQ(routed.answer.status, 200);
    EXPECT_EQ(routed.answer.text, R"({"right":"view","token":")" + kToken + R"("})");
    EXPECT_EQ(pair(R"({"code":"123456"})", "text/plain"), 415);
    for (const char* bad :
         {"", "{", "[]", "{}", R"({"code":123456})", R"({"code":"1","code":"2"})", R"({"a":{"b":{"c":1}}})"})
        EXPECT_EQ(pair(bad), 400) << bad;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(pair(R"({"code":"654321"})"), 401);
    EXPECT_EQ(pair(R"({"code":"123456"})"), 401) << "the sixth try";
}

TEST_F(Site, a_page_may_ask_whether_its_token_holds) {
    EXPECT_EQ(ask("GET", "/right", "Authorization: Bearer " + kToken + "\r\n").answer.status, 200);
    for (const std::string& wrong : std::initializer_list<std::string>{
             "", "Authorization: Bearer \r\n", "Authorization: Basic " + kToken + "\r\n",
             "Authorization: Bearer " + kToken + "0\r\n"})
        EXPECT_EQ(ask("GET", "/right", wrong).answer.status, 401) << wrong;
}

TEST_F(Site, control_has_a_token_of_its_own_while_it_is_allowed) {
    const std::string control(32, 'c');
    const auto right = [&](const std::string& token) {
        return ask("GET", "/right", "Authorization: Bearer " + token + "\r\n").answer;
    };
    EXPECT_EQ(right(control).status, 401) << "nobody may";
    EXPECT_EQ(right("").status, 401) << "no token is none";
    EXPECT_EQ(live().right, Right::view);
    access.control_token = control;
    EXPECT_EQ(right(control).text, R"({"right":"control"})");
    EXPECT_EQ(right(kToken).text, R"({"right":"view"})");
    EXPECT_EQ(right(control.substr(1)).status, 401);
    protocols = "ghostlight.1, t." + kToken + ", t." + control;
    EXPECT_EQ(live().right, Right::control);
    protocols = "ghostlight.1, t." + control;
    EXPECT_EQ(live().right, Right::control);
    EXPECT_EQ(pair(R"({"code":"123456"})"), 200);
    access.control_token.clear();
    EXPECT_EQ(live().answer.status, 401);
}

TEST_F(Site, where_browsers_trust_the_origin_the_page_stands_alone_and_nowhere_else) {
    const auto isolates = [&](const std::string& called) {
        host = called;
        const Routed routed = ask("GET", "/");
        EXPECT_EQ(routed.answer.status, 200) << called;
        return answer_text(routed.answer).find("Cross-Origin-Opener-Policy: same-origin\r\n") !=
               std::string::npos;
    };
    access.own = {
        {"localhost", "127.0.0.1", "[::1]", "192.168.1.20", "desk.local"}, 8010, "lights.example.org"};
    for (const char* trusted : {"localhost:8010", "127.0.0.1:8010", "[::1]:8010", "lights.example.org"})
        EXPECT_TRUE(isolates(trusted)) << trusted;
    for (const char* plain : {"192.168.1.20:8010", "desk.local:8010"}) EXPECT_FALSE(isolates(plain)) << plain;
}

TEST_F(Site, the_book_is_for_those_with_a_token) {
    const auto book = [&](const std::string& target, const std::string& token = kToken) {
        return ask("GET", target, "Authorization: Bearer " + token + "\r\n");
    };
    EXPECT_EQ(book("/book/book.json").book, "book.json");
    EXPECT_EQ(book("/book/pictures/0001-1.png").book, "pictures/0001-1.png");
    EXPECT_EQ(book("/book/../../etc/passwd").book, "../../etc/passwd") << "a name like any other";
    EXPECT_EQ(book("/book").answer.status, 404);
    for (const std::string& wrong : {std::string(), kToken + "0", std::string(32, '0')}) {
        const Routed routed = book("/book/book.json", wrong);
        EXPECT_EQ(routed.answer.status, 401) << wrong;
        EXPECT_FALSE(routed.book) << wrong;
    }
    EXPECT_EQ(ask("POST", "/book/book.json").answer.status, 405);
}

} // namespace
} // namespace ghost::web
