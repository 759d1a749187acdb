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

} // namespace
} // namespace ghost
