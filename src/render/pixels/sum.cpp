// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/sum.h"

#include "render/pixels/private/lanes.h"
#include "render/pixels/processor.h"
#include "shared/push.h"

#include <algorithm>
#include <functional>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

struct Weighted {
    const std::uint8_t* row;
    const float* weight; // rgb rgb 0 0
};

// Weights as lanes: rgb for each of the two halves of a texel.
std::vector<float> lanes_of(const std::vector<KeptImage>& kept) {
    std::vector<float> lanes;
    for (const KeptImage& image : kept) {
        const glm::vec3& w = image.weight;
        lanes.insert(lanes.end(), {w.r, w.g, w.b, w.r, w.g, w.b, 0.0f, 0.0f});
    }
    return lanes;
}

void rows_of(const ImageAddition& images, const std::vector<float>& lanes, int y,
             std::vector<Weighted>& rows) {
    rows.clear();
    for (std::size_t k = 0; k < images.kept.size(); ++k)
        rows.push_back(
            {images.kept[k].at + static_cast<std::size_t>(y) * images.kept_row_bytes, lanes.data() + 8 * k});
}

// Of so many texels side by side, 1 to 4.
constexpr int kTogether = 4;
VECTORS void add_kept(const std::vector<Weighted>& rows, int texel, int count, float* sums) {
    const std::size_t offset = kTexelBytes * static_cast<std::size_t>(texel);
    if (count == kTogether) {
        F8 a = _mm256_setzero_ps(), b = a, c = a, d = a;
        for (const Weighted& image : rows) {
            const F8 weight = _mm256_loadu_ps(image.weight);
            const std::uint8_t* at = image.row + offset;
            a = _mm256_fmadd_ps(load_halves(at), weight, a);
            b = _mm256_fmadd_ps(load_halves(at + kTexelBytes), weight, b);
            c = _mm256_fmadd_ps(load_halves(at + 2 * kTexelBytes), weight, c);
            d = _mm256_fmadd_ps(load_halves(at + 3 * kTexelBytes), weight, d);
        }
        _mm256_storeu_ps(sums, a);
        _mm256_storeu_ps(sums + 8, b);
        _mm256_storeu_ps(sums + 16, c);
        _mm256_storeu_ps(sums + 24, d);
        return;
    }
    for (int k = 0; k < count; ++k) {
        F8 sum = _mm256_setzero_ps();
        for (const Weighted& image : rows)
            sum = _mm256_fmadd_ps(load_halves(image.row + offset + kTexelBytes * static_cast<std::size_t>(k)),
                                  _mm256_loadu_ps(image.weight), sum);
        _mm256_storeu_ps(sums + std::ptrdiff_t{8} * k, sum);
    }
}

// Two pixels from x on; the right one may be beyond the border.
INLINE_VECTORS F8 load_pair(const std::uint8_t* row, int x, int width) {
    const std::uint8_t* at = row + kPixelBytes * static_cast<std::size_t>(x);
    return without_alpha(x + 1 < width ? load_halves(at) : load_four_halves(at));
}

// Every corner of a 2x2 block has its own offset along the ray (sum.comp).
VECTORS F8 mean_of_corners(const Plane& haze, int x, int y) {
    const int below = std::min(y + 1, haze.height - 1);
    const auto* here = haze.row(y);
    const auto* next = haze.row(below);
    F8 sum = _mm256_add_ps(load_pair(here, x, haze.width), load_pair(next, x, haze.width));
    if (x + 2 < haze.width) {
        sum = _mm256_add_ps(sum, load_pair(here, x + 1, haze.width));
        sum = _mm256_add_ps(sum, load_pair(next, x + 1, haze.width));
    } else { // the last pixel is its own neighbour
        const int last = haze.width - 1, right = std::min(x + 1, last);
        const F8 pair =
            _mm256_add_ps(_mm256_set_m128(_mm256_castps256_ps128(load_pair(here, last, haze.width)),
                                          _mm256_castps256_ps128(load_pair(here, right, haze.width))),
                          _mm256_set_m128(_mm256_castps256_ps128(load_pair(next, last, haze.width)),
                                          _mm256_castps256_ps128(load_pair(next, right, haze.width))));
        sum = _mm256_add_ps(sum, pair);
    }
    return _mm256_mul_ps(_mm256_set1_ps(0.25f), sum);
}

struct ColumnRange {
    int from = 0;
    int to = 0; // beyond the last one
};

// Of a row of pixels: to the frame, or to a kept image.
VECTORS void add_pixel_row(const ImageAddition& images, const std::vector<Weighted>& rows, const Plane& base,
                           int width, const Plane& frame, const Plane& kept, int y,
                           const ColumnRange& columns) {
    const int texels = (columns.to + 1) / 2;
    float sums[8 * kTogether];
    for (int first = columns.from / 2; first < texels; first += kTogether) {
        const int count = std::min(kTogether, texels - first);
        add_kept(rows, first, count, sums);
        for (int k = 0; k < count; ++k) {
            const int x = 2 * (first + k);
            F8 sum = spread_six(_mm256_loadu_ps(sums + std::ptrdiff_t{8} * k));
            if (base) sum = _mm256_add_ps(sum, load_pair(base.row(y), x, width));
            for (const DrawnLights& drawn : images.drawn) {
                sum = _mm256_add_ps(sum, load_pair(drawn.surfaces.row(y), x, width));
                sum = _mm256_add_ps(sum, images.corners ? mean_of_corners(drawn.haze, x, y)
                                                        : load_pair(drawn.haze.row(y), x, width));
            }
            if (kept) {
                store_halves(kept.row(y) + kTexelBytes * static_cast<std::size_t>(first + k),
                             to_six(to_store(sum)));
                continue;
            }
            std::uint8_t* to = frame.row(y) + kPixelBytes * static_cast<std::size_t>(x);
            if (x + 1 < width)
                store_halves(to, to_store(sum));
            else
                store_four_halves(to, to_store(sum));
        }
    }
}

VECTORS void add_point_row(const ImageAddition& images, const std::vector<Weighted>& rows, const Plane& white,
                           const Plane& points, int y, const ColumnRange& columns) {
    const __m128 one = _mm_set1_ps(1.0f);
    float sums[8 * kTogether];
    for (int first = columns.from; first < columns.to; first += kTogether) {
        const int count = std::min(kTogether, columns.to - first);
        add_kept(rows, first, count, sums);
        for (int k = 0; k < count; ++k) {
            const std::size_t x = static_cast<std::size_t>(first) + static_cast<std::size_t>(k);
            F8 sum = spread_six(_mm256_loadu_ps(sums + std::ptrdiff_t{8} * k));
            for (const DrawnLights& drawn : images.drawn) {
                const __m128 light =
                    _mm256_castps256_ps128(load_four_halves(drawn.surfaces.row(y) + kPixelBytes * x));
                const __m128 haze =
                    _mm256_castps256_ps128(load_four_halves(drawn.haze.row(y) + kPixelBytes * x));
                sum = _mm256_add_ps(sum, without_alpha(_mm256_set_m128(haze, light)));
            }
            if (white) {
                const __m128 by =
                    _mm_loadu_ps(reinterpret_cast<const float*>(white.row(y) + kTexelBytes * x));
                sum = without_alpha(_mm256_mul_ps(sum, _mm256_set_m128(one, by)));
            }
            store_halves(points.row(y) + kTexelBytes * x, to_six(to_store(sum)));
        }
    }
}

void each_sum(const ImageAddition& images, int width, int height,
              const std::function<void(const std::vector<Weighted>&, int y, const ColumnRange&)>& row) {
    const std::vector<float> lanes = lanes_of(images.kept);
    each_rows(height, [&](int from, int to) {
        std::vector<Weighted> rows;
        for (int y = from; y < to; ++y) {
            rows_of(images, lanes, y, rows);
            if (images.parts.empty()) row(rows, y, {0, width});
            for (const PlanePart& part : images.parts)
                if (y >= part.y0 && y < part.y1)
                    row(rows, y, {std::max(part.x0, 0), std::min(part.x1, width)});
        }
    });
}

} // namespace

void add_pixels(const ImageAddition& images, const Plane& base, const Plane& frame) {
    each_sum(images, frame.width, frame.height,
             [&](const std::vector<Weighted>& rows, int y, const ColumnRange& columns) {
                 add_pixel_row(images, rows, base, frame.width, frame, {}, y, columns);
             });
}

void keep_pixels(const ImageAddition& images, const Plane& base, int width, const Plane& kept) {
    each_sum(images, width, kept.height,
             [&](const std::vector<Weighted>& rows, int y, const ColumnRange& columns) {
                 add_pixel_row(images, rows, base, width, {}, kept, y, columns);
             });
}

void add_points(const ImageAddition& images, const Plane& white, const Plane& points) {
    each_sum(images, points.width, points.height,
             [&](const std::vector<Weighted>& rows, int y, const ColumnRange& columns) {
                 add_point_row(images, rows, white, points, y, columns);
             });
}

} // namespace ghost::render
#endif
