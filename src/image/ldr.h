#pragma once
// SPDX-License-Identifier: Apache-2.0
// 8-bit images: PNG and JPEG in, PNG out (atomic). The size in the header is held against the limits before
// anything is made room for, and decoding gets no more memory than a picture of that size needs. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace ghost::image {

struct LdrLimits {
    int side_px = 16384; // at most that
    std::size_t pixels = std::size_t{1} << 27;
};

// Always 4 channels (RGBA). name is for the error message. damage gets one sentence where a picture is shown
// though its file is damaged, else ""; without a place for that sentence such a picture is an error.
Result<Image8> decode_ldr(Bytes bytes, const std::string& name, const LdrLimits& limits = {},
                          std::string* damage = nullptr);
// What the decoded picture takes, from its header; 0 where decode_ldr() refuses it by that. Any other fault
// shows when it is decoded.
std::size_t decoded_bytes(Bytes bytes, const LdrLimits& limits = {});
Result<Image8> read_ldr(const std::filesystem::path& path, std::string* damage = nullptr);

// 3 or 4 channels.
Result<void> write_png(const std::filesystem::path& path, const Image8& pixels);

} // namespace ghost::image
