#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rows of a coarser level of the glare, blended 3 : 1 with the row beside it, for the pixels of a finer one.

#include "render/pixels/plane.h"
#include "render/pixels/private/lanes.h"
#include "shared/push.h"

#include <algorithm>
#include <vector>

#if defined(__x86_64__)
namespace ghost::render {

// Four floats a texel, one more texel at both ends.
class BlendedRow {
public:
    explicit BlendedRow(int width) : texels_(4 * (static_cast<std::size_t>(width) + 2)) {}

    // For row y of the finer level. weight: of what is blended, once.
    VECTORS void blend(const Plane& coarse, int y, float weight) {
        const int near = y / 2;
        const int beside = std::clamp(near + ((y & 1) != 0 ? 1 : -1), 0, coarse.height - 1);
        const std::uint8_t* of_near = coarse.row(near);
        const std::uint8_t* of_beside = coarse.row(beside);
        const F8 most = _mm256_set1_ps(3.0f * weight / 16.0f), least = _mm256_set1_ps(weight / 16.0f);
        float* to = texels_.data() + 4;
        int x = 0;
        for (; x + 2 <= coarse.width; x += 2, of_near += 16, of_beside += 16, to += 8)
            _mm256_storeu_ps(to, _mm256_fmadd_ps(most, load_halves(of_near),
                                                 _mm256_mul_ps(least, load_halves(of_beside))));
        if (x < coarse.width)
            _mm_storeu_ps(
                to, _mm256_castps256_ps128(_mm256_fmadd_ps(
                        most, load_four_halves(of_near), _mm256_mul_ps(least, load_four_halves(of_beside)))));
        const std::size_t end = texels_.size();
        std::copy_n(texels_.begin() + 4, 4, texels_.begin());
        std::copy_n(texels_.begin() + static_cast<std::ptrdiff_t>(end) - 8, 4,
                    texels_.begin() + static_cast<std::ptrdiff_t>(end) - 4);
    }

    // For the two pixels 2 x and 2 x + 1 of the finer level.
    INLINE_VECTORS F8 pair(int x) const {
        const float* at = texels_.data() + 4 * static_cast<std::ptrdiff_t>(x);
        const F8 beside = _mm256_set_m128(_mm_loadu_ps(at + 8), _mm_loadu_ps(at));
        const F8 here = _mm256_broadcast_ps(reinterpret_cast<const __m128*>(at + 4));
        return _mm256_fmadd_ps(_mm256_set1_ps(3.0f), here, beside);
    }

private:
    std::vector<float> texels_;
};

// The frame's alpha says how many times brighter a pixel is than a half float holds (shared/glare.h).
INLINE_VECTORS F8 light_of_frame(F8 stored) {
    return _mm256_fmadd_ps(stored, _mm256_permute_ps(stored, 0xFF), stored);
}

} // namespace ghost::render
#endif
