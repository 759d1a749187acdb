// SPDX-License-Identifier: Apache-2.0
// The table of words: whole in both languages; numbers and lengths as each of them writes.
#include "print/print_style.h"
#include "print/quantities.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace ghost::scene {
namespace {

TEST(Words, are_there_in_both_languages_with_the_same_values) {
    std::set<std::string_view> known;
    for (const Translation& words : kWords) {
        EXPECT_FALSE(words.english.empty());
        EXPECT_FALSE(words.german.empty()) << words.english;
        EXPECT_TRUE(known.insert(words.english).second) << words.english << " is there twice";
        for (const char digit : {'1', '2', '3', '4'}) {
            const std::string value = std::string("%") + digit;
            EXPECT_EQ(words.english.find(value) == std::string_view::npos,
                      words.german.find(value) == std::string_view::npos)
                << words.english << " " << value;
        }
    }
}

TEST(Words, take_values) {
    const PrintStyle english, german{Language::german, Units::metric};
    EXPECT_EQ(english("%1 of %2", {"1", "3"}), "1 of 3");
    EXPECT_EQ(german("%1 of %2", {"1", "3"}), "1 von 3");
    EXPECT_EQ(english("%1 of %2", {"%2", "x"}), "%2 of x"); // a name is no place for a value
    EXPECT_EQ(german("Plan"), "Grundriss");
}

TEST(Lengths, are_metres_or_feet_and_inches) {
    const PrintStyle metric, german{Language::german, Units::metric},
        imperial{Language::english, Units::imperial};
    EXPECT_EQ(metric.length_said(6.26), "6.26 m");
    EXPECT_EQ(german.length_said(6.26), "6,26 m");
    EXPECT_EQ(imperial.length_said(3.048), "10'-0\"");
    EXPECT_EQ(imperial.length(6.26), "20'-6 1/2\"");
    EXPECT_EQ(imperial.length(-0.3048), "-1'-0\"");
    EXPECT_EQ(imperial.length(-0.0001), "0'-0\"");
    EXPECT_EQ(imperial.length(0.3047), "1'-0\"");
    EXPECT_EQ(metric.weight(10), "10");
    EXPECT_EQ(imperial.weight(10), "22");
}

TEST(Quantities, are_rounded_as_people_round) {
    EXPECT_EQ(number_text(13.25f, 1), "13.3");
    EXPECT_EQ(number_text(-4.325f, 2), "-4.33");
    EXPECT_EQ(number_text(0.45f, 1), "0.5");
    EXPECT_EQ(number_text(2.5f, 0), "3");
    EXPECT_EQ(number_text(13.24f, 1), "13.2");
    EXPECT_EQ(number_text(99.95f, 1), "100");
    EXPECT_EQ(number_text(-9.96f, 1), "-10");
    EXPECT_EQ(number_text(-0.04f, 1), "0");
    EXPECT_EQ(number_text(120.0f, 0), "120");
    EXPECT_EQ(number_text(1e-30f, 3), "0");
    EXPECT_EQ(number_text(3e38f, 1).size(), 39u);
}

TEST(Quantities, are_whole) {
    EXPECT_EQ(with_whole_quantities("fade 12 s, 0 to 80 %, 3 spots"),
              "fade 12\u00a0s, 0 to 80\u00a0%, 3 spots");
    EXPECT_EQ(with_whole_quantities("6.26 m up-stage, zoom 12 to 24 deg"),
              "6.26\u00a0m up-stage, zoom 12 to 24\u00a0deg");
    EXPECT_EQ(with_whole_quantities("Spot s 5 "), "Spot s 5 ");
}

} // namespace
} // namespace ghost::scene
