// SPDX-License-Identifier: Apache-2.0
#include "web/access.h"

#include <gtest/gtest.h>

#include <set>

namespace ghost::web {
namespace {

const OwnNames kOwn{{"localhost", "127.0.0.1", "[::1]", "10.0.0.5", "desk.local"}, 8010, ""};

TEST(Access, tokens_are_128_random_bits) {
    std::set<std::string> tokens;
    for (int i = 0; i < 100; ++i) {
        const std::string token = make_token();
        EXPECT_EQ(token.size(), 32u);
        EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
        tokens.insert(token);
    }
    EXPECT_EQ(tokens.size(), 100u);
}

TEST(Access, a_secret_is_the_same_or_it_is_not) {
    const std::string secret = "0123456789abcdef0123456789abcdef";
    EXPECT_TRUE(is_same_secret(secret, secret));
    for (const std::string& wrong : {std::string(), secret.substr(1), secret.substr(0, 31), secret + "0",
                                     secret + std::string(1000, 'a'), "1" + secret.substr(1),
                                     secret.substr(0, 31) + "e", std::string(32, '\0')})
        EXPECT_FALSE(is_same_secret(wrong, secret)) << wrong;
    EXPECT_FALSE(is_same_secret("", ""));
}

TEST(Access, digits_hold_for_two_minutes_and_five_tries) {
    Pairing fresh("123456", 10);
    EXPECT_TRUE(fresh.accepts("123456", 10));
    EXPECT_TRUE(fresh.accepts("123456", 130));
    EXPECT_FALSE(Pairing("123456", 10).accepts("123456", 130.1));
    Pairing tried("123456", 10);
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(tried.accepts("000000", 10));
    EXPECT_FALSE(tried.accepts("123456", 10)) << "the sixth";
    std::set<std::string> digits;
    for (int i = 0; i < 50; ++i) {
        const Pairing made(0);
        EXPECT_EQ(made.digits().size(), 6u);
        EXPECT_EQ(made.digits().find_first_not_of("0123456789"), std::string::npos);
        digits.insert(made.digits());
    }
    EXPECT_GT(digits.size(), 40u);
}

TEST(Access, only_our_own_names_are_answered) {
    for (const char* host : {"127.0.0.1:8010", "localhost:8010", "LocalHost:8010", "[::1]:8010",
                             "10.0.0.5:8010", "desk.local:8010"})
        EXPECT_TRUE(is_own_host(host, kOwn)) << host;
    for (const char* host : {"", "127.0.0.1", "127.0.0.1:8011", "127.0.0.1:80100", "evil.example:8010",
                             "localhost.evil.example:8010", "10.0.0.50:8010", "localhost:8010:8010", "[::1",
                             "[::2]:8010", ":8010", "127.0.0.1:8010 "})
        EXPECT_FALSE(is_own_host(host, kOwn)) << host;
    OwnNames at_80 = kOwn;
    at_80.port = 80;
    EXPECT_TRUE(is_own_host("localhost", at_80));
}

TEST(Access, a_proxy_has_the_name_that_it_was_given) {
    OwnNames own = kOwn;
    own.proxied = "lights.example.org";
    EXPECT_TRUE(is_own_host("Lights.example.org", own));
    EXPECT_TRUE(is_own_host("lights.example.org:8443", own));
    EXPECT_FALSE(is_own_host("lights.example.org.evil", own));
    EXPECT_TRUE(is_own_origin("https://lights.example.org:8443", "lights.example.org:8443", own));
    EXPECT_FALSE(is_own_origin("https://localhost:8010", "localhost:8010", own));
    EXPECT_FALSE(is_own_host("", kOwn));
}

TEST(Access, an_origin_is_the_page_that_we_gave) {
    EXPECT_TRUE(is_own_origin("http://localhost:8010", "localhost:8010", kOwn));
    for (const char* origin : {"", "null", "http://localhost", "http://localhost:8011",
                               "https://localhost:8010", "http://127.0.0.1:8010", "http://localhost:8010/",
                               "localhost:8010", "http://localhost:8010.evil.example"})
        EXPECT_FALSE(is_own_origin(origin, "localhost:8010", kOwn)) << origin;
}

TEST(Access, this_machine_is_known) {
    const OwnNames own = own_names(8010, "");
    EXPECT_TRUE(is_own_host("127.0.0.1:8010", own));
    EXPECT_GE(own.names.size(), 3u);
}

} // namespace
} // namespace ghost::web
