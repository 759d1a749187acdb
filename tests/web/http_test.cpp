// SPDX-License-Identifier: Apache-2.0
#include "web/http.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

const std::string kGet = "GET /a/main.js HTTP/1.1\r\nHost: 127.0.0.1:8010\r\nAccept:  text/html \r\n\r\n";

std::string with(const std::string& field) {
    return "GET / HTTP/1.1\r\nHost: a\r\n" + field + "\r\n\r\n";
}

TEST(Http, a_head_is_read) {
    const ParsedHead parsed = parse_head(kGet + "more");
    ASSERT_EQ(parsed.status, 200);
    EXPECT_EQ(parsed.head.method, "GET");
    EXPECT_EQ(parsed.head.target, "/a/main.js");
    EXPECT_EQ(parsed.head.field("host"), "127.0.0.1:8010");
    EXPECT_EQ(parsed.head.field("accept"), "text/html");
    EXPECT_EQ(parsed.head.field("origin"), "");
    EXPECT_FALSE(parsed.head.has("origin"));
    EXPECT_EQ(parsed.bytes, kGet.size());
}

TEST(Http, every_truncation_waits_for_more) {
    for (std::size_t size = 0; size < kGet.size(); ++size)
        EXPECT_EQ(parse_head(kGet.substr(0, size)).status, 0) << size;
}

TEST(Http, what_may_be_read_in_two_ways_is_refused) {
    for (const char* line : {"GET  / HTTP/1.1", "GET /", "/ HTTP/1.1", "G(T / HTTP/1.1", "GET a HTTP/1.1",
                             "GET http://a/ HTTP/1.1", "GET / HTTP/1.1 ", "GET /\x7f HTTP/1.1", ""})
        EXPECT_EQ(parse_head(std::string(line) + "\r\nHost: a\r\n\r\n").status, 400) << line;
    EXPECT_EQ(parse_head("GET / HTTP/1.0\r\n\r\n").status, 505);
    for (const char* field : {"no colon", " Folded: a", "Name : a", "Na(me: a", ": a", "A: a\nB: b",
                              "A: \x01", "Host: b", "HOST: b"})
        EXPECT_EQ(parse_head(with(field)).status, 400) << field;
    EXPECT_EQ(parse_head(with(std::string("A: a\0b", 6))).status, 400);
    EXPECT_EQ(parse_head(with("Origin: a\r\nOrigin: a")).status, 400);
    EXPECT_EQ(parse_head(with("Accept: a\r\nAccept: b")).status, 200); // decides nothing
    EXPECT_EQ(parse_head(with("Transfer-Encoding: chunked")).status, 501);
}

TEST(Http, heads_have_an_end) {
    const auto of_size = [](std::size_t bytes) {
        const std::string rest = "GET / HTTP/1.1\r\nA: \r\n\r\n";
        return "GET / HTTP/1.1\r\nA: " + std::string(bytes - rest.size(), 'a') + "\r\n\r\n";
    };
    EXPECT_EQ(parse_head(of_size(kMostHeadBytes)).status, 200);
    EXPECT_EQ(parse_head(of_size(kMostHeadBytes + 1)).status, 431); // though it is whole
    EXPECT_EQ(parse_head(std::string(kMostHeadBytes, 'a')).status, 431);
    std::string lines = "GET / HTTP/1.1\r\n";
    for (std::size_t i = 0; i < kMostHeadLines; ++i) lines += "A: a\r\n";
    EXPECT_EQ(parse_head(lines + "\r\n").status, 200);
    EXPECT_EQ(parse_head(lines + "A: a\r\n\r\n").status, 431);
}

TEST(Http, bodies_are_short_and_say_how_long_they_are) {
    const auto status = [](const std::string& method, const std::string& length, std::size_t& bytes) {
        const std::string field = length.empty() ? "" : "Content-Length: " + length + "\r\n";
        return body_status(parse_head(method + " / HTTP/1.1\r\n" + field + "\r\n").head, bytes);
    };
    std::size_t bytes = 1;
    EXPECT_EQ(status("GET", "", bytes), 200);
    EXPECT_EQ(bytes, 0u);
    EXPECT_EQ(status("POST", "256", bytes), 200);
    EXPECT_EQ(bytes, 256u);
    EXPECT_EQ(status("POST", "", bytes), 411);
    EXPECT_EQ(status("POST", "257", bytes), 413);
    EXPECT_EQ(status("POST", "99999999999999999999999", bytes), 413);
    for (const char* bad : {"-1", "1 1", "0x1", "a", "+1"}) EXPECT_EQ(status("POST", bad, bytes), 400) << bad;
}

TEST(Http, an_answer_forbids_what_a_page_does_not_need) {
    const std::string text =
        answer_text({.status = 200, .type = "text/plain", .body = "hi", .text = {}, .fields = {}});
    EXPECT_TRUE(text.starts_with("HTTP/1.1 200 OK\r\n"));
    EXPECT_TRUE(text.ends_with("\r\n\r\nhi"));
    for (const char* field :
         {"Content-Length: 2\r\n", "Connection: close\r\n", "default-src 'none'; script-src 'self';",
          "frame-ancestors 'none'", "Cross-Origin-Resource-Policy: same-origin",
          "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer"})
        EXPECT_NE(text.find(field), std::string::npos) << field;
    EXPECT_EQ(text.find("Access-Control"), std::string::npos);
    EXPECT_EQ(text.find("Set-Cookie"), std::string::npos);
}

} // namespace
} // namespace ghost::web
