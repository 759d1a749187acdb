#pragma once
// SPDX-License-Identifier: Apache-2.0
// Surfaces: what passes between windows and the engine so that the graphics device itself shows the pictures
// in them. The engine offers it; windows answer with a surface each, and with what lies over the picture
// there. Which way is faster is measured once, the first time. Plain values but for what belongs to Vulkan,
// which nobody looks into here.

#include "image/image.h"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>

namespace ghost::ui {

// Who shows the pictures in the window.
enum class Shower {
    measured, // whoever is faster
    device,   // by a surface, where the device reaches the display
    window,   // as any other part of it: read back from the device, and painted
};

struct SurfaceOffer {
    std::shared_ptr<void> instance; // of Vulkan, that surfaces are made of; held as long as there are any
    // The surface of that number goes: when this returns nothing uses it. Any thread.
    std::function<void(std::uint64_t number)> let_go;
    bool is_measured = false; // else the device shows them, whatever that costs
};

struct Surface {
    std::uint64_t number = 0; // no two have the same
    std::uint64_t handle = 0; // of Vulkan
    glm::ivec2 size{0};       // pixels of the window there
    // Over the picture, in pixels: BGRA, premultiplied, that size; null: nothing.
    std::shared_ptr<const image::Image8> covers;
    double paint_ms = 0;        // what the window takes to paint the picture with all that lies over it
    double paint_covers_ms = 0; // without the picture
};

// Who shows them now, and why.
struct ShowerNow {
    bool is_device = false;
    bool is_decided = false; // the device does, or the window does from now on; else it is being measured
    std::uint64_t lost = 0;  // a surface that is to be made anew; 0: none is
    std::string words;       // that say so; "": nothing is to be said
    std::string format;      // "HDR10", "scRGB", where the display shows more than white
    bool operator==(const ShowerNow&) const = default;
};

} // namespace ghost::ui
