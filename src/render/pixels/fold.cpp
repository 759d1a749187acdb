// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/fold.h"

#include "render/pixels/private/lanes.h"
#include "render/pixels/processor.h"
#include "shared/push.h"

#include <algorithm>
#include <cstring>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

constexpr std::size_t kEntryBytes = 8, kSourceBytes = 2;
constexpr int kEntriesTogether = 64;

INLINE_VECTORS __m128 load_pixel(const Plane& plane, int x, int y) {
    return _mm256_castps256_ps128(load_four_halves(plane.row(y) + kPixelBytes * static_cast<std::size_t>(x)));
}

INLINE_VECTORS __m128 haze_of(const FragmentPlanes& f, const Plane& haze, int x, int y) {
    const __m128 here = load_pixel(haze, x, y);
    if (!f.corners) return here;
    const int right = std::min(x + 1, f.width - 1), below = std::min(y + 1, f.height - 1);
    const __m128 sum = _mm_add_ps(_mm_add_ps(here, load_pixel(haze, right, y)),
                                  _mm_add_ps(load_pixel(haze, x, below), load_pixel(haze, right, below)));
    return _mm_mul_ps(_mm_set1_ps(0.25f), sum);
}

VECTORS void fold_entry(const FragmentPlanes& f, std::uint32_t i) {
    const auto width = static_cast<std::uint32_t>(f.width);
    const int row = static_cast<int>(i / width);
    const std::size_t column = i % width;
    struct {
        std::uint32_t pixel, list;
    } edge{};
    std::memcpy(&edge, f.edges.row(row) + kEntryBytes * column, sizeof edge);
    const std::uint32_t count = edge.list & 3u, first = edge.list >> 2;
    if (count == 0) return; // room for an edge
    const int x = static_cast<int>(edge.pixel % width), y = static_cast<int>(edge.pixel / width);
    if (y >= f.height) return;
    std::uint16_t sources = 0;
    std::memcpy(&sources, f.sources.row(row) + kSourceBytes * column, sizeof sources);
    __m128 sum = _mm_setzero_ps();
    for (const DrawnLights& drawn : f.drawn) {
        const __m128 here = drawn.haze ? haze_of(f, drawn.haze, x, y) : _mm_setzero_ps();
        std::uint8_t* own = drawn.surfaces.row(y) + kPixelBytes * static_cast<std::size_t>(x);
        sum = _mm_add_ps(sum, load_pixel(drawn.surfaces, x, y));
        store_four_halves(own, _mm256_setzero_ps());
        std::uint16_t source = sources;
        for (std::uint32_t k = first; k < first + count; ++k) {
            const int extra_x = static_cast<int>(k % width), extra_y = f.height + static_cast<int>(k / width);
            sum = _mm_add_ps(sum, load_pixel(drawn.surfaces, extra_x, extra_y));
            if (!drawn.haze) continue;
            const int cell = source & 15;
            source = static_cast<std::uint16_t>(source >> 4);
            const int to_x = std::clamp(x + cell % 3 - 1, 0, f.width - 1);
            const int to_y = std::clamp(y + cell / 3 - 1, 0, f.height - 1);
            const __m128 place = _mm_loadu_ps(reinterpret_cast<const float*>(
                f.places.row(extra_y) + kTexelBytes * static_cast<std::size_t>(extra_x)));
            sum = _mm_fmadd_ps(_mm_permute_ps(place, 0xFF),
                               _mm_sub_ps(haze_of(f, drawn.haze, to_x, to_y), here), sum);
        }
    }
    store_four_halves(f.drawn.front().surfaces.row(y) + kPixelBytes * static_cast<std::size_t>(x),
                      to_store(_mm256_castps128_ps256(sum)));
}

VECTORS void fold_entries(const FragmentPlanes& f, int from, int to) {
    for (int i = from; i < to; ++i) fold_entry(f, static_cast<std::uint32_t>(i));
}

} // namespace

void fold_fragments(const FragmentPlanes& fragments) {
    const int count = static_cast<int>(fragments.edge_count);
    if (!fragments.parts.empty()) {
        each_rows(static_cast<int>(fragments.parts.size()), [&](int from, int to) {
            for (int k = from; k < to; ++k) {
                const FragmentPlanes::Edges& part = fragments.parts[static_cast<std::size_t>(k)];
                fold_entries(fragments, static_cast<int>(part.first),
                             static_cast<int>(part.first + part.count));
            }
        });
        return;
    }
    each_rows((count + kEntriesTogether - 1) / kEntriesTogether, [&](int from, int to) {
        fold_entries(fragments, from * kEntriesTogether, std::min(to * kEntriesTogether, count));
    });
}

} // namespace ghost::render
#endif
