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

// Texels of a row, four values each: as they are shown, and their light.
struct Row {
    std::uint8_t* codes;
    std::uint16_t* light;
};

// A row of the picture, from `left` on; its ends go on to the rim. Adds its light up.
void fill_row(const std::uint8_t* from, int width, int left, int side, const Row& to,
              std::array<std::uint64_t, 3>& sum) {
    const Curve& c = curve();
    std::array<std::uint32_t, 3> in_row{};
    Row at{to.codes + 4 * left, to.light + 4 * left};
    for (int x = 0; x < width; ++x, from += 4, at.codes += 4, at.light += 4) {
        for (std::size_t k = 0; k < 3; ++k) {
            at.codes[k] = from[k];
            at.light[k] = c.light[from[k]];
        }
        at.codes[3] = 255;
        if (from[3] != 255)
            for (std::size_t k = 0; k < 3; ++k) {
                at.light[k] = static_cast<std::uint16_t>(std::uint32_t{at.light[k]} * from[3] / 255);
                at.codes[k] = c.code[static_cast<std::size_t>(at.light[k]) >> kCodeShift];
            }
        for (std::size_t k = 0; k < 3; ++k) in_row[k] += at.light[k];
    }
    for (std::size_t k = 0; k < 3; ++k) sum[k] += in_row[k];
    const auto repeat = [&](int texel, int begin, int end) {
        for (int x = begin; x < end; ++x) {
            std::copy_n(to.codes + 4 * texel, 4, to.codes + 4 * x);
            std::copy_n(to.light + 4 * texel, 4, to.light + 4 * x);
        }
    };
    repeat(left, 0, left);
    repeat(left + width - 1, left + width, side);
}

// Two rows to one of half as many texels.
void halve_rows(const std::uint16_t* above, const std::uint16_t* below, int half, const Row& to) {
    const Curve& c = curve();
    Row at = to;
    for (int x = 0; x < half; ++x, above += 8, below += 8, at.codes += 4, at.light += 4) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t sum = std::uint32_t{above[k]} + above[k + 4] + below[k] + below[k + 4];
            at.light[k] = static_cast<std::uint16_t>((sum + 2) / 4);
            at.codes[k] = c.code[static_cast<std::size_t>(at.light[k]) >> kCodeShift];
        }
        at.codes[3] = 255;
    }
}

// Level 0 row by row, the picture in the middle and its rim beyond; the next level's light on the way, as all
// of level 0's would leave the cache before it is needed.
void place(const Image8& picture, int side, std::vector<std::uint8_t>& codes,
           std::vector<std::uint8_t>& half_codes, std::vector<std::uint16_t>& half_light, glm::vec3& mean) {
    const int left = (side - picture.width) / 2, top = (side - picture.height) / 2, half = side / 2;
    codes.resize(texel(0, side, side));
    half_codes.resize(texel(0, half, half));
    half_light.resize(half_codes.size());
    std::vector<std::uint16_t> pair(texel(0, 2, side));
    std::array<std::uint64_t, 3> sum{};
    int last = -1;
    for (int y = 0; y < side; ++y) {
        const Row row{codes.data() + texel(0, y, side), pair.data() + texel(0, y % 2, side)};
        const int from = std::clamp(y - top, 0, picture.height - 1);
        if (from == last) { // as the row above
            std::copy_n(row.codes - 4 * side, 4 * side, row.codes);
            std::copy_n(pair.data() + texel(0, 1 - y % 2, side), 4 * side, row.light);
        } else {
            fill_row(picture.at(0, from), picture.width, left, side, row, sum);
        }
        last = from;
        if (y % 2 == 1)
            halve_rows(
                pair.data(), pair.data() + texel(0, 1, side), half,
                {half_codes.data() + texel(0, y / 2, half), half_light.data() + texel(0, y / 2, half)});
    }
    mean = glm::vec3(glm::dvec3(sum[0], sum[1], sum[2]) / (65535.0 * picture.width * picture.height));
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
    std::vector<std::vector<std::uint8_t>> levels(2);
    std::vector<std::uint16_t> light;
    Pyramid pyramid;
    pyramid.side = side;
    pyramid.extent = glm::vec2(size) / static_cast<float>(side);
    place(size == glm::ivec2(rgba.width, rgba.height) ? rgba : resampled(rgba, size), side, levels[0],
          levels[1], light, pyramid.mean);
    for (int half = side / 4; half >= kLeastPyramid; half /= 2) {
        std::vector<std::uint16_t> next(texel(0, half, half));
        std::vector<std::uint8_t>& codes = levels.emplace_back(next.size());
        for (int y = 0; y < half; ++y)
            halve_rows(light.data() + texel(0, 2 * y, 2 * half), light.data() + texel(0, 2 * y + 1, 2 * half),
                       half, {codes.data() + texel(0, y, half), next.data() + texel(0, y, half)});
        light = std::move(next);
    }
    if (side / 2 < kLeastPyramid) levels.pop_back();
    pyramid.levels = std::make_shared<const std::vector<std::vector<std::uint8_t>>>(std::move(levels));
    return pyramid;
}

} // namespace ghost::image
