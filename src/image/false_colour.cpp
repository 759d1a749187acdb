// SPDX-License-Identifier: Apache-2.0
#include "image/false_colour.h"

#include <algorithm>
#include <cmath>

namespace ghost::image {
namespace {

constexpr Rgb8 kBelow{10, 10, 14};
constexpr Rgb8 kAbove{255, 255, 255};

float turbo(float x, const std::array<float, 6>& c) {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

std::uint8_t byte_of(float share) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
}

} // namespace

float place_on(const Scale& scale, float value) {
    return std::log(std::max(value, 1e-30f) / scale.low) / std::log(scale.high / scale.low);
}

Rgb8 false_colour(const Scale& scale, float value) {
    if (!(value >= scale.low)) return kBelow;
    if (value > scale.high) return kAbove;
    const float x = std::clamp(place_on(scale, value), 0.0f, 1.0f);
    return {
        byte_of(
            turbo(x, {0.13572138f, 4.61539260f, -42.66032258f, 132.13108234f, -152.94239396f, 59.28637943f})),
        byte_of(turbo(x, {0.09140261f, 2.19418839f, 4.84296658f, -14.18503333f, 4.27729857f, 2.82956604f})),
        byte_of(turbo(
            x, {0.10667330f, 12.64194608f, -60.58204836f, 110.36276771f, -89.90310912f, 27.34824973f}))};
}

Image8 false_coloured(const ImageF& values, const Scale& scale) {
    Image8 picture(values.width, values.height, 4);
    const auto step = static_cast<std::size_t>(values.channels);
    for (std::size_t i = 0; i < picture.samples.size() / 4; ++i) {
        const Rgb8 colour = false_colour(scale, values.samples[step * i]);
        std::copy(colour.begin(), colour.end(), picture.samples.begin() + static_cast<std::ptrdiff_t>(4 * i));
        picture.samples[4 * i + 3] = 255;
    }
    return picture;
}

} // namespace ghost::image
