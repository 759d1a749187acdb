#pragma once
// SPDX-License-Identifier: Apache-2.0
// A picture packed as JPEG, for what is put into other files. Any thread.

#include "base/result.h"
#include "image/image.h"

#include <cstdint>
#include <vector>

namespace ghost::image {

// Of RGBA, whose A is left out; quality 1..100. Error: memory is short, or a side is more than 65,500 pixels.
Result<std::vector<std::uint8_t>> jpeg_bytes(const Image8& pixels, int quality);

} // namespace ghost::image
