// SPDX-License-Identifier: Apache-2.0
#include "base/print.h"

#include "base/log.h"

#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(Print, what_a_terminal_would_obey_is_shown) {
    EXPECT_EQ(printable("Spot 1\tä€🔦\n"), "Spot 1\tä€🔦\n");
    EXPECT_EQ(printable("\x1b]0;owned\x07"), "\\u001b]0;owned\\u0007");
    EXPECT_EQ(printable("\u202eevil\u2066 \u05e9\u200f"), "\\u202eevil\\u2066 \u05e9\u200f");
    EXPECT_EQ(printable("a\r\x7f\x08"), "a\\u000d\\u007f\\u0008");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\u009b31m"); // C1: CSI
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\u0000");
}

TEST(Print, a_name_of_somebody_else_stays_within_its_line) {
    EXPECT_EQ(one_line("Desk\nerror: 'all' is lost\t\x1b[2J ä"),
              "Desk\\u000aerror: 'all' is lost\\u0009\\u001b[2J ä");
}

TEST(Print, what_is_no_utf8_is_replaced) {
    const std::string unknown = "\xef\xbf\xbd";
    for (const char* const bytes : {"\x9b", "\xff", "\xc0", "\xf5"}) EXPECT_EQ(printable(bytes), unknown);
    EXPECT_EQ(printable("\xe2\x82"), unknown + unknown);               // cut
    EXPECT_EQ(printable("\xed\xa0\x80"), unknown + unknown + unknown); // half a pair
    EXPECT_EQ(printable("\xc3(ok"), unknown + "(ok");
}

TEST(Print, both_ways_out_are_printable) {
    testing::internal::CaptureStdout();
    print_text("%s %d\n", "\x1b[2J", 7);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "\\u001b[2J 7\n");
    testing::internal::CaptureStderr();
    log_error("'\x1b[2J' is no fixture");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "error: '\\u001b[2J' is no fixture\n");
}

} // namespace
} // namespace ghost
