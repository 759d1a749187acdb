#pragma once
// SPDX-License-Identifier: Apache-2.0
// JPEG (ITU-T T.81) read with libjpeg-turbo: gray, colour and CMYK, sequential and progressive, 8 bits. What
// a camera says of how it was held (EXIF) is not followed. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "image/image.h"
#include "image/private/picture_size.h"

#include <string>

namespace ghost::image {

bool is_jpeg(Bytes bytes);
// Reads the header only.
Result<PictureSize> jpeg_size(Bytes bytes);
// Into RGBA, opaque. damage: what is wrong with a picture that is shown all the same; empty: nothing.
Result<Image8> decode_jpeg(Bytes bytes, std::string& damage);

} // namespace ghost::image
