#pragma once
// SPDX-License-Identifier: Apache-2.0
// GelBook: well-known filters of Lee's swatch book: conversions by their published mired shift, colours by
// how they look on a screen, which is close and not measured. Pure.

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace ghost::ui {

struct Gel {
    std::string_view number;  // "L201"
    std::string_view name;    // "Full CT blue"
    std::optional<int> mired; // shift of a conversion; above 0: warmer
    std::uint32_t screen = 0; // 0xrrggbb, of a colour
};
std::span<const Gel> gel_book();

// The light of a lamp of that temperature behind it, or, of a colour, the colour itself: linear Rec.2020,
// largest component 1.
glm::vec3 colour_of(const Gel& gel, float lamp_k);

} // namespace ghost::ui
