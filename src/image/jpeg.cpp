// SPDX-License-Identifier: Apache-2.0
#include "image/jpeg.h"

#include "base/check.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>

namespace ghost::image {

Result<std::vector<std::uint8_t>> encode_jpeg(const Image8& pixels, const JpegQuality& quality) {
    CHECK(pixels.channels == 3 || pixels.channels == 4);
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    if (!encoder) return Error{"cannot make a JPEG picture: memory is short", ""};
    unsigned char* made = nullptr;
    unsigned long size = 0;
    const int status =
        tjCompress2(encoder.get(), pixels.samples.data(), pixels.width, 0, pixels.height,
                    pixels.channels == 4 ? TJPF_RGBX : TJPF_RGB, &made, &size,
                    quality.full_colour ? TJSAMP_444 : TJSAMP_420, quality.percent, TJFLAG_FASTDCT);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(made, tjFree);
    if (status != 0)
        return Error{std::string("cannot make a JPEG picture: ") + tjGetErrorStr2(encoder.get()), ""};
    return std::vector<std::uint8_t>(made, made + size);
}

Image8 narrowed(const Image8& pixels, int width) {
    CHECK(width > 0 && pixels.channels <= 4);
    if (pixels.width <= width) return pixels;
    const int height = std::max(1, static_cast<int>(static_cast<long>(pixels.height) * width / pixels.width));
    const auto edge = [](int k, int from, int to) {
        return static_cast<int>(static_cast<long>(k) * from / to);
    };
    Image8 small(width, height, pixels.channels);
    for (int y = 0; y < height; ++y) {
        const int top = edge(y, pixels.height, height),
                  bottom = std::max(edge(y + 1, pixels.height, height), top + 1);
        for (int x = 0; x < width; ++x) {
            const int left = edge(x, pixels.width, width),
                      right = std::max(edge(x + 1, pixels.width, width), left + 1);
            std::array<unsigned, 4> sums{};
            for (int from_y = top; from_y < bottom; ++from_y) {
                const std::uint8_t* sample = pixels.at(left, from_y);
                for (int from_x = left; from_x < right; ++from_x)
                    for (int c = 0; c < pixels.channels; ++c) sums[static_cast<std::size_t>(c)] += *sample++;
            }
            const auto count = static_cast<unsigned>((bottom - top) * (right - left));
            for (int c = 0; c < pixels.channels; ++c)
                small.at(x, y)[c] =
                    static_cast<std::uint8_t>((sums[static_cast<std::size_t>(c)] + count / 2) / count);
        }
    }
    return small;
}

} // namespace ghost::image
