// SPDX-License-Identifier: Apache-2.0
#include "live/session/caption.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace ghost::app {
namespace {

constexpr int kColumns = 5;
constexpr int kRows = 7;
constexpr int kAdvance = kColumns + 1; // dots
constexpr int kMargin = 2;             // dots

struct Glyph {
    char character;
    std::uint64_t dots; // rows from the top, five bits each, the first dot is bit 34
};

constexpr std::array<Glyph, 45> kGlyphs{{
    {'A', 0x3a31fc631}, {'B', 0x7a31f463e}, {'C', 0x3a308422e}, {'D', 0x7a318c63e}, {'E', 0x7e10f421f},
    {'F', 0x7e10f4210}, {'G', 0x3a30bc62f}, {'H', 0x4631fc631}, {'I', 0x38842108e}, {'J', 0x1c4210a4c},
    {'K', 0x4654c5251}, {'L', 0x42108421f}, {'M', 0x4775ac631}, {'N', 0x4739ace71}, {'O', 0x3a318c62e},
    {'P', 0x7a31f4210}, {'Q', 0x3a318d64d}, {'R', 0x7a31f5251}, {'S', 0x3e107043e}, {'T', 0x7c8421084},
    {'U', 0x46318c62e}, {'V', 0x46318c544}, {'W', 0x4631ad771}, {'X', 0x462a22a31}, {'Y', 0x462a21084},
    {'Z', 0x7c222221f}, {'0', 0x3a33ae62e}, {'1', 0x11842108e}, {'2', 0x3a211111f}, {'3', 0x3a213062e},
    {'4', 0x08ca97c42}, {'5', 0x7e1e0862e}, {'6', 0x1910f462e}, {'7', 0x7c2221108}, {'8', 0x3a317462e},
    {'9', 0x3a317844c}, {'.', 0x00000018c}, {',', 0x000003088}, {':', 0x018c03180}, {'(', 0x088842082},
    {')', 0x208210888}, {'-', 0x0000f8000}, {'/', 0x042222210}, {'+', 0x0084f9080}, {'%', 0x672222273},
}};

std::uint64_t dots_of(char character) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    for (const Glyph& glyph : kGlyphs)
        if (glyph.character == capital) return glyph.dots;
    return 0;
}

} // namespace

void draw_caption(image::Image8& picture, const std::string& text) {
    if (text.empty() || picture.empty()) return;
    const int dots = static_cast<int>(std::min<std::size_t>(text.size(), 1000)) * kAdvance - 1 + 2 * kMargin;
    const int size = std::max(std::min(picture.height / 240, picture.width / dots), 1); // pixels of a dot
    const int right = std::min(dots * size, picture.width);
    const int top = std::max(picture.height - (kRows + 2 * kMargin) * size, 0);
    for (int y = top; y < picture.height; ++y)
        for (int x = 0; x < right; ++x) {
            const int row = (y - top) / size - kMargin;
            const int column = x / size - kMargin;
            bool on = false;
            if (row >= 0 && row < kRows && column >= 0) {
                const auto place = static_cast<std::size_t>(column / kAdvance);
                const int bit = (kRows - 1 - row) * kColumns + kColumns - 1 - column % kAdvance;
                on = place < text.size() && column % kAdvance < kColumns &&
                     ((dots_of(text[place]) >> bit) & 1u) != 0;
            }
            std::uint8_t* pixel = picture.at(x, y);
            for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(on ? 230 : pixel[c] / 3);
        }
}

} // namespace ghost::app
