// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/glare.h"

#include "render/pixels/private/glare_rows.h"
#include "render/pixels/private/lanes.h"
#include "render/pixels/processor.h"
#include "shared/glare.h"
#include "shared/push.h"

#include <algorithm>
#include <array>
#include <vector>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

// Columns of four rows, 1 3 3 1, four floats each. exact: the coarse level is just half the fine one, which
// is mirrored at its border; else what lies beyond is dark.
class Columns {
public:
    Columns(const Plane& fine, const Plane& coarse)
        : width_(fine.width), end_(2 * coarse.width + 2), exact_(2 * coarse.width == fine.width),
          exact_rows_(2 * coarse.height == fine.height),
          sums_(4 * (static_cast<std::size_t>(end_) + 1), 0.0f) {}

    // For row y of the coarse level.
    VECTORS void sum(const Plane& fine, int y, bool of_frame) {
        const std::array<float, 4> weights{1, 3, 3, 1};
        std::array<const std::uint8_t*, 4> rows{};
        std::array<float, 4> by{};
        for (int k = 0; k < 4; ++k) {
            const int row = 2 * y - 1 + k;
            const auto n = static_cast<std::size_t>(k);
            rows[n] = fine.row(std::clamp(row, 0, fine.height - 1));
            by[n] = exact_rows_ || row < fine.height ? weights[n] : 0.0f;
        }
        float* to = sums_.data() + 4; // of column 0
        int x = 0;
        for (; x + 2 <= width_; x += 2, to += 8) {
            F8 all = _mm256_setzero_ps();
            for (std::size_t n = 0; n < 4; ++n) {
                const F8 stored = load_halves(rows[n] + kPixelBytes * static_cast<std::size_t>(x));
                all = _mm256_fmadd_ps(of_frame ? light_of_frame(stored) : stored, _mm256_set1_ps(by[n]), all);
            }
            _mm256_storeu_ps(to, all);
        }
        if (x < width_) {
            F8 all = _mm256_setzero_ps();
            for (std::size_t n = 0; n < 4; ++n) {
                const F8 stored = load_four_halves(rows[n] + kPixelBytes * static_cast<std::size_t>(x));
                all = _mm256_fmadd_ps(of_frame ? light_of_frame(stored) : stored, _mm256_set1_ps(by[n]), all);
            }
            _mm_storeu_ps(to, _mm256_castps256_ps128(all));
        }
        _mm_storeu_ps(sums_.data(), _mm_loadu_ps(sums_.data() + 4));
        if (exact_) {
            float* last = sums_.data() + 4 * static_cast<std::ptrdiff_t>(width_);
            _mm_storeu_ps(last + 4, _mm_loadu_ps(last));
        }
    }

    // Texel x of the coarse level, 64 times.
    INLINE_VECTORS __m128 texel(int x) const {
        const float* at = sums_.data() + 8 * static_cast<std::ptrdiff_t>(x); // column 2 x - 1
        const __m128 middle = _mm_add_ps(_mm_loadu_ps(at + 4), _mm_loadu_ps(at + 8));
        return _mm_fmadd_ps(_mm_set1_ps(3.0f), middle, _mm_add_ps(_mm_loadu_ps(at), _mm_loadu_ps(at + 12)));
    }

private:
    int width_, end_;
    bool exact_, exact_rows_;
    std::vector<float> sums_; // from column -1 on
};

VECTORS void down_rows(const Plane& fine, const Plane& coarse, float scale, bool of_frame, int from, int to) {
    Columns columns(fine, coarse);
    const __m128 by = _mm_set1_ps(scale / 64.0f), most = _mm_set1_ps(shared::kMostLight);
    for (int y = from; y < to; ++y) {
        columns.sum(fine, y, of_frame);
        std::uint8_t* at = coarse.row(y);
        for (int x = 0; x < coarse.width; ++x, at += kPixelBytes) {
            const __m128 light = _mm_min_ps(_mm_mul_ps(columns.texel(x), by), most);
            const __m128 opaque = _mm_blend_ps(light, _mm_setzero_ps(), 0x8);
            _mm_storel_epi64(reinterpret_cast<__m128i*>(at),
                             _mm_cvtps_ph(opaque, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
        }
    }
}

VECTORS void tail_row(const std::vector<float>& light, const std::vector<float>& shape, const Plane& to,
                      int y) {
    // Of the kernel, 2 width - 1 times 2 height - 1.
    const int across = 2 * to.width - 1;
    for (int x = 0; x < to.width; ++x) {
        __m128 sum = _mm_setzero_ps();
        const float* texel = light.data();
        for (int v = 0; v < to.height; ++v) {
            const float* row = shape.data() + static_cast<std::ptrdiff_t>(y - v + to.height - 1) * across;
            for (int u = 0; u < to.width; ++u, texel += 4)
                sum = _mm_fmadd_ps(_mm_loadu_ps(texel), _mm_set1_ps(row[x - u + to.width - 1]), sum);
        }
        const __m128 most = _mm_min_ps(sum, _mm_set1_ps(shared::kMostLight));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(to.row(y) + kPixelBytes * static_cast<std::size_t>(x)),
                         _mm_cvtps_ph(most, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
    }
}

VECTORS void read_texels(const Plane& from, float by, std::vector<float>& texels) {
    const __m128 weight = _mm_set1_ps(by);
    float* to = texels.data();
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x, to += 4)
            _mm_storeu_ps(to,
                          _mm_mul_ps(weight, _mm256_castps256_ps128(load_four_halves(
                                                 from.row(y) + kPixelBytes * static_cast<std::size_t>(x)))));
}

VECTORS void up_rows(const Plane& coarse, const Plane& fine, float fine_weight, float coarse_weight, int from,
                     int to) {
    BlendedRow above(coarse.width);
    const F8 weight = _mm256_set1_ps(fine_weight), most = _mm256_set1_ps(shared::kMostLight);
    for (int y = from; y < to; ++y) {
        above.blend(coarse, y, coarse_weight);
        std::uint8_t* at = fine.row(y);
        int x = 0;
        for (; x + 2 <= fine.width; x += 2, at += 2 * kPixelBytes)
            store_halves(at, without_alpha(_mm256_min_ps(
                                 _mm256_fmadd_ps(load_halves(at), weight, above.pair(x / 2)), most)));
        if (x < fine.width)
            store_four_halves(at,
                              without_alpha(_mm256_min_ps(
                                  _mm256_fmadd_ps(load_four_halves(at), weight, above.pair(x / 2)), most)));
    }
}

} // namespace

void glare_down(const Plane& fine, const Plane& coarse, float scale, bool of_frame) {
    each_rows(coarse.height, [&](int from, int to) { down_rows(fine, coarse, scale, of_frame, from, to); });
}

void glare_tail(const Plane& from, const Plane& to, float texel_deg, float weight) {
    std::vector<float> texels(4 * static_cast<std::size_t>(from.width) *
                              static_cast<std::size_t>(from.height));
    read_texels(from, weight, texels);
    std::vector<float> shape;
    for (int y = 1 - to.height; y < to.height; ++y)
        for (int x = 1 - to.width; x < to.width; ++x)
            shape.push_back(shared::glare_tail(glm::vec2(x, y), texel_deg));
    each_rows(to.height, [&](int first, int last) {
        for (int y = first; y < last; ++y) tail_row(texels, shape, to, y);
    });
}

void glare_up(const Plane& coarse, const Plane& fine, float fine_weight, float coarse_weight) {
    each_rows(fine.height,
              [&](int from, int to) { up_rows(coarse, fine, fine_weight, coarse_weight, from, to); });
}

} // namespace ghost::render
#endif
