// SPDX-License-Identifier: Apache-2.0
#include "base/windows_text.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(WindowsText, goes_there_and_back) {
    const std::string text = "Bühne \xf0\x9f\x94\xa6";
    EXPECT_EQ(utf8_text(wide_text(text)), text);
    EXPECT_EQ(wide_text("\xf0\x9f\x94\xa6"), L"\xd83d\xdd26");
    EXPECT_EQ(utf8_text(wide_text("a\xff")), "a\xef\xbf\xbd");
    EXPECT_TRUE(wide_text("").empty() && utf8_text(L"").empty());
}

// What all rooms that name files rest on: text of a path is UTF-8.
TEST(WindowsText, is_that_of_paths) {
    const std::string name = "Bühne \xf0\x9f\x94\xa6.toml";
    EXPECT_EQ(std::filesystem::path(name).native(), wide_text(name));
    EXPECT_EQ(std::filesystem::path(wide_text(name)).string(), name);
}

TEST(WindowsText, an_error_has_words_and_an_unknown_one_its_number) {
    EXPECT_FALSE(windows_reason(2).empty());
    EXPECT_NE(windows_reason(2).back(), '.');
    EXPECT_EQ(windows_reason(0x2FFFFFFF), "error 805306367");
}

} // namespace
} // namespace ghost
