// SPDX-License-Identifier: Apache-2.0
#include "render/mip_levels.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::render {
namespace {

constexpr int kSteps = 16384; // of the table that encodes

struct Tables {
    std::array<float, 256> to_light{};
    std::vector<std::uint8_t> to_srgb;

    Tables() : to_srgb(kSteps + 1) {
        for (std::size_t k = 0; k < to_light.size(); ++k)
            to_light[k] = image::srgb_to_linear(static_cast<float>(k) / 255.0f);
        for (std::size_t k = 0; k < to_srgb.size(); ++k)
            to_srgb[k] = static_cast<std::uint8_t>(std::lround(
                image::linear_to_srgb(static_cast<float>(k) / static_cast<float>(kSteps)) * 255.0f));
    }
};

image::Image8 halved(const image::Image8& from, bool srgb) {
    static const Tables tables;
    image::Image8 to(std::max(from.width / 2, 1), std::max(from.height / 2, 1), from.channels);
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            const int x0 = std::min(2 * x, from.width - 1);
            const int x1 = std::min(2 * x + 1, from.width - 1);
            const int y0 = std::min(2 * y, from.height - 1);
            const int y1 = std::min(2 * y + 1, from.height - 1);
            const std::array<const std::uint8_t*, 4> texels{from.at(x0, y0), from.at(x1, y0), from.at(x0, y1),
                                                            from.at(x1, y1)};
            std::uint8_t* mean = to.at(x, y);
            for (int c = 0; c < from.channels; ++c) {
                if (srgb && c < 3) {
                    float light = 0;
                    for (const std::uint8_t* texel : texels) light += tables.to_light[texel[c]];
                    mean[c] = tables.to_srgb[static_cast<std::size_t>(
                        std::lround(light * 0.25f * static_cast<float>(kSteps)))];
                } else {
                    int sum = 2;
                    for (const std::uint8_t* texel : texels) sum += texel[c];
                    mean[c] = static_cast<std::uint8_t>(sum / 4);
                }
            }
        }
    return to;
}

} // namespace

std::vector<image::Image8> mip_levels(const image::Image8& pixels, bool srgb, int first) {
    std::vector<image::Image8> levels;
    image::Image8 level = pixels;
    for (int k = 0;; ++k) {
        const bool last = level.width == 1 && level.height == 1;
        image::Image8 next = last ? image::Image8() : halved(level, srgb);
        if (k >= first || last) levels.push_back(std::move(level));
        if (last) return levels;
        level = std::move(next);
    }
}

} // namespace ghost::render
