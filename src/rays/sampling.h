#pragma once
// SPDX-License-Identifier: Apache-2.0
// Repeatable sample positions: a hash of what the sample is for seeds an Owen-scrambled Sobol (0,2) sequence
// (Burley 2020), so the same pixel has the same samples whatever thread draws it and however many lights are
// baked. Pure, any thread.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace ghost::bake {

inline std::uint32_t hash_u32(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0xd35a2d97u;
    x ^= x >> 15;
    return x;
}

inline std::uint32_t hash_u32(std::uint32_t a, std::uint32_t b) {
    return hash_u32(a ^ hash_u32(b + 0x9e3779b9u));
}

inline float to_unit(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(x);
}

// Laine-Karras hash on reversed bits: a nested uniform (Owen) scramble.
inline std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

// Point index of the sequence called seed, in [0, 1)^2. Every power of two of first points is a (0,2)-net.
inline glm::vec2 sobol_2d(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t shuffled = owen_scramble(index, seed);
    std::uint32_t y = 0;
    std::uint32_t direction = 1u << 31;
    for (std::uint32_t i = shuffled; i != 0; i >>= 1, direction ^= direction >> 1)
        if (i & 1u) y ^= direction;
    return {to_unit(owen_scramble(reverse_bits(shuffled), hash_u32(seed, 1))),
            to_unit(owen_scramble(y, hash_u32(seed, 2)))};
}

// Cosine-weighted direction about n.
inline glm::vec3 cosine_direction(const glm::vec3& n, const glm::vec2& u) {
    const float sign = n.z >= 0.0f ? 1.0f : -1.0f; // basis of Duff et al. 2017
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    const glm::vec3 s(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
    const glm::vec3 t(b, sign + n.y * n.y * a, -n.y);
    const float radius = std::sqrt(u.x);
    const float angle = 6.28318531f * u.y;
    return glm::normalize(s * (radius * std::cos(angle)) + t * (radius * std::sin(angle)) +
                          n * std::sqrt(std::max(0.0f, 1.0f - u.x)));
}

} // namespace ghost::bake
