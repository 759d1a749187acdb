// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/spread.h"

#include "render/pixels/private/lanes.h"
#include "render/pixels/processor.h"
#include "shared/coarse.h"
#include "shared/push.h"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

constexpr std::size_t kEdge = 8;
constexpr int kEdgesTogether = 64;

INLINE_VECTORS __m128i load_words(const std::uint8_t* at) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
}

// Light in the lower half, haze in the upper one.
INLINE_VECTORS F8 load_point(const std::uint8_t* row, int x, int last) {
    return spread_six(load_halves(row + kTexelBytes * static_cast<std::size_t>(std::clamp(x, 0, last))));
}

// Eight bytes to eight lanes, 0 to 1.
INLINE_VECTORS F8 weights_of(__m128i bytes) {
    return _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes)), _mm256_set1_ps(1.0f / 255.0f));
}

// weights: of the four points for light, then for haze.
INLINE_VECTORS F8 weigh(F8 weights, F8 a, F8 b, F8 c, F8 d) {
    F8 sum = _mm256_mul_ps(_mm256_permute_ps(weights, 0x00), a);
    sum = _mm256_fmadd_ps(_mm256_permute_ps(weights, 0x55), b, sum);
    sum = _mm256_fmadd_ps(_mm256_permute_ps(weights, 0xAA), c, sum);
    return _mm256_fmadd_ps(_mm256_permute_ps(weights, 0xFF), d, sum);
}

// The two pixels of a row of a cell. left, right: weighed for each; words: what they reflect, in lanes.
INLINE_VECTORS void put_pair(F8 left, F8 right, I8 words, const std::uint8_t* base, std::uint8_t* frame,
                             int x, int width) {
    const F8 light = _mm256_permute2f128_ps(left, right, 0x20);
    const F8 haze = _mm256_permute2f128_ps(left, right, 0x31);
    F8 sum = without_alpha(_mm256_fmadd_ps(light, unpack_shared_exponents(words), haze));
    const auto offset = static_cast<std::ptrdiff_t>(kPixelBytes) * x;
    if (x >= 0 && x + 1 < width) {
        if (base) sum = _mm256_add_ps(sum, without_alpha(load_halves(base + offset)));
        store_halves(frame + offset, to_store(sum));
        return;
    }
    // One of them is beyond the border.
    const bool is_left = x >= 0;
    if (is_left ? x >= width : x + 1 >= width) return;
    const std::ptrdiff_t at = is_left ? offset : offset + static_cast<std::ptrdiff_t>(kPixelBytes);
    F8 one = is_left ? sum : _mm256_permute2f128_ps(sum, sum, 0x11);
    if (base) one = _mm256_add_ps(one, without_alpha(load_four_halves(base + at)));
    store_four_halves(frame + at, to_store(one));
}

VECTORS void spread_row(const CoarsePlanes& coarse, const Plane& base, const Plane& frame, int cell_y) {
    const int last = coarse.points.width - 1;
    const std::uint8_t* above = coarse.points.row(std::clamp(cell_y - 1, 0, coarse.points.height - 1));
    const std::uint8_t* below = coarse.points.row(std::clamp(cell_y, 0, coarse.points.height - 1));
    const int y = 2 * cell_y - 1;
    const bool upper = y >= 0 && y < frame.height, lower = y + 1 < frame.height;
    const std::uint8_t* upper_base = base && upper ? base.row(y) : nullptr;
    const std::uint8_t* lower_base = base && lower ? base.row(y + 1) : nullptr;
    const I8 first_two = _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1);
    const I8 last_two = _mm256_setr_epi32(2, 2, 2, 2, 3, 3, 3, 3);
    F8 a = load_point(above, -1, last), c = load_point(below, -1, last);
    for (int cell = 0; cell <= last + 1; ++cell) {
        const F8 b = load_point(above, cell, last), d = load_point(below, cell, last);
        const std::size_t offset = kTexelBytes * static_cast<std::size_t>(cell);
        const __m128i surfaces = load_words(coarse.surfaces.row(cell_y) + offset),
                      hazes = load_words(coarse.hazes.row(cell_y) + offset);
        const I8 reflects = _mm256_broadcastsi128_si256(load_words(coarse.reflects.row(cell_y) + offset));
        const __m128i up = _mm_unpacklo_epi32(surfaces, hazes), down = _mm_unpackhi_epi32(surfaces, hazes);
        const int x = 2 * cell - 1;
        if (upper)
            put_pair(
                weigh(weights_of(up), a, b, c, d), weigh(weights_of(_mm_unpackhi_epi64(up, up)), a, b, c, d),
                _mm256_permutevar8x32_epi32(reflects, first_two), upper_base, frame.row(y), x, frame.width);
        if (lower)
            put_pair(weigh(weights_of(down), a, b, c, d),
                     weigh(weights_of(_mm_unpackhi_epi64(down, down)), a, b, c, d),
                     _mm256_permutevar8x32_epi32(reflects, last_two), lower_base, frame.row(y + 1), x,
                     frame.width);
        a = b;
        c = d;
    }
}

template <class Value>
Value value_at(const std::uint8_t* at) {
    Value value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

struct Extra {
    std::uint32_t surface;
    std::uint32_t haze;
    std::uint32_t reflects;
    float fraction;
};

VECTORS void fold_edge(const CoarsePlanes& coarse, const Plane& frame, std::uint32_t i) {
    const auto width = static_cast<std::uint32_t>(frame.width);
    const std::uint8_t* entry = coarse.edges.row(static_cast<int>(i / width)) + kEdge * (i % width);
    const auto pixel = value_at<std::uint32_t>(entry), list = value_at<std::uint32_t>(entry + 4);
    const std::uint32_t count = list & 3u;
    if (count == 0) return; // room for an edge
    const int x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
    if (y >= frame.height) return;
    const int cell_x = (x + 1) / 2, cell_y = (y + 1) / 2;
    const int last_x = coarse.points.width - 1, last_y = coarse.points.height - 1;
    const std::uint8_t* above = coarse.points.row(std::clamp(cell_y - 1, 0, last_y));
    const std::uint8_t* below = coarse.points.row(std::clamp(cell_y, 0, last_y));
    const F8 a = load_point(above, cell_x - 1, last_x), b = load_point(above, cell_x, last_x),
             c = load_point(below, cell_x - 1, last_x), d = load_point(below, cell_x, last_x);
    const std::size_t k = ((x + 1) % 2 == 0 ? 0u : 1u) + ((y + 1) % 2 == 0 ? 0u : 2u);
    const auto main_haze = value_at<std::uint32_t>(coarse.hazes.row(cell_y) +
                                                   kTexelBytes * static_cast<std::size_t>(cell_x) + 4 * k);
    // The haze of the main fragment, as what is taken away: no weight for light.
    const F8 main = weights_of(_mm_set_epi32(0, 0, static_cast<int>(main_haze), 0));
    std::uint8_t* to = frame.row(y) + kPixelBytes * static_cast<std::size_t>(x);
    F8 sum = load_four_halves(to);
    for (std::uint32_t n = list >> 2; n < (list >> 2) + count; ++n) {
        const auto extra =
            value_at<Extra>(coarse.extras.row(static_cast<int>(n / width)) + kTexelBytes * (n % width));
        const F8 weights =
            weights_of(_mm_set_epi32(0, 0, static_cast<int>(extra.haze), static_cast<int>(extra.surface)));
        const __m128 fraction = _mm_set1_ps(extra.fraction), one = _mm_set1_ps(1.0f);
        const F8 part = _mm256_mul_ps(_mm256_sub_ps(weights, main), _mm256_set_m128(fraction, one));
        const F8 both = weigh(part, a, b, c, d);
        const F8 reflects = unpack_shared_exponents(_mm256_set1_epi32(static_cast<int>(extra.reflects)));
        sum = _mm256_add_ps(sum, _mm256_fmadd_ps(both, reflects, _mm256_permute2f128_ps(both, both, 0x11)));
    }
    sum = _mm256_max_ps(to_store(sum), _mm256_setzero_ps());
    store_four_halves(to, without_alpha(sum));
}

VECTORS void fold_edges(const CoarsePlanes& coarse, const Plane& frame, int from, int to) {
    for (int i = from; i < to; ++i) fold_edge(coarse, frame, static_cast<std::uint32_t>(i));
}

} // namespace

void spread_points(const CoarsePlanes& coarse, const Plane& base, const Plane& frame) {
    each_rows(coarse.points.height + 1, [&](int from, int to) {
        for (int y = from; y < to; ++y) spread_row(coarse, base, frame, y);
    });
}

void fold_extras(const CoarsePlanes& coarse, const Plane& frame) {
    const int count = static_cast<int>(coarse.edge_count);
    each_rows((count + kEdgesTogether - 1) / kEdgesTogether, [&](int from, int to) {
        fold_edges(coarse, frame, from * kEdgesTogether, std::min(to * kEdgesTogether, count));
    });
}

} // namespace ghost::render
#endif
