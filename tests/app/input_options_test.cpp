// SPDX-License-Identifier: Apache-2.0
#include "app/input_options.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

using Numbers = std::vector<std::uint16_t>;

TEST(ParseUniverses, numbers_and_ranges) {
    EXPECT_EQ(*parse_universes(""), Numbers{});
    EXPECT_EQ(*parse_universes("7"), Numbers{7});
    EXPECT_EQ(*parse_universes("1-4,7"), (Numbers{1, 2, 3, 4, 7}));
    EXPECT_EQ(*parse_universes("9,2-3,3,1"), (Numbers{1, 2, 3, 9}));
    EXPECT_EQ(*parse_universes("63999"), Numbers{63999});
    EXPECT_EQ(parse_universes("1-4096")->size(), 4096u);
}

TEST(ParseUniverses, what_is_wrong_is_said) {
    for (const char* text : {"0", "64000", "4-2", "1,", ",1", "a", "1-", "-1", "1 2", "1-4097",
                             "1-4000,5000-6000", "99999999999"}) {
        const auto result = parse_universes(text);
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_EQ(result.error().where, "--universes");
        EXPECT_NE(result.error().what.find(text), std::string::npos);
    }
}

TEST(ReceiverOptions, protocols) {
    InputOptions input;
    EXPECT_TRUE(receiver_options(input)->sacn);
    EXPECT_TRUE(receiver_options(input)->artnet);
    input.protocols = "artnet";
    input.universes = "3";
    input.no_poll_reply = true;
    const auto options = receiver_options(input);
    EXPECT_FALSE(options->sacn);
    EXPECT_TRUE(options->artnet);
    EXPECT_FALSE(options->answer_polls);
    EXPECT_EQ(options->universes, Numbers{3});
    input.universes = "x";
    EXPECT_FALSE(receiver_options(input).ok());
}

} // namespace
} // namespace ghost::app
