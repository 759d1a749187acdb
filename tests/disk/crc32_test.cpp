// SPDX-License-Identifier: Apache-2.0
#include "disk/crc32.h"

#include <gtest/gtest.h>

#include <string_view>

namespace ghost {
namespace {

Bytes bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(Crc32, known_answers) {
    EXPECT_EQ(crc32({}), 0u);
    EXPECT_EQ(crc32({}, 7u), 7u);
    EXPECT_EQ(crc32(bytes_of("123456789")), 0xCBF43926u); // the check value of the CRC catalogues
    EXPECT_EQ(crc32(bytes_of("The quick brown fox jumps over the lazy dog")), 0x414FA339u);
}

TEST(Crc32, goes_on_from_any_place) {
    const std::string_view text = "The quick brown fox jumps over the lazy dog";
    for (std::size_t cut = 0; cut <= text.size(); ++cut)
        EXPECT_EQ(crc32(bytes_of(text.substr(cut)), crc32(bytes_of(text.substr(0, cut)))), 0x414FA339u);
}

} // namespace
} // namespace ghost
