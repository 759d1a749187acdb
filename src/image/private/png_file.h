#pragma once
// SPDX-License-Identifier: Apache-2.0
// PNG (ISO/IEC 15948) read and written with libpng. Of its chunks only what makes the pixels is read: no
// profiles, no gamma, no text. 16 bits lose their lower byte. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "image/image.h"
#include "image/private/picture_size.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ghost::image {

bool is_png(Bytes bytes);
// Reads the header only.
Result<PictureSize> png_size(Bytes bytes);
// Into RGBA. damage: what is wrong with a picture that is shown all the same; empty: nothing.
Result<Image8> decode_png(Bytes bytes, std::string& damage);
// 3 or 4 channels.
Result<std::vector<std::uint8_t>> encode_png(const Image8& pixels);

} // namespace ghost::image
