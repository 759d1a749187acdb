#pragma once
// SPDX-License-Identifier: Apache-2.0
// 8-bit images: PNG and JPEG in (at most 16384 pixels a side and 2^27 in all), PNG out (atomic). Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "image/image.h"

#include <filesystem>
#include <string>

namespace ghost::image {

// Always 4 channels (RGBA). name is for the error message.
Result<Image8> decode_ldr(Bytes bytes, const std::string& name);
Result<Image8> read_ldr(const std::filesystem::path& path);

// 3 or 4 channels.
Result<void> write_png(const std::filesystem::path& path, const Image8& pixels);

} // namespace ghost::image
