// SPDX-License-Identifier: Apache-2.0
#include "image/pyramid.h"

#include "base/check.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ghost::image {
namespace {

constexpr int kCodeShift = 3; // of 16-bit light: steps below those of 8-bit sRGB, also in the darkest part

struct Curve {
    std::array<std::uint16_t, 256> light{};                 // of a code
    std::array<std::uint8_t, (65536 >> kCodeShift)> code{}; // of light
};

const Curve& curve() {
    static const Curve made = [] {
        Curve one;
        for (std::size_t k = 0; k < one.light.size(); ++k)
            one.light[k] = static_cast<std::uint16_t>(
                std::lround(65535.0f * srgb_to_linear(static_cast<float>(k) / 255.0f)));
        for (std::size_t k = 0; k < one.code.size(); ++k) {
            const float value = (static_cast<float>(k) + 0.5f) / static_cast<float>(one.code.size());
            one.code[k] = static_cast<std::uint8_t>(
                std::lround(255.0f * std::clamp(linear_to_srgb(value), 0.0f, 1.0f)));
        }
        one.code[0] = 0;
        return one;
    }();
    return made;
}

std::size_t texel(int x, int y, int side) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x));
}

// Box-filtered, in light.
Image8 resampled(const Image8& from, const glm::ivec2& size) {
    Image8 to(size.x, size.y, 4);
    const Curve& c = curve();
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto begin = [](int at, int count, int source) {
                return static_cast<int>(static_cast<std::int64_t>(at) * source / count);
            };
            const int x0 = begin(x, size.x, from.width), y0 = begin(y, size.y, from.height);
            const int x1 = std::max(begin(x + 1, size.x, from.width), x0 + 1);
            const int y1 = std::max(begin(y + 1, size.y, from.height), y0 + 1);
            std::array<std::uint64_t, 4> sum{};
            for (int sy = y0; sy < y1; ++sy)
                for (int sx = x0; sx < x1; ++sx) {
                    const std::uint8_t* t = from.at(sx, sy);
                    for (std::size_t k = 0; k < 3; ++k) sum[k] += std::uint64_t{c.light[t[k]]} * t[3];
                    sum[3] += t[3];
                }
            const auto count = static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
            for (std::size_t k = 0; k < 3; ++k)
                to.at(x, y)[k] = c.code[(sum[k] / (255 * count)) >> kCodeShift];
            to.at(x, y)[3] = 255; // it is in the colours now
        }
    return to;
}

// Level 0, and its light: the picture in the middle, its rim beyond.
void place(const Image8& picture, int side, std::vector<std::uint8_t>& level,
           std::vector<std::uint16_t>& light) {
    const Curve& c = curve();
    const int left = (side - picture.width) / 2, top = (side - picture.height) / 2;
    level.resize(texel(0, side, side));
    light.resize(level.size());
    for (int y = 0; y < side; ++y) {
        if (y > top && y >= top + picture.height) { // as the row above
            std::copy_n(level.begin() + static_cast<std::ptrdiff_t>(texel(0, y - 1, side)), 4 * side,
                        level.begin() + static_cast<std::ptrdiff_t>(texel(0, y, side)));
            std::copy_n(light.begin() + static_cast<std::ptrdiff_t>(texel(0, y - 1, side)), 4 * side,
                        light.begin() + static_cast<std::ptrdiff_t>(texel(0, y, side)));
            continue;
        }
        const int from_y = std::clamp(y - top, 0, picture.height - 1);
        for (int x = 0; x < side; ++x) {
            const std::uint8_t* t = picture.at(std::clamp(x - left, 0, picture.width - 1), from_y);
            const std::size_t to = texel(x, y, side);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint16_t value =
                    t[3] == 255 ? c.light[t[k]]
                                : static_cast<std::uint16_t>(std::uint32_t{c.light[t[k]]} * t[3] / 255);
                light[to + k] = value;
                level[to + k] = t[3] == 255 ? t[k] : c.code[static_cast<std::size_t>(value) >> kCodeShift];
            }
            level[to + 3] = 255;
        }
    }
}

glm::vec3 mean_of(const std::vector<std::uint16_t>& light, int side, const glm::ivec2& size) {
    const int left = (side - size.x) / 2, top = (side - size.y) / 2;
    std::array<std::uint64_t, 3> sum{};
    for (int y = top; y < top + size.y; ++y)
        for (int x = left; x < left + size.x; ++x)
            for (std::size_t k = 0; k < 3; ++k) sum[k] += light[texel(x, y, side) + k];
    const double all = 65535.0 * size.x * size.y;
    return glm::vec3(glm::dvec3(sum[0], sum[1], sum[2]) / all);
}

} // namespace

glm::ivec2 fitted(int width, int height, int side) {
    CHECK(width > 0 && height > 0);
    const double scale = static_cast<double>(side) / std::max(width, height);
    const auto pixels = [&](int from) {
        return std::clamp(static_cast<int>(std::lround(from * scale)), 1, side);
    };
    return {pixels(width), pixels(height)};
}

Pyramid make_pyramid(const Image8& rgba, int side) {
    CHECK(side >= kLeastPyramid && (side & (side - 1)) == 0 && rgba.channels == 4);
    const glm::ivec2 size = fitted(rgba.width, rgba.height, side);
    std::vector<std::vector<std::uint8_t>> levels(1);
    std::vector<std::uint16_t> light;
    if (size == glm::ivec2(rgba.width, rgba.height))
        place(rgba, side, levels[0], light);
    else
        place(resampled(rgba, size), side, levels[0], light);

    Pyramid pyramid;
    pyramid.side = side;
    pyramid.extent = glm::vec2(size) / static_cast<float>(side);
    pyramid.mean = mean_of(light, side, size);
    const Curve& c = curve();
    for (int half = side / 2; half >= kLeastPyramid; half /= 2) {
        std::vector<std::uint16_t> next(texel(0, half, half));
        std::vector<std::uint8_t> codes(next.size(), 255);
        for (int y = 0; y < half; ++y) {
            const std::uint16_t* above = light.data() + texel(0, 2 * y, 2 * half);
            const std::uint16_t* below = above + texel(0, 1, 2 * half);
            for (int x = 0; x < half; ++x) {
                const std::size_t to = texel(x, y, half), from = 8 * static_cast<std::size_t>(x);
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t sum = std::uint32_t{above[from + k]} + above[from + 4 + k] +
                                              below[from + k] + below[from + 4 + k];
                    next[to + k] = static_cast<std::uint16_t>((sum + 2) / 4);
                    codes[to + k] = c.code[next[to + k] >> kCodeShift];
                }
            }
        }
        levels.push_back(std::move(codes));
        light = std::move(next);
    }
    pyramid.levels = std::make_shared<const std::vector<std::vector<std::uint8_t>>>(std::move(levels));
    return pyramid;
}

} // namespace ghost::image
