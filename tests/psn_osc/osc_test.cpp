// SPDX-License-Identifier: Apache-2.0
#include "psn_osc/osc.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using Buffer = std::vector<std::uint8_t>;
using Arguments = std::vector<OscArgument>;

Buffer bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

OscPacket read(const Buffer& bytes) {
    return parse_osc(bytes);
}

using namespace std::string_view_literals;

// The two examples of the OSC 1.0 specification.
const Buffer kOscillator = bytes_of("/oscillator/4/frequency\0,f\0\0\x43\xdc\0\0"sv);
const Buffer kFoo = bytes_of("/foo\0\0\0\0,iisff\0\0\0\0\x03\xe8\xff\xff\xff\xff"
                             "hello\0\0\0\x3f\x9d\xf3\xb6\x40\xb5\xb2\x2d"sv);
const Buffer kBundle = [] {
    Buffer bundle = bytes_of("#bundle\0\0\0\0\0\0\0\0\1"sv);
    for (const Buffer& part : {kOscillator, kFoo}) {
        bundle.insert(bundle.end(), {0, 0, 0, static_cast<std::uint8_t>(part.size())});
        bundle.insert(bundle.end(), part.begin(), part.end());
    }
    return bundle;
}();

TEST(Osc, examples_of_the_specification) {
    const OscPacket one = read(kOscillator);
    ASSERT_EQ(one.messages.size(), 1u);
    EXPECT_EQ(one.messages[0].address, "/oscillator/4/frequency");
    EXPECT_EQ(one.messages[0].arguments, Arguments{440.0});
    const OscPacket two = read(kFoo);
    ASSERT_EQ(two.messages.size(), 1u);
    EXPECT_EQ(two.messages[0].arguments,
              (Arguments{1000.0, -1.0, "hello", static_cast<double>(1.234f), static_cast<double>(5.678f)}));
    EXPECT_EQ(one.malformed + two.malformed, 0);
}

TEST(Osc, bundles_are_opened) {
    const OscPacket packet = read(kBundle);
    ASSERT_EQ(packet.messages.size(), 2u);
    EXPECT_EQ(packet.messages[1].address, "/foo");
    EXPECT_EQ(packet.malformed, 0);
}

TEST(Osc, bundles_in_bundles_have_a_depth) {
    Buffer nested = kOscillator;
    for (int depth = 0; depth < 12; ++depth) {
        Buffer around = bytes_of("#bundle\0\0\0\0\0\0\0\0\1"sv);
        const auto size = static_cast<std::uint16_t>(nested.size());
        around.insert(around.end(),
                      {0, 0, static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size)});
        around.insert(around.end(), nested.begin(), nested.end());
        nested = around;
        EXPECT_EQ(read(nested).messages.size(), depth < kMostOscDepth ? 1u : 0u);
        EXPECT_EQ(read(nested).malformed, depth < kMostOscDepth ? 0 : 1);
    }
}

TEST(Osc, other_kinds_are_passed_over) {
    const OscPacket packet = read(bytes_of("/a\0\0,TFNIb[c]ti\0"
                                           "\0\0\0\3abc\0\0\0\0x\0\0\0\0\0\0\0\0\0\0\0\7"sv));
    ASSERT_EQ(packet.messages.size(), 1u) << packet.malformed;
    const Arguments& arguments = packet.messages[0].arguments;
    ASSERT_EQ(arguments.size(), 8u);
    EXPECT_EQ(arguments[0], OscArgument(true));
    EXPECT_EQ(arguments[1], OscArgument(false));
    for (int i = 2; i < 7; ++i) EXPECT_EQ(arguments[static_cast<std::size_t>(i)], OscArgument());
    EXPECT_EQ(arguments[7], OscArgument(7.0));
}

TEST(Osc, a_message_may_have_no_types) {
    EXPECT_EQ(read(bytes_of("/go\0"sv)).messages.size(), 1u);
    EXPECT_EQ(read(bytes_of("/go\0,\0\0\0"sv)).messages.size(), 1u);
}

TEST(Osc, too_many_are_left_out) {
    Buffer bundle = bytes_of("#bundle\0\0\0\0\0\0\0\0\1"sv);
    for (int i = 0; i < 100; ++i) {
        const Buffer part = bytes_of("\0\0\0\4/go\0"sv);
        bundle.insert(bundle.end(), part.begin(), part.end());
    }
    EXPECT_EQ(read(bundle).messages.size(), kMostOscMessages);
    EXPECT_EQ(read(bundle).malformed, 100 - static_cast<int>(kMostOscMessages));
    EXPECT_EQ(read(bytes_of("/" + std::string(300, 'a') + std::string(3, '\0'))).malformed, 1);
    EXPECT_EQ(read(bytes_of("/a\0\0," + std::string(20, 'T') + std::string(3, '\0'))).malformed, 1);
}

TEST(Osc, cut_and_damaged_packets) {
    for (const Buffer& packet : {kOscillator, kFoo, kBundle}) {
        const std::size_t whole = read(packet).messages.size();
        for (std::size_t length = 0; length < packet.size(); ++length) {
            const OscPacket cut =
                read({packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(length)});
            // Cut behind its address a message is one without arguments: it never has some of them.
            for (const OscMessage& message : cut.messages)
                EXPECT_TRUE(message.arguments.empty() ||
                            message.arguments == read(kOscillator).messages[0].arguments);
            EXPECT_LE(cut.messages.size(), whole);
        }
        for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
            Buffer damaged = packet;
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
            EXPECT_LE(read(damaged).messages.size(), whole + 1);
        }
    }
}

} // namespace
} // namespace ghost::dmx
