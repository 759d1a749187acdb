// SPDX-License-Identifier: Apache-2.0
#include "video/private/test_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace ghost::video {
namespace {

constexpr int kCardWidth = 512;
constexpr int kCardHeight = 288;
constexpr int kCell = 32;

using Rgb = std::array<std::uint8_t, 3>;

constexpr std::array<Rgb, 8> kBars{{{255, 255, 255},
                                    {255, 255, 0},
                                    {0, 255, 255},
                                    {0, 255, 0},
                                    {255, 0, 255},
                                    {255, 0, 0},
                                    {0, 0, 255},
                                    {0, 0, 0}}};

template <class Colour>
image::Image8 drawn(const Colour& colour) {
    image::Image8 card(kCardWidth, kCardHeight, 4);
    for (int y = 0; y < kCardHeight; ++y)
        for (int x = 0; x < kCardWidth; ++x) {
            const Rgb rgb = colour(x, y);
            std::copy(rgb.begin(), rgb.end(), card.at(x, y));
            card.at(x, y)[3] = 255;
        }
    return card;
}

// Corners: red, green, blue and yellow, from the upper left clockwise, so that a mirrored picture shows.
Rgb grid_colour(int x, int y) {
    const bool left = x < kCell, right = x >= kCardWidth - kCell, top = y < kCell,
               bottom = y >= kCardHeight - kCell;
    if (top && left) return {255, 0, 0};
    if (top && right) return {0, 255, 0};
    if (bottom && right) return {0, 0, 255};
    if (bottom && left) return {255, 255, 0};
    const float radius =
        std::hypot(static_cast<float>(x) - 0.5f * kCardWidth, static_cast<float>(y) - 0.5f * kCardHeight);
    const bool circle = std::abs(radius - 0.45f * kCardHeight) < 2.5f;
    const bool rim = x < 3 || y < 3 || x >= kCardWidth - 3 || y >= kCardHeight - 3;
    const bool line = x % kCell < 2 || y % kCell < 2;
    const bool middle = std::abs(x - kCardWidth / 2) < 3 || std::abs(y - kCardHeight / 2) < 3;
    if (circle || rim || middle) return {255, 255, 255};
    if (line) return {190, 190, 190};
    return (x / kCell + y / kCell) % 2 ? Rgb{40, 60, 110} : Rgb{20, 30, 60};
}

} // namespace

image::Image8 test_card(std::string_view name) {
    if (name == "bars")
        return drawn([](int x, int) { return kBars[static_cast<std::size_t>(x * 8 / kCardWidth)]; });
    if (name == "ramp")
        return drawn([](int x, int) {
            const auto grey = static_cast<std::uint8_t>(x * 255 / (kCardWidth - 1));
            return Rgb{grey, grey, grey};
        });
    if (name == "white") return drawn([](int, int) { return Rgb{255, 255, 255}; });
    return drawn(grid_colour);
}

image::Image8 missing_card() {
    return drawn([](int x, int y) { return (x + y) / kCell % 2 ? Rgb{220, 0, 160} : Rgb{25, 25, 25}; });
}

} // namespace ghost::video
