// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/mip_levels.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
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

// Mean normals: the more they differ, the shorter.
struct Normals {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> mean;

    const glm::vec3& at(int x, int y) const {
        return mean[static_cast<std::size_t>(std::min(y, height - 1) * width + std::min(x, width - 1))];
    }
};

Normals normals_of(const image::Image8& pixels) {
    Normals normals{pixels.width, pixels.height, {}};
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const std::uint8_t* texel = pixels.at(x, y);
            const glm::vec3 map = glm::vec3(texel[0], texel[1], texel[2]) / 127.5f - 1.0f;
            const float length = glm::length(map);
            normals.mean.push_back(length > 1e-3f ? map / length : glm::vec3(0, 0, 1));
        }
    return normals;
}

Normals halved(const Normals& from) {
    Normals to{std::max(from.width / 2, 1), std::max(from.height / 2, 1), {}};
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            to.mean.push_back(0.25f * (from.at(2 * x, 2 * y) + from.at(2 * x + 1, 2 * y) +
                                       from.at(2 * x, 2 * y + 1) + from.at(2 * x + 1, 2 * y + 1)));
    return to;
}

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

image::Image8 encoded(const Normals& normals) {
    image::Image8 pixels(normals.width, normals.height, 4);
    for (std::size_t k = 0; k < normals.mean.size(); ++k) {
        const float length = std::clamp(glm::length(normals.mean[k]), 1e-3f, 1.0f);
        const glm::vec3 unit = normals.mean[k] / length;
        std::uint8_t* texel = pixels.samples.data() + 4 * k;
        for (int c = 0; c < 3; ++c) texel[c] = to_byte(0.5f + 0.5f * unit[c]);
        texel[3] = to_byte(std::sqrt((1.0f - length) / length));
    }
    return pixels;
}

} // namespace

std::vector<image::Image8> mip_levels(const image::Image8& pixels, TextureUse use, int first) {
    std::vector<image::Image8> levels;
    const bool bumps = use == TextureUse::bumps;
    Normals normals = bumps ? normals_of(pixels) : Normals{};
    image::Image8 level = pixels;
    if (bumps)
        for (std::size_t k = 3; k < level.samples.size(); k += 4) level.samples[k] = 0;
    for (int k = 0;; ++k) {
        const bool last = level.width == 1 && level.height == 1;
        if (bumps && !last) normals = halved(normals);
        image::Image8 next = last    ? image::Image8()
                             : bumps ? encoded(normals)
                                     : halved(level, use == TextureUse::colour);
        if (k >= first || last) levels.push_back(std::move(level));
        if (last) return levels;
        level = std::move(next);
    }
}

} // namespace ghost::render
