// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/loss_note.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

dmx::Universes universes(std::initializer_list<int> lost, bool black = false) {
    dmx::Universes result;
    for (std::uint16_t number = 1; number <= 8; ++number) result.at(number).arrival = 10s;
    for (const int number : lost) {
        dmx::Universe& universe = result.at(static_cast<std::uint16_t>(number));
        universe.lost = true;
        universe.black = black;
    }
    return result;
}

TEST(LossNote, names_what_is_lost_and_for_how_long) {
    LossNote note;
    note.look(universes({}), 11s);
    EXPECT_EQ(note.text(), "");
    note.look(universes({2}), 15s);
    EXPECT_EQ(note.text(), "no DMX on universe 2 for 5 s: last look held");
    note.look(universes({2, 3}, true), 17500ms);
    EXPECT_EQ(note.text(), "no DMX on universes 2, 3 for 7 s: black");
    note.look(universes({1, 2, 3, 4, 5, 6}), 15s);
    EXPECT_EQ(note.text(), "no DMX on universes 1, 2, 3, 4 and 2 more for 5 s: last look held");
    note.look(universes({}), 16s);
    EXPECT_EQ(note.text(), "");
}

TEST(LossNote, two_captions_on_a_line) {
    EXPECT_EQ(joined("", ""), "");
    EXPECT_EQ(joined("a", ""), "a");
    EXPECT_EQ(joined("", "b"), "b");
    EXPECT_EQ(joined("a", "b"), "a, b");
}

} // namespace
} // namespace ghost::app
