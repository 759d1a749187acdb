// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/mip_levels.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <utility>

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

void each_row(int height, const std::function<void(int y)>& row) {
    constexpr int kRowsTogether = 16;
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsTogether), [&](const auto& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y) row(y);
    });
}

image::Image8 halved(const image::Image8& from, bool srgb) {
    static const Tables tables;
    image::Image8 to(std::max(from.width / 2, 1), std::max(from.height / 2, 1), from.channels);
    each_row(to.height, [&](int y) {
        const std::uint8_t* const above = from.at(0, std::min(2 * y, from.height - 1));
        const std::uint8_t* const below = from.at(0, std::min(2 * y + 1, from.height - 1));
        std::uint8_t* mean = to.at(0, y);
        for (int x = 0; x < to.width; ++x, mean += from.channels) {
            const int left = from.channels * std::min(2 * x, from.width - 1);
            const int right = from.channels * std::min(2 * x + 1, from.width - 1);
            for (int c = 0; c < from.channels; ++c) {
                const std::array<std::uint8_t, 4> texels{above[left + c], above[right + c], below[left + c],
                                                         below[right + c]};
                if (srgb && c < 3) {
                    float light = 0;
                    for (const std::uint8_t texel : texels) light += tables.to_light[texel];
                    mean[c] = tables.to_srgb[static_cast<std::size_t>(
                        std::lround(light * 0.25f * static_cast<float>(kSteps)))];
                } else {
                    int sum = 2;
                    for (const std::uint8_t texel : texels) sum += texel;
                    mean[c] = static_cast<std::uint8_t>(sum / 4);
                }
            }
        }
    });
    return to;
}

// Mean normals: the more they differ, the shorter.
struct Normals {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> mean;

    const glm::vec3& at(int x, int y) const {
        return mean[static_cast<std::size_t>(std::min(y, height - 1) * width + std::min(x, width - 1))];
    }
};

glm::vec3 normal_at(const image::Image8& pixels, int x, int y) {
    const std::uint8_t* texel = pixels.at(std::min(x, pixels.width - 1), std::min(y, pixels.height - 1));
    const glm::vec3 map = glm::vec3(texel[0], texel[1], texel[2]) / 127.5f - 1.0f;
    const float length = glm::length(map);
    return length > 1e-3f ? map / length : glm::vec3(0, 0, 1);
}

// Of those that normal(x, y) gives; beyond its edges it repeats them.
template <class Normal>
Normals halved(int width, int height, const Normal& normal) {
    Normals to{std::max(width / 2, 1), std::max(height / 2, 1), {}};
    to.mean.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
    each_row(to.height, [&](int y) {
        glm::vec3* mean = to.mean.data() + static_cast<std::ptrdiff_t>(y) * to.width;
        for (int x = 0; x < to.width; ++x)
            mean[x] = 0.25f * (normal(2 * x, 2 * y) + normal(2 * x + 1, 2 * y) + normal(2 * x, 2 * y + 1) +
                               normal(2 * x + 1, 2 * y + 1));
    });
    return to;
}

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

image::Image8 encoded(const Normals& normals) {
    image::Image8 pixels(normals.width, normals.height, 4);
    each_row(normals.height, [&](int y) {
        std::uint8_t* texel = pixels.at(0, y);
        for (int x = 0; x < normals.width; ++x, texel += 4) {
            const glm::vec3& mean = normals.at(x, y);
            const float length = std::clamp(glm::length(mean), 1e-3f, 1.0f);
            const glm::vec3 unit = mean / length;
            for (int c = 0; c < 3; ++c) texel[c] = to_byte(0.5f + 0.5f * unit[c]);
            texel[3] = to_byte(std::sqrt((1.0f - length) / length));
        }
    });
    return pixels;
}

} // namespace

std::vector<image::Image8> mip_levels(const image::Image8& pixels, TextureUse use, int first) {
    std::vector<image::Image8> levels;
    const bool bumps = use == TextureUse::bumps;
    Normals normals;
    image::Image8 level = pixels;
    if (bumps)
        for (std::size_t k = 3; k < level.samples.size(); k += 4) level.samples[k] = 0;
    for (int k = 0;; ++k) {
        const bool last = level.width == 1 && level.height == 1;
        if (bumps && !last)
            normals = k == 0 ? halved(pixels.width, pixels.height,
                                      [&](int x, int y) { return normal_at(pixels, x, y); })
                             : halved(normals.width, normals.height,
                                      [&](int x, int y) { return normals.at(x, y); });
        image::Image8 next = last    ? image::Image8()
                             : bumps ? encoded(normals)
                                     : halved(level, use == TextureUse::colour);
        if (k >= first || last) levels.push_back(std::move(level));
        if (last) return levels;
        level = std::move(next);
    }
}

} // namespace ghost::render
