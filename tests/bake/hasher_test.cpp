// SPDX-License-Identifier: Apache-2.0
#include "bake/hasher.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ghost::bake {
namespace {

TEST(Hasher, known_answers) {
    EXPECT_EQ(Hasher().hex(), "99aa06d3014798d86001c324468d497f"); // of nothing, as xxHash publishes it
    Hasher abc;
    abc.bytes("abc", 3);
    EXPECT_EQ(abc.hex(), "06b05ab6733a618578af5f94892f3950");
}

TEST(Hasher, pieces_are_the_whole) {
    std::vector<unsigned char> data(5000);
    std::iota(data.begin(), data.end(), static_cast<unsigned char>(0));
    Hasher whole;
    whole.bytes(data.data(), data.size());
    for (const std::size_t cut : {0u, 1u, 255u, 256u, 257u, 1024u, 4999u}) {
        Hasher pieces;
        pieces.bytes(data.data(), cut);
        pieces.bytes(data.data() + cut, data.size() - cut);
        EXPECT_EQ(pieces.hex(), whole.hex()) << cut;
    }
}

TEST(Hasher, where_one_ends_and_the_next_begins_counts) {
    const auto of = [](const std::vector<std::string>& texts) {
        Hasher hash;
        for (const std::string& text : texts) hash.text(text);
        return hash.hex();
    };
    EXPECT_NE(of({"a", "bc"}), of({"ab", "c"}));
    EXPECT_NE(of({"a"}), of({"a", ""}));
    Hasher one_and_two;
    one_and_two.list(std::vector<int>{1});
    one_and_two.list(std::vector<int>{2});
    Hasher both;
    both.list(std::vector<int>{1, 2});
    both.list(std::vector<int>{});
    EXPECT_NE(one_and_two.hex(), both.hex());
}

} // namespace
} // namespace ghost::bake
