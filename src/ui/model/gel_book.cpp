// SPDX-License-Identifier: Apache-2.0
#include "ui/model/gel_book.h"

#include "image/colour.h"

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr Gel kGels[] = {
    // Conversions. Published: 3200 K becomes 5700 K behind L201, 6500 K becomes 3200 K behind L204, and so
    // on.
    {"L201", "Full CT blue", -137},
    {"L202", "Half CT blue", -78},
    {"L203", "Quarter CT blue", -35},
    {"L218", "Eighth CT blue", -18},
    {"L204", "Full CT orange", 159},
    {"L205", "Half CT orange", 109},
    {"L206", "Quarter CT orange", 64},
    {"L223", "Eighth CT orange", 26},
    // Colours, as on a screen.
    {"L004", "Medium bastard amber", {}, 0xfac5a4},
    {"L101", "Yellow", {}, 0xffe600},
    {"L104", "Deep amber", {}, 0xffcc00},
    {"L105", "Orange", {}, 0xff9500},
    {"L106", "Primary red", {}, 0xf60008},
    {"L113", "Magenta", {}, 0xff0062},
    {"L115", "Peacock blue", {}, 0x00cdaf},
    {"L116", "Medium blue-green", {}, 0x00a19c},
    {"L117", "Steel blue", {}, 0xa9e3e6},
    {"L119", "Dark blue", {}, 0x0050b5},
    {"L124", "Dark green", {}, 0x00b15a},
    {"L126", "Mauve", {}, 0xc900a0},
    {"L128", "Bright pink", {}, 0xff3f8f},
    {"L132", "Medium blue", {}, 0x0092d6},
    {"L134", "Golden amber", {}, 0xff9a4a},
    {"L135", "Deep golden amber", {}, 0xff6a1f},
    {"L139", "Primary green", {}, 0x009a38},
    {"L147", "Apricot", {}, 0xffb27a},
    {"L152", "Pale gold", {}, 0xffd9ab},
    {"L161", "Slate blue", {}, 0x6fb5ea},
    {"L164", "Flame red", {}, 0xf83a1f},
    {"L170", "Deep lavender", {}, 0xdb9be8},
    {"L179", "Chrome orange", {}, 0xffb300},
    {"L181", "Congo blue", {}, 0x29007a},
    {"L195", "Zenith blue", {}, 0x0a3fae},
};

} // namespace

std::span<const Gel> gel_book() {
    return kGels;
}

glm::vec3 colour_of(const Gel& gel, float lamp_k) {
    glm::vec3 colour;
    if (gel.mired) {
        const float mired = 1e6f / lamp_k + static_cast<float>(*gel.mired);
        colour = image::cct_to_rec2020(std::clamp(1e6f / std::max(mired, 1.0f), 1000.0f, 25000.0f));
    } else {
        const auto linear = [&](int shift) {
            return image::srgb_to_linear(static_cast<float>((gel.screen >> shift) & 0xffu) / 255.0f);
        };
        colour = image::rec709_to_rec2020({linear(16), linear(8), linear(0)});
    }
    return glm::max(colour, glm::vec3(0)) / std::max({colour.x, colour.y, colour.z, 1e-4f});
}

} // namespace ghost::ui
