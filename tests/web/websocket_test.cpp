// SPDX-License-Identifier: Apache-2.0
#include "web/private/sha1.h"
#include "web/websocket.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace ghost::web {
namespace {

using Buffer = std::vector<std::uint8_t>;

// As a browser masks it.
Buffer frame(std::uint8_t first, const std::string& payload, std::uint8_t masked = 0x80) {
    Buffer bytes{first};
    if (payload.size() < 126) {
        bytes.push_back(static_cast<std::uint8_t>(masked | payload.size()));
    } else {
        bytes.push_back(static_cast<std::uint8_t>(masked | 126));
        bytes.push_back(static_cast<std::uint8_t>(payload.size() >> 8));
        bytes.push_back(static_cast<std::uint8_t>(payload.size()));
    }
    const std::uint8_t mask[] = {1, 2, 3, 4};
    bytes.insert(bytes.end(), std::begin(mask), std::end(mask));
    for (std::size_t i = 0; i < payload.size(); ++i)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint8_t>(payload[i]) ^ mask[i & 3]));
    return bytes;
}

std::string hex(const std::string& text) {
    std::string digits;
    for (const std::uint8_t byte :
         sha1(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()))) {
        char two[3];
        std::snprintf(two, sizeof two, "%02x", byte);
        digits += two;
    }
    return digits;
}

TEST(Sha1, vectors_of_rfc_3174) {
    EXPECT_EQ(hex(""), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
    EXPECT_EQ(hex("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d");
    EXPECT_EQ(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
    EXPECT_EQ(hex(std::string(1'000'000, 'a')), "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
}

TEST(WebSocket, the_handshake_of_rfc_6455) {
    EXPECT_EQ(accept_of("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
    for (const char* bad : {"", "dGhlIHNhbXBsZSBub25jZQ=", "dGhlIHNhbXBsZSBub25jZQ==a",
                            "dGhlIHNhbXBsZSBub25j", "!!hlIHNhbXBsZSBub25jZQ=="})
        EXPECT_EQ(accept_of(bad), "") << bad;
}

TEST(WebSocket, the_masked_text_of_rfc_6455) {
    const Buffer bytes{0x81, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58, 0x81};
    const ParsedFrame read = parse_frame(bytes);
    EXPECT_EQ(read.close, 0);
    EXPECT_EQ(read.bytes, 11u); // one byte more is of the next frame
    EXPECT_EQ(read.opcode, Opcode::text);
    EXPECT_EQ(std::string(read.payload.begin(), read.payload.end()), "Hello");
}

TEST(WebSocket, every_truncation_waits_for_more) {
    for (const std::size_t size : {0u, 5u, 125u, 126u, 300u, 2048u}) {
        const Buffer whole = frame(0x82, std::string(size, 'x'));
        EXPECT_EQ(parse_frame(whole).bytes, whole.size()) << size;
        for (std::size_t cut = 0; cut < whole.size(); ++cut) {
            const ParsedFrame read = parse_frame(Bytes(whole).first(cut));
            EXPECT_EQ(read.bytes, 0u) << size << " cut at " << cut;
            EXPECT_EQ(read.close, 0) << size << " cut at " << cut;
        }
    }
}

TEST(WebSocket, what_we_do_not_take_ends_the_connection) {
    EXPECT_EQ(parse_frame(frame(0x81, "a", 0)).close, kCloseProtocol); // not masked
    EXPECT_EQ(parse_frame(frame(0xC1, "a")).close, kCloseProtocol);    // compressed
    EXPECT_EQ(parse_frame(frame(0x01, "a")).close, kCloseUnsupported); // a first fragment
    EXPECT_EQ(parse_frame(frame(0x80, "a")).close, kCloseUnsupported); // a last one
    EXPECT_EQ(parse_frame(frame(0x83, "a")).close, kCloseProtocol);    // reserved
    EXPECT_EQ(parse_frame(frame(0x8B, "a")).close, kCloseProtocol);
    EXPECT_EQ(parse_frame(frame(0x89, std::string(126, 'a'))).close, kCloseProtocol); // a long ping
    EXPECT_EQ(parse_frame(frame(0x81, std::string(kMostMessageBytes, 'a'))).close, 0);
    EXPECT_EQ(parse_frame(frame(0x81, std::string(kMostMessageBytes + 1, 'a'))).close, kCloseTooBig);
    EXPECT_EQ(parse_frame(Buffer{0x81, 0xFF}).close, kCloseTooBig);
    EXPECT_EQ(parse_frame(Buffer{0x81, 0xFE, 0, 5, 1, 2, 3, 4}).close,
              kCloseProtocol); // longer than it needs
}

TEST(WebSocket, frames_are_built_with_the_shortest_length) {
    EXPECT_EQ(build_text("Hello"), (Buffer{0x81, 0x05, 'H', 'e', 'l', 'l', 'o'}));
    const Buffer long_one = build_frame(Opcode::binary, Buffer(256));
    EXPECT_EQ(Buffer(long_one.begin(), long_one.begin() + 4), (Buffer{0x82, 126, 1, 0}));
    EXPECT_EQ(long_one.size(), 260u);
    const Buffer longer = build_frame(Opcode::binary, Buffer(65536));
    EXPECT_EQ(Buffer(longer.begin(), longer.begin() + 10), (Buffer{0x82, 127, 0, 0, 0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(build_close(kClosePolicy, "no"), (Buffer{0x88, 4, 0x03, 0xF0, 'n', 'o'}));
}

} // namespace
} // namespace ghost::web
