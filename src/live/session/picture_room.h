#pragma once
// SPDX-License-Identifier: Apache-2.0
// The largest picture that memory holds: a window may ask for one of 8K where memory is for one of half of
// that. Pure.

#include "show/camera.h"

#include <cstdint>

namespace ghost::app {

// Of device memory, what a live picture takes for each of its pixels: G-buffer (with what moving objects
// hide), light, glare, the picture itself, false colours. Images that are kept come on top, where there is
// room.
constexpr std::uint64_t kPictureBytesPerPixel = 560;

constexpr int kLeastPixels = 16; // across: of no picture are fewer drawn

// The camera with fewer pixels, of the same shape, where room_bytes do not hold what it asks for;
// kLeastPixels across are the least.
scene::Camera fitted(const scene::Camera& wanted, std::uint64_t room_bytes);

} // namespace ghost::app
