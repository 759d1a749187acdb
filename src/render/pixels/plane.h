#pragma once
// SPDX-License-Identifier: Apache-2.0
// Plane: a layer of an image in memory, row after row, that shaders and the processor's own vectors both work
// on. A view: owns nothing.

#include <cstddef>
#include <cstdint>

namespace ghost::render {

struct Plane {
    std::uint8_t* at = nullptr; // null: there is none
    std::size_t row_bytes = 0;
    int width = 0; // texels
    int height = 0;

    explicit operator bool() const { return at != nullptr; }
    std::uint8_t* row(int y) const { return at + static_cast<std::size_t>(y) * row_bytes; }
};

// What was drawn of some lights: their light on surfaces, and in the air. rgba16f; extra fragments lie in
// rows below the picture.
struct DrawnLights {
    Plane surfaces, haze;
};

// Texels of a plane.
struct PlanePart {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0; // beyond the last one
    int y1 = 0;
};

} // namespace ghost::render
