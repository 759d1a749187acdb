#pragma once
// SPDX-License-Identifier: Apache-2.0
// gobo_sample and slide_sample of shared/gobos.h for eight pixels at once. Only within functions that are
// VECTORS.

#include "render/pixels/private/lane_types.h"
#include "shared/gobos.h"

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
namespace ghost::shared::lanes {

// The four texels round each place: of its level, where the upper left one is, from there to the others.
struct Footprint {
    alignas(32) int level[8], first[8], right[8], below[8];
    real weight[4]; // upper left, upper right, lower left, lower right
};

INLINE_VECTORS I8 whole(real a) {
    return _mm256_cvtps_epi32(a.v);
}

// u, v: 0..1 of the picture; side: of the level; first_row: of the layer.
INLINE_VECTORS Footprint footprint(real u, real v, real level, I8 side, I8 first_row) {
    const real size = _mm256_cvtepi32_ps(side);
    const real x = u * size - 0.5f, y = v * size - 0.5f;
    const real x0 = floor(x), y0 = floor(y);
    const real fx = x - x0, fy = y - y0;
    const I8 zero = _mm256_setzero_si256(), one = _mm256_set1_epi32(1), last = _mm256_sub_epi32(side, one);
    const I8 left = _mm256_max_epi32(whole(x0), zero), top = _mm256_max_epi32(whole(y0), zero);
    const I8 right = _mm256_min_epi32(_mm256_add_epi32(whole(x0), one), last);
    const I8 bottom = _mm256_min_epi32(_mm256_add_epi32(whole(y0), one), last);
    const I8 first = _mm256_add_epi32(_mm256_mullo_epi32(_mm256_add_epi32(first_row, top), side), left);
    Footprint places;
    _mm256_store_si256(reinterpret_cast<I8*>(places.level), whole(level));
    _mm256_store_si256(reinterpret_cast<I8*>(places.first), first);
    _mm256_store_si256(reinterpret_cast<I8*>(places.right), _mm256_sub_epi32(right, left));
    _mm256_store_si256(reinterpret_cast<I8*>(places.below),
                       _mm256_mullo_epi32(_mm256_sub_epi32(bottom, top), side));
    places.weight[0] = (1.0f - fx) * (1.0f - fy);
    places.weight[1] = fx * (1.0f - fy);
    places.weight[2] = (1.0f - fx) * fy;
    places.weight[3] = fx * fy;
    return places;
}

// level: whole numbers, as below.
INLINE_VECTORS vec3 gobo_bilinear(const Gobos& gobos, uint layer, real u, real v, real level) {
    const I8 side = _mm256_srlv_epi32(_mm256_set1_epi32(kGoboSize), whole(level));
    const I8 first_row = _mm256_mullo_epi32(_mm256_set1_epi32(static_cast<int>(layer)), side);
    const Footprint places = footprint(u, v, level, side, first_row);
    alignas(32) std::uint32_t words[4][8];
    for (int k = 0; k < 8; ++k) {
        const std::uint32_t* texel = gobos.texels[places.level[k]].data() + places.first[k];
        words[0][k] = texel[0];
        words[1][k] = texel[places.right[k]];
        words[2][k] = texel[places.below[k]];
        words[3][k] = texel[places.below[k] + places.right[k]];
    }
    const I8 digits = _mm256_set1_epi32(511);
    vec3 sum(0.0f);
    for (int k = 0; k < 4; ++k) { // as gobo_light
        const I8 word = _mm256_load_si256(reinterpret_cast<const I8*>(words[k]));
        const real r = _mm256_cvtepi32_ps(_mm256_and_si256(word, digits));
        const real g = _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srli_epi32(word, 9), digits));
        const real b = _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srli_epi32(word, 18), digits));
        sum += vec3(r, g, b) * (places.weight[k] * real(render::unit_of_shared_exponents(word)));
    }
    return sum;
}

inline VECTORS vec3 gobo_sample(uint layer, const vec2& gate, real blur, const Gobos& gobos) {
    if (layer == 0u || static_cast<int>(layer) >= gobos.layers) return vec3(1.0f);
    const real u = clamp(gate.x * 0.5f + 0.5f, 0.0f, 1.0f), v = clamp(gate.y * -0.5f + 0.5f, 0.0f, 1.0f);
    constexpr float kTop = kGoboLevels - 1.0f;
    const real level = clamp(log2(max(blur * (1.0f / kGoboBlurUnit), 1.0f)), 0.0f, kTop);
    const real low = floor(level);
    const real part = level - low;
    const vec3 sharp = gobo_bilinear(gobos, layer, u, v, low);
    if (!any(part > 0.0f)) return sharp;
    return sharp * (1.0f - part) + gobo_bilinear(gobos, layer, u, v, min(low + 1.0f, kTop)) * part;
}

inline const std::array<float, 256>& slide_lights() {
    static const auto lights = [] {
        std::array<float, 256> table{};
        for (std::size_t k = 0; k < table.size(); ++k) table[k] = slide_linear(static_cast<std::uint8_t>(k));
        return table;
    }();
    return lights;
}

INLINE_VECTORS vec3 slide_bilinear(const SlidePicture& picture, const float* lights, real u, real v,
                                   real level) {
    const I8 side = _mm256_max_epi32(_mm256_srlv_epi32(_mm256_set1_epi32(picture.side), whole(level)),
                                     _mm256_set1_epi32(1));
    const Footprint places = footprint(u, v, level, side, _mm256_setzero_si256());
    alignas(32) float rgb[4][3][8];
    for (int k = 0; k < 8; ++k) {
        const auto level_of = static_cast<std::size_t>(places.level[k]);
        const std::uint8_t* texels = (*picture.levels)[level_of].data() + std::ptrdiff_t{4} * places.first[k];
        const std::ptrdiff_t right = std::ptrdiff_t{4} * places.right[k];
        const std::ptrdiff_t below = std::ptrdiff_t{4} * places.below[k];
        const std::ptrdiff_t ways[4] = {0, right, below, below + right};
        for (int corner = 0; corner < 4; ++corner)
            for (int c = 0; c < 3; ++c) rgb[corner][c][k] = lights[texels[ways[corner] + c]];
    }
    vec3 sum(0.0f);
    for (int k = 0; k < 4; ++k)
        sum += vec3(_mm256_load_ps(rgb[k][0]), _mm256_load_ps(rgb[k][1]), _mm256_load_ps(rgb[k][2])) *
               places.weight[k];
    return sum;
}

inline VECTORS vec3 slide_sample(uint layer, const vec2& place, real radius_texels, const Gobos& gobos) {
    if (layer > gobos.slides.size() || !gobos.slides[layer - 1].levels) return vec3(0.0f);
    const SlidePicture& picture = gobos.slides[layer - 1];
    const float* lights = slide_lights().data();
    const real u = clamp(place.x * 0.5f + 0.5f, 0.0f, 1.0f), v = clamp(place.y * -0.5f + 0.5f, 0.0f, 1.0f);
    const float top = static_cast<float>(picture.levels->size() - 1);
    const real level = clamp(log2(max(radius_texels, 1.0f)), 0.0f, top);
    const real low = floor(level);
    const real part = level - low;
    vec3 rgb = slide_bilinear(picture, lights, u, v, low);
    if (any(part > 0.0f))
        rgb = rgb * (1.0f - part) + slide_bilinear(picture, lights, u, v, min(low + 1.0f, top)) * part;
    return vec3(rgb.x * 0.627404f + rgb.y * 0.329283f + rgb.z * 0.043313f,
                rgb.x * 0.069097f + rgb.y * 0.919540f + rgb.z * 0.011362f,
                rgb.x * 0.016391f + rgb.y * 0.088013f + rgb.z * 0.895595f);
}

} // namespace ghost::shared::lanes
#endif
