// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/develop.h"

#include "render/pixels/private/glare_rows.h"
#include "render/pixels/private/lanes.h"
#include "render/pixels/processor.h"
#include "shared/develop.h"
#include "shared/push.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

constexpr int kMeterEvery = 5; // pixels, meter.comp

struct Rgb {
    F8 r, g, b;
};

INLINE_VECTORS F8 set(float value) {
    return _mm256_set1_ps(value);
}
INLINE_VECTORS F8 clamped(F8 value) {
    return _mm256_min_ps(_mm256_max_ps(value, _mm256_setzero_ps()), set(1.0f));
}
INLINE_VECTORS F8 dot(F8 r, F8 g, F8 b, float of_r, float of_g, float of_b) {
    return _mm256_fmadd_ps(r, set(of_r), _mm256_fmadd_ps(g, set(of_g), _mm256_mul_ps(b, set(of_b))));
}
INLINE_VECTORS Rgb times(const glm::mat3& m, const Rgb& c) {
    return {dot(c.r, c.g, c.b, m[0][0], m[1][0], m[2][0]), dot(c.r, c.g, c.b, m[0][1], m[1][1], m[2][1]),
            dot(c.r, c.g, c.b, m[0][2], m[1][2], m[2][2])};
}
// A polynomial, the highest power first.
template <std::size_t Count>
INLINE_VECTORS F8 polynomial(const std::array<float, Count>& factors, F8 x) {
    F8 sum = set(factors[0]);
    for (std::size_t k = 1; k < Count; ++k) sum = _mm256_fmadd_ps(sum, x, set(factors[k]));
    return sum;
}

// x to the power of 1.2 from 0 to kMostGamma, and the upper part of sRGB's curve of the root of x: as seen on
// a display wrong by .06 and by .03 of its 255 steps at most.
constexpr float kMostGamma = 1.6f;
constexpr std::array<float, 8> kPower{-0.10364912f, 0.65801132f, -1.7173522f, 2.4016346f,
                                      -2.0096488f,  1.2129139f,  0.56151482f, -0.0032974064f};
constexpr std::array<float, 8> kSrgbOfRoot{1.4099222f, -5.9517277f, 10.466527f, -10.016602f,
                                           5.7964963f, -2.2697766f, 1.6084547f, -0.043257497f};
static_assert(shared::kAgxGamma == 2.2f && shared::kSrgbPower == 1.0f / 2.4f && shared::kSrgbScale == 1.055f);

INLINE_VECTORS F8 gamma_of(F8 value) {
    const F8 x = _mm256_min_ps(_mm256_max_ps(value, _mm256_setzero_ps()), set(kMostGamma));
    return _mm256_mul_ps(x, polynomial(kPower, x));
}

INLINE_VECTORS F8 agx_curve(F8 inset) {
    using namespace shared;
    const F8 ev = log2_of(_mm256_max_ps(inset, set(1e-10f)));
    const F8 c =
        clamped(_mm256_mul_ps(_mm256_sub_ps(ev, set(kAgxMinEv)), set(1.0f / (kAgxMaxEv - kAgxMinEv))));
    constexpr std::array<float, 7> kCurve{kAgxCurve6, kAgxCurve5, kAgxCurve4, kAgxCurve3,
                                          kAgxCurve2, kAgxCurve1, kAgxCurve0};
    return polynomial(kCurve, c);
}

INLINE_VECTORS Rgb tone_agx(const Rgb& exposed) {
    using namespace shared;
    const Rgb inset = times(agx_inset(), exposed);
    const Rgb c{agx_curve(inset.r), agx_curve(inset.g), agx_curve(inset.b)};
    const glm::vec3 of_grey = agx_grey();
    const F8 grey =
        _mm256_mul_ps(dot(c.r, c.g, c.b, of_grey.x, of_grey.y, of_grey.z), set(1.0f - kAgxSaturation));
    const F8 more = set(kAgxSaturation);
    const Rgb out = times(agx_outset(), {_mm256_fmadd_ps(c.r, more, grey), _mm256_fmadd_ps(c.g, more, grey),
                                         _mm256_fmadd_ps(c.b, more, grey)});
    return {gamma_of(out.r), gamma_of(out.g), gamma_of(out.b)};
}

INLINE_VECTORS F8 aces_curve(F8 exposed) {
    using namespace shared;
    const F8 c = _mm256_min_ps(_mm256_mul_ps(exposed, set(kAcesScale)), set(kAcesMost));
    const F8 above = _mm256_mul_ps(c, _mm256_fmadd_ps(c, set(kAcesA), set(kAcesB)));
    const F8 below = _mm256_fmadd_ps(c, _mm256_fmadd_ps(c, set(kAcesC), set(kAcesD)), set(kAcesE));
    return clamped(_mm256_div_ps(above, below));
}

INLINE_VECTORS I8 srgb_byte(F8 linear) {
    using namespace shared;
    const F8 c = clamped(linear);
    const F8 high = polynomial(kSrgbOfRoot, _mm256_sqrt_ps(c));
    const F8 low = _mm256_mul_ps(c, set(kSrgbSlope));
    const F8 shown = _mm256_blendv_ps(high, low, _mm256_cmp_ps(c, set(kSrgbLinearBelow), _CMP_LT_OQ));
    return _mm256_cvtps_epi32(_mm256_mul_ps(clamped(shown), set(255.0f)));
}

// Four pairs of pixels side by side to lanes of a colour, the left pixels of the pairs first.
INLINE_VECTORS Rgb lanes_of(F8 a, F8 b, F8 c, F8 d) {
    const F8 rg_ab = _mm256_unpacklo_ps(a, b), rg_cd = _mm256_unpacklo_ps(c, d);
    const F8 b_ab = _mm256_unpackhi_ps(a, b), b_cd = _mm256_unpackhi_ps(c, d);
    return {_mm256_shuffle_ps(rg_ab, rg_cd, 0x44), _mm256_shuffle_ps(rg_ab, rg_cd, 0xEE),
            _mm256_shuffle_ps(b_ab, b_cd, 0x44)};
}

// Eight pixels of four bytes, side by side.
INLINE_VECTORS I8 display_of(Rgb light, float exposure, std::uint32_t tone) {
    const F8 brightest = _mm256_max_ps(light.r, _mm256_max_ps(light.g, light.b));
    const F8 over = _mm256_max_ps(_mm256_mul_ps(brightest, set(1.0f / shared::kMostLight)), set(1.0f));
    const F8 scale = _mm256_div_ps(set(exposure), over), none = _mm256_setzero_ps();
    light = {_mm256_max_ps(_mm256_mul_ps(light.r, scale), none),
             _mm256_max_ps(_mm256_mul_ps(light.g, scale), none),
             _mm256_max_ps(_mm256_mul_ps(light.b, scale), none)};
    if (tone == shared::kToneAgx) light = tone_agx(light);
    if (tone == shared::kToneAces) light = {aces_curve(light.r), aces_curve(light.g), aces_curve(light.b)};
    light = times(shared::rec709_of_rec2020(), light);
    const I8 red_green = _mm256_or_si256(srgb_byte(light.r), _mm256_slli_epi32(srgb_byte(light.g), 8));
    const I8 blue = _mm256_or_si256(_mm256_slli_epi32(srgb_byte(light.b), 16), _mm256_set1_epi32(255 << 24));
    return _mm256_permutevar8x32_epi32(_mm256_or_si256(red_green, blue),
                                       _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
}

struct SeenRow {
    const std::uint8_t* frame;
    const BlendedRow* glare; // null: none
    int width;
    float weight;
};

// The two pixels from x on; beyond the border anything.
INLINE_VECTORS F8 seen_pair(const SeenRow& row, int x) {
    if (x >= row.width) return _mm256_setzero_ps();
    const std::uint8_t* at = row.frame + kPixelBytes * static_cast<std::size_t>(x);
    const F8 light = light_of_frame(x + 1 < row.width ? load_halves(at) : load_four_halves(at));
    return row.glare ? _mm256_fmadd_ps(light, set(row.weight), row.glare->pair(x / 2)) : light;
}

INLINE_VECTORS Rgb seen_eight(const SeenRow& row, int x) {
    return lanes_of(seen_pair(row, x), seen_pair(row, x + 2), seen_pair(row, x + 4), seen_pair(row, x + 6));
}

VECTORS void develop_rows(const SeenFrame& seen, float exposure, std::uint32_t tone, const Plane& picture,
                          int from, int to) {
    BlendedRow glare(seen.finest.width);
    for (int y = from; y < to; ++y) {
        if (seen.finest) glare.blend(seen.finest, y, seen.glare_weight);
        const SeenRow row{seen.frame.row(y), seen.finest ? &glare : nullptr, picture.width,
                          seen.frame_weight};
        std::uint8_t* out = picture.row(y);
        int x = 0;
        for (; x + 8 <= picture.width; x += 8, out += 32)
            _mm256_storeu_si256(reinterpret_cast<I8*>(out), display_of(seen_eight(row, x), exposure, tone));
        if (x < picture.width) {
            std::array<std::uint8_t, 32> last{};
            _mm256_storeu_si256(reinterpret_cast<I8*>(last.data()),
                                display_of(seen_eight(row, x), exposure, tone));
            std::copy_n(last.begin(), 4 * static_cast<std::size_t>(picture.width - x), out);
        }
    }
}

struct Metered {
    double sum = 0; // of log2 of luminance
    double count = 0;
};

// The pixels of a row that the meter asks.
VECTORS void meter_row(const SeenFrame& seen, BlendedRow& glare, int y, Metered& metered) {
    const int width = seen.frame.width;
    if (seen.finest) glare.blend(seen.finest, y, seen.glare_weight);
    const SeenRow row{seen.frame.row(y), seen.finest ? &glare : nullptr, width, seen.frame_weight};
    const auto before = static_cast<std::int64_t>(y) * width;
    for (int x = static_cast<int>((kMeterEvery - before % kMeterEvery) % kMeterEvery); x < width;
         x += kMeterEvery) {
        std::array<float, 8> pair{};
        _mm256_storeu_ps(pair.data(), seen_pair(row, x & ~1));
        const std::size_t at = (x & 1) != 0 ? 4 : 0;
        const glm::vec3 light(pair[at], pair[at + 1], pair[at + 2]);
        const float over = std::max(
            {light.r / shared::kMostLight, light.g / shared::kMostLight, light.b / shared::kMostLight, 1.0f});
        const float luminance = shared::luminance_of(light / over);
        if (!(luminance > shared::kMeterFloor)) continue;
        metered.sum += std::log2(static_cast<double>(luminance));
        metered.count += 1;
    }
}

} // namespace

void develop(const SeenFrame& seen, float exposure, std::uint32_t tone, const Plane& picture) {
    each_rows(picture.height,
              [&](int from, int to) { develop_rows(seen, exposure, tone, picture, from, to); });
}

float metered_ev100(const SeenFrame& seen) {
    // Each row its own, and summed in order: equal pictures, equal exposure.
    std::vector<Metered> rows(static_cast<std::size_t>(seen.frame.height));
    each_rows(seen.frame.height, [&](int from, int to) {
        BlendedRow glare(seen.finest.width);
        for (int y = from; y < to; ++y) meter_row(seen, glare, y, rows[static_cast<std::size_t>(y)]);
    });
    Metered all;
    for (const Metered& row : rows) {
        all.sum += row.sum;
        all.count += row.count;
    }
    const double average = all.count > 0 ? std::exp2(all.sum / all.count) : 1.0;
    return static_cast<float>(std::log2(average * 100.0 / 12.5)) + shared::kAutoBias;
}

} // namespace ghost::render
#endif
