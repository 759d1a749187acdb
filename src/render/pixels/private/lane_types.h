#pragma once
// SPDX-License-Identifier: Apache-2.0
// real, truth and vectors of eight pixels, with the names and functions that shaders have, for the headers of
// shaders/shared that are read once more with these (beam_lanes.h). Only within functions that are VECTORS.
// exp2, log2, sin are wrong by a few of the last bits of a float.

#include "render/pixels/private/lanes.h"
#include "shared/types.h"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__)
namespace ghost::shared::lanes {

using F8 = render::F8;
using I8 = render::I8;
using B8 = int __attribute__((vector_size(32)));

struct truth {
    B8 v;
};
INLINE_VECTORS truth operator&&(truth a, truth b) {
    return {a.v & b.v};
}
INLINE_VECTORS truth operator||(truth a, truth b) {
    return {a.v | b.v};
}
INLINE_VECTORS unsigned bits_of(truth a) {
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<F8>(a.v)));
}
INLINE_VECTORS bool any(truth a) {
    return bits_of(a) != 0;
}

struct real {
    F8 v;
    real() = default;
    INLINE_VECTORS real(F8 lanes) : v(lanes) {}
    INLINE_VECTORS real(float all) : v(_mm256_set1_ps(all)) {}
    INLINE_VECTORS friend real operator+(real a, real b) { return a.v + b.v; }
    INLINE_VECTORS friend real operator-(real a, real b) { return a.v - b.v; }
    INLINE_VECTORS friend real operator*(real a, real b) { return a.v * b.v; }
    INLINE_VECTORS friend real operator/(real a, real b) { return a.v / b.v; }
    INLINE_VECTORS friend real operator-(real a) { return -a.v; }
    INLINE_VECTORS real& operator+=(real b) { return *this = *this + b; }
    INLINE_VECTORS real& operator-=(real b) { return *this = *this - b; }
    INLINE_VECTORS real& operator*=(real b) { return *this = *this * b; }
    INLINE_VECTORS friend truth operator<(real a, real b) { return {a.v < b.v}; }
    INLINE_VECTORS friend truth operator>(real a, real b) { return {a.v > b.v}; }
    INLINE_VECTORS friend truth operator>=(real a, real b) { return {a.v >= b.v}; }
};

struct vec2 {
    real x, y;
    INLINE_VECTORS vec2(real a, real b) : x(a), y(b) {}
    INLINE_VECTORS vec2(real all) : x(all), y(all) {}
    INLINE_VECTORS vec2(float all) : x(all), y(all) {}
    INLINE_VECTORS vec2(const glm::vec2& a) : x(a.x), y(a.y) {}
    INLINE_VECTORS friend vec2 operator+(const vec2& a, const vec2& b) { return {a.x + b.x, a.y + b.y}; }
    INLINE_VECTORS friend vec2 operator-(const vec2& a, const vec2& b) { return {a.x - b.x, a.y - b.y}; }
    INLINE_VECTORS friend vec2 operator*(const vec2& a, const vec2& b) { return {a.x * b.x, a.y * b.y}; }
    INLINE_VECTORS friend vec2 operator/(const vec2& a, const vec2& b) { return {a.x / b.x, a.y / b.y}; }
};

struct vec3 {
    real x, y, z;
    vec3() = default;
    INLINE_VECTORS vec3(real a, real b, real c) : x(a), y(b), z(c) {}
    INLINE_VECTORS vec3(const vec2& a, real b) : x(a.x), y(a.y), z(b) {}
    INLINE_VECTORS vec3(real all) : x(all), y(all), z(all) {}
    INLINE_VECTORS vec3(float all) : x(all), y(all), z(all) {}
    INLINE_VECTORS vec3(const glm::vec3& a) : x(a.x), y(a.y), z(a.z) {}
    INLINE_VECTORS friend vec3 operator+(const vec3& a, const vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    INLINE_VECTORS friend vec3 operator-(const vec3& a, const vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    INLINE_VECTORS friend vec3 operator*(const vec3& a, const vec3& b) {
        return {a.x * b.x, a.y * b.y, a.z * b.z};
    }
    INLINE_VECTORS vec3& operator+=(const vec3& b) { return *this = *this + b; }
    INLINE_VECTORS vec3& operator*=(const vec3& b) { return *this = *this * b; }
};

struct vec4 {
    real x, y, z, w;
    INLINE_VECTORS vec4(real a, real b, real c, real d) : x(a), y(b), z(c), w(d) {}
    INLINE_VECTORS vec4(float all) : x(all), y(all), z(all), w(all) {}
    INLINE_VECTORS vec4(const glm::vec4& a) : x(a.x), y(a.y), z(a.z), w(a.w) {}
    INLINE_VECTORS friend vec4 operator+(const vec4& a, const vec4& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
    }
    INLINE_VECTORS friend vec4 operator-(const vec4& a, const vec4& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
    }
    INLINE_VECTORS friend vec4 operator*(const vec4& a, const vec4& b) {
        return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
    }
};

// What is the same for all eight stays a float.
inline float min(float a, float b) {
    return std::min(a, b);
}
inline float max(float a, float b) {
    return std::max(a, b);
}
inline float sqrt(float a) {
    return std::sqrt(a);
}
INLINE_VECTORS real min(real a, real b) {
    return _mm256_min_ps(a.v, b.v);
}
INLINE_VECTORS real max(real a, real b) {
    return _mm256_max_ps(a.v, b.v);
}
INLINE_VECTORS vec4 min(const vec4& a, const vec4& b) {
    return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z), min(a.w, b.w)};
}
INLINE_VECTORS real clamp(real a, real low, real high) {
    return min(max(a, low), high);
}
INLINE_VECTORS vec4 clamp(const vec4& a, const vec4& low, const vec4& high) {
    return {clamp(a.x, low.x, high.x), clamp(a.y, low.y, high.y), clamp(a.z, low.z, high.z),
            clamp(a.w, low.w, high.w)};
}
INLINE_VECTORS vec3 clamp(const vec3& a, const vec3& low, const vec3& high) {
    return {clamp(a.x, low.x, high.x), clamp(a.y, low.y, high.y), clamp(a.z, low.z, high.z)};
}
INLINE_VECTORS real mix(real a, real b, real part) {
    return a + (b - a) * part;
}
INLINE_VECTORS vec3 mix(const vec3& a, const vec3& b, real part) {
    return a + (b - a) * part;
}
INLINE_VECTORS real abs(real a) {
    return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v);
}
INLINE_VECTORS real sqrt(real a) {
    return _mm256_sqrt_ps(a.v);
}
INLINE_VECTORS real floor(real a) {
    return _mm256_floor_ps(a.v);
}
INLINE_VECTORS real select(truth condition, real yes, real no) {
    return condition.v ? yes.v : no.v;
}
INLINE_VECTORS vec2 select(truth condition, const vec2& yes, const vec2& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}
INLINE_VECTORS vec3 select(truth condition, const vec3& yes, const vec3& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}
INLINE_VECTORS real dot(const vec2& a, const vec2& b) {
    return a.x * b.x + a.y * b.y;
}
INLINE_VECTORS real dot(const vec3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
INLINE_VECTORS real length(const vec2& a) {
    return sqrt(dot(a, a));
}
INLINE_VECTORS real length(const vec3& a) {
    return sqrt(dot(a, a));
}

INLINE_VECTORS vec3 normalize(const vec3& a) {
    return a * (1.0f / length(a));
}

INLINE_VECTORS real exp2(real a) {
    const real within = clamp(a, -126.0f, 126.0f);
    const F8 whole = _mm256_round_ps(within.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    const real f = within.v - whole;
    real sum = 1.5353362e-4f;
    for (const float term : {1.3398874e-3f, 9.6184374e-3f, 5.5503325e-2f, 0.24022648f, 0.69314720f, 1.0f})
        sum = sum * f + term;
    const I8 power = _mm256_slli_epi32(_mm256_cvtps_epi32(whole), 23);
    return _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(sum.v), power));
}
INLINE_VECTORS real exp(real a) {
    return exp2(a * 1.44269504f);
}
// Of positive normal numbers: 2 atanh((m - 1) / (m + 1)), m round 1.
INLINE_VECTORS real log2(real a) {
    const I8 bits = _mm256_castps_si256(a.v);
    const I8 power = _mm256_srai_epi32(_mm256_sub_epi32(bits, _mm256_set1_epi32(0x3f3504f3)), 23);
    const real u = _mm256_castsi256_ps(_mm256_sub_epi32(bits, _mm256_slli_epi32(power, 23))) - 1.0f;
    const real s = u / (u + 2.0f);
    const real s2 = s * s;
    real sum = 0.41219859f;
    for (const float term : {0.57707802f, 0.96179669f, 2.88539008f}) sum = sum * s2 + term;
    return sum * s + real(_mm256_cvtepi32_ps(power));
}
INLINE_VECTORS real sin(real a) {
    const F8 turns = _mm256_round_ps((a * (1.0f / kPi)).v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    const real r = a - real(turns) * 3.140625f - real(turns) * 9.67653590e-4f; // pi in two parts
    const real r2 = r * r;
    real sum = 2.7557319e-6f;
    for (const float term : {-1.9841270e-4f, 8.3333333e-3f, -1.6666667e-1f, 1.0f}) sum = sum * r2 + term;
    const I8 odd = _mm256_slli_epi32(_mm256_cvtps_epi32(turns), 31);
    return _mm256_xor_ps((sum * r).v, _mm256_castsi256_ps(odd));
}
INLINE_VECTORS real cos(real a) {
    return sin(a + 0.5f * kPi);
}

} // namespace ghost::shared::lanes
#endif
