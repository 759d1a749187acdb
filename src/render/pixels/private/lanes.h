#pragma once
// SPDX-License-Identifier: Apache-2.0
// Eight floats at once: what the steps of this room share. Only within functions that are VECTORS, and no
// lambdas in those: a compiler does not hand the target on to them.

#include "shared/push.h"

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>

#define VECTORS __attribute__((target("avx2,fma,f16c")))
#define INLINE_VECTORS inline __attribute__((always_inline, target("avx2,fma,f16c")))

namespace ghost::render {

using F8 = __m256;
using I8 = __m256i;

constexpr std::size_t kPixelBytes = 8;  // four halves
constexpr std::size_t kTexelBytes = 16; // of kept images, points, cells and extras: four words

// Eight half floats.
INLINE_VECTORS F8 load_halves(const void* at) {
    return _mm256_cvtph_ps(_mm_loadu_si128(static_cast<const __m128i*>(at)));
}
// Four; the upper four are zero.
INLINE_VECTORS F8 load_four_halves(const void* at) {
    return _mm256_cvtph_ps(_mm_loadl_epi64(static_cast<const __m128i*>(at)));
}
INLINE_VECTORS __m128i as_halves(F8 value) {
    return _mm256_cvtps_ph(value, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
INLINE_VECTORS void store_halves(void* at, F8 value) {
    _mm_storeu_si128(static_cast<__m128i*>(at), as_halves(value));
}
INLINE_VECTORS void store_four_halves(void* at, F8 value) {
    _mm_storel_epi64(static_cast<__m128i*>(at), as_halves(value));
}
// As light_to_store of the shaders; a store rounds to the nearest half.
INLINE_VECTORS F8 to_store(F8 light) {
    return _mm256_min_ps(light, _mm256_set1_ps(shared::kMostLight));
}
// Two pixels rgb: alpha zero.
INLINE_VECTORS F8 without_alpha(F8 pixels) {
    return _mm256_blend_ps(pixels, _mm256_setzero_ps(), 0x88);
}
// Six halves and room for two, as kept images have them, to two pixels with an alpha of zero, and back.
INLINE_VECTORS F8 spread_six(F8 six) {
    return without_alpha(_mm256_permutevar8x32_ps(six, _mm256_setr_epi32(0, 1, 2, 7, 3, 4, 5, 7)));
}
INLINE_VECTORS F8 to_six(F8 pixels) {
    const F8 six = _mm256_permutevar8x32_ps(pixels, _mm256_setr_epi32(0, 1, 2, 4, 5, 6, 3, 7));
    return _mm256_blend_ps(six, _mm256_setzero_ps(), 0xC0);
}
// RGB9E5: what one of its digits is worth.
INLINE_VECTORS F8 unit_of_shared_exponents(I8 words) {
    constexpr int kBias = 127 - 24; // of a float, less that of the format with its nine bits
    const I8 power = _mm256_add_epi32(_mm256_srli_epi32(words, 27), _mm256_set1_epi32(kBias));
    return _mm256_castsi256_ps(_mm256_slli_epi32(power, 23));
}
// The same of a word in each half of four lanes: rgb, and anything as alpha.
INLINE_VECTORS F8 unpack_shared_exponents(I8 words) {
    const I8 digits = _mm256_and_si256(_mm256_srlv_epi32(words, _mm256_setr_epi32(0, 9, 18, 0, 0, 9, 18, 0)),
                                       _mm256_set1_epi32(511));
    return _mm256_mul_ps(_mm256_cvtepi32_ps(digits), unit_of_shared_exponents(words));
}

// Of positive normal numbers; wrong by .0002 at most.
INLINE_VECTORS F8 log2_of(F8 value) {
    const I8 bits = _mm256_castps_si256(value);
    const I8 root = _mm256_set1_epi32(0x3f3504f3); // of one half
    const I8 power = _mm256_srai_epi32(_mm256_sub_epi32(bits, root), 23);
    const F8 m = _mm256_castsi256_ps(_mm256_sub_epi32(bits, _mm256_slli_epi32(power, 23)));
    const F8 u = _mm256_sub_ps(m, _mm256_set1_ps(1.0f));
    F8 sum = _mm256_set1_ps(-0.32908799f);
    sum = _mm256_fmadd_ps(sum, u, _mm256_set1_ps(0.51152782f));
    sum = _mm256_fmadd_ps(sum, u, _mm256_set1_ps(-0.72419014f));
    sum = _mm256_fmadd_ps(sum, u, _mm256_set1_ps(1.4422624f));
    return _mm256_fmadd_ps(sum, u, _mm256_cvtepi32_ps(power));
}

} // namespace ghost::render
#endif
