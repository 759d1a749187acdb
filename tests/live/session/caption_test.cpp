// SPDX-License-Identifier: Apache-2.0
#include "live/session/caption.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

image::Image8 grey(int width, int height) {
    image::Image8 picture(width, height, 4);
    for (std::uint8_t& sample : picture.samples) sample = 90;
    return picture;
}

// The lower left corner as text: '#' a dot of a letter, '.' the ground, ' ' the picture.
std::string corner(const image::Image8& picture, int width, int height) {
    std::string text;
    for (int y = picture.height - height; y < picture.height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int value = picture.at(x, y)[1];
            text += value == 230 ? '#' : value == 30 ? '.' : ' ';
        }
        text += '\n';
    }
    return text;
}

TEST(Caption, letters_stand_in_the_lower_left_corner) {
    image::Image8 picture = grey(64, 48);
    draw_caption(picture, "h2");
    EXPECT_EQ(corner(picture, 16, 12), "                \n"
                                       "............... \n"
                                       "............... \n"
                                       "..#...#..###... \n"
                                       "..#...#.#...#.. \n"
                                       "..#...#.....#.. \n"
                                       "..#####....#... \n"
                                       "..#...#...#.... \n"
                                       "..#...#..#..... \n"
                                       "..#...#.#####.. \n"
                                       "............... \n"
                                       "............... \n");
    EXPECT_EQ(picture.at(0, 47)[3], 90) << "alpha stays";
}

TEST(Caption, letters_grow_with_the_picture) {
    image::Image8 picture = grey(1280, 720);
    draw_caption(picture, "1");
    // Three pixels a dot: the stem of the 1 is the third column.
    for (int y = 720 - 5 * 3; y < 720 - 3 * 3; ++y)
        for (int x = 4 * 3; x < 5 * 3; ++x) EXPECT_EQ(picture.at(x, y)[0], 230);
    EXPECT_EQ(picture.at(3 * 3, 720 - 5 * 3)[0], 30);
    EXPECT_EQ(picture.at(9 * 3, 719)[0], 90);
}

TEST(Caption, any_text_in_any_picture) {
    for (const int side : {1, 5, 16, 300}) {
        image::Image8 picture = grey(side, side);
        draw_caption(picture, std::string(500, 'W'));
        draw_caption(picture, "\x01\xff~ \n\t");
        draw_caption(picture, std::string(5000, 'x'));
        EXPECT_EQ(picture.samples.size(), static_cast<std::size_t>(side * side * 4));
    }
    image::Image8 untouched = grey(20, 20);
    draw_caption(untouched, "");
    EXPECT_EQ(untouched.samples, grey(20, 20).samples);
    image::Image8 none;
    draw_caption(none, "A");
}

} // namespace
} // namespace ghost::app
