// SPDX-License-Identifier: Apache-2.0
#include "base/base64.h"

#include <gtest/gtest.h>

#include <string>

namespace ghost {
namespace {

std::string text_of(std::string_view encoded) {
    const auto bytes = from_base64(encoded);
    return bytes ? std::string(bytes->begin(), bytes->end()) : "nothing";
}

TEST(base64, vectors_of_rfc_4648) {
    EXPECT_EQ(text_of(""), "");
    EXPECT_EQ(text_of("Zg=="), "f");
    EXPECT_EQ(text_of("Zm8="), "fo");
    EXPECT_EQ(text_of("Zm8"), "fo");
    EXPECT_EQ(text_of("Zm9vYmFy"), "foobar");
    EXPECT_EQ(text_of("-_-_"), text_of("+/+/"));
    for (const char* bad : {"Zm9%", "Zm=v", " Zg==", "Zg\n"}) EXPECT_EQ(text_of(bad), "nothing") << bad;
}

TEST(base64, is_written_as_it_is_read) {
    for (const auto& [text, encoded] :
         std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foobar", "Zm9vYmFy"},
                                                          {"\xfb\xff", "+/8="}}) {
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        EXPECT_EQ(to_base64(bytes), encoded);
        EXPECT_EQ(text_of(encoded), text);
    }
}

} // namespace
} // namespace ghost
