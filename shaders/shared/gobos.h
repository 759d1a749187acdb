#pragma once
// SPDX-License-Identifier: Apache-2.0
// Gobos: the images in all gates of a show, as a stack of square layers with mip levels. Nine bits a colour and an exponent that
// they share: what is dark is as exact as what is bright, at the size of 8 bits. Level k holds the image
// averaged over a disc of radius kGoboBlurUnit 2^k gate units (averaged inside the gate only: the aperture is the beam's
// business). Layer 0 is open. C++ samples it as the shaders' sampler does: trilinear, clamped. Values only.
#ifdef __cplusplus
#include "shared/types.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace ghost::shared {

inline constexpr int kGoboSize = 256;
inline constexpr int kGoboLevels = 7; // 256 .. 4
inline constexpr float kGoboBlurUnit = 2.0f / kGoboSize;

// A moving picture as it is now: square, RGBA8 in sRGB with the primaries of Rec.709, level n averaged over 2^n texels. Empty: black.
struct SlidePicture {
    int side = 0;
    std::shared_ptr<const std::vector<std::vector<std::uint8_t>>> levels;
};

struct Gobos {
    std::vector<SlidePicture> slides; // C++ only: shaders have a texture of their own
    int layers = 0;
    // texels[level]: layers x side x side gobo_code, side = kGoboSize >> level.
    std::vector<std::uint32_t> texels[kGoboLevels];
};

// VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, of 0..1.
inline std::uint32_t gobo_code(const vec3& rgb) {
    const vec3 c = glm::clamp(rgb, vec3(0.0f), vec3(1.0f));
    int exponent = 0;
    (void)std::frexp(std::max({c.x, c.y, c.z}), &exponent);
    exponent = std::max(exponent, -15);
    const auto mantissa = [&](float value) {
        return static_cast<std::uint32_t>(std::lround(std::ldexp(value, 9 - exponent)));
    };
    if (std::max({mantissa(c.x), mantissa(c.y), mantissa(c.z)}) > 511u) ++exponent; // rounded up to the next power of two
    return mantissa(c.x) | mantissa(c.y) << 9 | mantissa(c.z) << 18 | static_cast<std::uint32_t>(exponent + 15) << 27;
}

inline vec3 gobo_light(std::uint32_t code) {
    return vec3(code & 511u, code >> 9 & 511u, code >> 18 & 511u) * std::ldexp(1.0f, static_cast<int>(code >> 27) - 24);
}

inline vec3 gobo_texel(const Gobos& gobos, int level, uint layer, int x, int y) {
    const int side = kGoboSize >> level;
    x = std::clamp(x, 0, side - 1);
    y = std::clamp(y, 0, side - 1);
    const std::size_t at = (static_cast<std::size_t>(layer) * static_cast<std::size_t>(side) + static_cast<std::size_t>(y)) *
                               static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
    return gobo_light(gobos.texels[level][at]);
}

inline vec3 gobo_bilinear(const Gobos& gobos, int level, uint layer, vec2 uv) {
    const float side = static_cast<float>(kGoboSize >> level);
    const float x = uv.x * side - 0.5f;
    const float y = uv.y * side - 0.5f;
    const float x0 = std::floor(x);
    const float y0 = std::floor(y);
    const int ix = static_cast<int>(x0);
    const int iy = static_cast<int>(y0);
    const float fx = x - x0;
    const float fy = y - y0;
    const vec3 top = gobo_texel(gobos, level, layer, ix, iy) * (1 - fx) + gobo_texel(gobos, level, layer, ix + 1, iy) * fx;
    const vec3 bottom =
        gobo_texel(gobos, level, layer, ix, iy + 1) * (1 - fx) + gobo_texel(gobos, level, layer, ix + 1, iy + 1) * fx;
    return top * (1 - fy) + bottom * fy;
}

// The same texture coordinates and level as gobo_sample in shaders/common/gobo_texture.glsl.
inline vec3 gobo_sample(uint layer, vec2 gate, float blur, const Gobos& gobos) {
    if (layer == 0u || static_cast<int>(layer) >= gobos.layers) return vec3(1.0f);
    const vec2 uv = glm::clamp(gate * vec2(0.5f, -0.5f) + vec2(0.5f), vec2(0.0f), vec2(1.0f));
    const float level = std::clamp(std::log2(std::max(blur / kGoboBlurUnit, 1.0f)), 0.0f, kGoboLevels - 1.0f);
    const int low = static_cast<int>(level);
    const int high = std::min(low + 1, kGoboLevels - 1);
    const float f = level - static_cast<float>(low);
    return gobo_bilinear(gobos, low, layer, uv) * (1 - f) + gobo_bilinear(gobos, high, layer, uv) * f;
}

inline float slide_linear(std::uint8_t encoded) {
    const float value = static_cast<float>(encoded) * (1.0f / 255.0f);
    return value <= 0.04045f ? value * (1.0f / 12.92f) : std::pow((value + 0.055f) * (1.0f / 1.055f), 2.4f);
}

inline vec3 slide_bilinear(const SlidePicture& picture, std::size_t level, vec2 uv) {
    const int side = std::max(picture.side >> level, 1);
    const vec2 place = uv * static_cast<float>(side) - vec2(0.5f);
    const vec2 corner = glm::floor(place);
    const vec2 part = place - corner;
    vec3 sum(0.0f);
    for (int k = 0; k < 4; ++k) {
        const int x = std::clamp(static_cast<int>(corner.x) + k % 2, 0, side - 1);
        const int y = std::clamp(static_cast<int>(corner.y) + k / 2, 0, side - 1);
        const std::uint8_t* t = &(*picture.levels)[level][4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                                                            static_cast<std::size_t>(x))];
        sum += vec3(slide_linear(t[0]), slide_linear(t[1]), slide_linear(t[2])) *
               ((k % 2 == 1 ? part.x : 1.0f - part.x) * (k / 2 == 1 ? part.y : 1.0f - part.y));
    }
    return sum;
}

// As slide_sample in shaders/common/gobo_texture.glsl.
inline vec3 slide_sample(uint layer, vec2 place, float radius_texels, const Gobos& gobos) {
    if (layer > gobos.slides.size() || !gobos.slides[layer - 1].levels) return vec3(0.0f);
    const SlidePicture& picture = gobos.slides[layer - 1];
    const vec2 uv = place * vec2(0.5f, -0.5f) + vec2(0.5f);
    const float top = static_cast<float>(picture.levels->size() - 1);
    const float level = std::clamp(std::log2(std::max(radius_texels, 1.0f)), 0.0f, top);
    const auto low = static_cast<std::size_t>(level);
    const std::size_t high = std::min(low + 1, picture.levels->size() - 1);
    const vec3 rgb = glm::mix(slide_bilinear(picture, low, uv), slide_bilinear(picture, high, uv), level - static_cast<float>(low));
    return glm::mat3(0.627404f, 0.069097f, 0.016391f, 0.329283f, 0.919540f, 0.088013f, 0.043313f, 0.011362f, 0.895595f) * rgb;
}

} // namespace ghost::shared
#endif
