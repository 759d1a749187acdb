// SPDX-License-Identifier: Apache-2.0
#include "video/private/camera.h"

#include <algorithm>
#include <cmath>

namespace ghost::video {
namespace {

std::uint8_t code(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
}

} // namespace

Result<image::Image8> picture_from_yuyv(const std::uint8_t* bytes, std::size_t count, int width, int height,
                                        int stride_bytes) {
    const std::size_t stride = static_cast<std::size_t>(std::max(stride_bytes, 2 * width));
    if (width < 2 || height < 1 || width % 2 != 0 ||
        count < stride * static_cast<std::size_t>(height - 1) + 2 * static_cast<std::size_t>(width))
        return Error{"sent " + std::to_string(count) + " bytes, expected a picture of " +
                         std::to_string(width) + "x" + std::to_string(height),
                     "camera"};
    image::Image8 picture(width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t* pair =
                bytes + static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x / 2);
            const float luma = 1.164384f * (static_cast<float>(pair[x % 2 ? 2 : 0]) - 16.0f);
            const float blue = static_cast<float>(pair[1]) - 128.0f,
                        red = static_cast<float>(pair[3]) - 128.0f;
            std::uint8_t* to = picture.at(x, y);
            to[0] = code(luma + 1.596027f * red);
            to[1] = code(luma - 0.391762f * blue - 0.812968f * red);
            to[2] = code(luma + 2.017232f * blue);
            to[3] = 255;
        }
    return picture;
}

} // namespace ghost::video
