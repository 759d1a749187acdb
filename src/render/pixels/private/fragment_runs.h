#pragma once
// SPDX-License-Identifier: Apache-2.0
// What loops over the fragments of a picture share: a tile, or a block of extra fragments, is lit in runs of
// eight fragments side by side. Units of tiles: first those of the picture, then blocks.

#include "render/pixels/private/beam_lanes.h"
#include "render/pixels/processor.h"
#include "render/pixels/surfaces.h"
#include "shared/push.h"

#include <algorithm>
#include <cstring>
#include <vector>

#if defined(__x86_64__)
namespace ghost::render {

constexpr int kLanes = 8;
constexpr std::size_t kPlaceBytes = 16;
constexpr int kRunsOfUnit = static_cast<int>(shared::kTilePixels) / kLanes;
constexpr int kRunsOfRow = static_cast<int>(shared::kTileWidth) / kLanes;

struct Run {
    int unit = 0;
    int number = 0; // of the unit's
    int x = 0;
    int y = 0;
    int count = kLanes; // fewer at the right border of the picture
    bool joined = true; // else each is looked for: extra fragments go on in the next row
};

inline Run run_of(const SurfacePlanes& where, int unit, int number) {
    const auto width = static_cast<int>(where.view.width), height = static_cast<int>(where.view.height);
    if (unit < where.tiles) {
        const int x =
            (unit % where.tiles_x) * static_cast<int>(shared::kTileWidth) + number % kRunsOfRow * kLanes;
        const int y = (unit / where.tiles_x) * static_cast<int>(shared::kTileHeight) + number / kRunsOfRow;
        const int count = y < height ? std::clamp(width - x, 0, kLanes) : 0;
        return {unit, number, x, y, count, count == kLanes};
    }
    const int extra = (unit - where.tiles) * static_cast<int>(shared::kTilePixels) + number * kLanes;
    const int x = extra % width;
    return {unit, number, x, height + extra / width, kLanes, x + kLanes <= width};
}

// Where the texels of a run lie; those that are not side by side are brought together at `room`.
inline const std::uint8_t* texels_of(const Plane& plane, const Run& run, std::size_t bytes,
                                     std::uint8_t* room) {
    if (run.joined) return plane.row(run.y) + bytes * static_cast<std::size_t>(run.x);
    for (int k = 0; k < run.count; ++k) {
        const int x = (run.x + k) % plane.width, y = run.y + (run.x + k) / plane.width;
        std::memcpy(room + bytes * static_cast<std::size_t>(k),
                    plane.row(y) + bytes * static_cast<std::size_t>(x), bytes);
    }
    return room;
}

// Four numbers of each of eight fragments, two fragments in a vector, to all first numbers, all second ones
// ...
INLINE_VECTORS shared::lanes::vec4 by_number(F8 a, F8 b, F8 c, F8 d) {
    const F8 p04 = _mm256_permute2f128_ps(a, c, 0x20), p15 = _mm256_permute2f128_ps(a, c, 0x31);
    const F8 p26 = _mm256_permute2f128_ps(b, d, 0x20), p37 = _mm256_permute2f128_ps(b, d, 0x31);
    const F8 xy0 = _mm256_unpacklo_ps(p04, p15), zw0 = _mm256_unpackhi_ps(p04, p15);
    const F8 xy2 = _mm256_unpacklo_ps(p26, p37), zw2 = _mm256_unpackhi_ps(p26, p37);
    return {_mm256_shuffle_ps(xy0, xy2, 0x44), _mm256_shuffle_ps(xy0, xy2, 0xEE),
            _mm256_shuffle_ps(zw0, zw2, 0x44), _mm256_shuffle_ps(zw0, zw2, 0xEE)};
}

INLINE_VECTORS shared::lanes::vec4 load_places(const Plane& plane, const Run& run) {
    alignas(32) std::uint8_t room[kLanes * kPlaceBytes] = {};
    const auto* from = reinterpret_cast<const float*>(texels_of(plane, run, kPlaceBytes, room));
    return by_number(_mm256_loadu_ps(from), _mm256_loadu_ps(from + 8), _mm256_loadu_ps(from + 16),
                     _mm256_loadu_ps(from + 24));
}

// rgba16f.
INLINE_VECTORS shared::lanes::vec4 load_run(const Plane& plane, const Run& run) {
    alignas(32) std::uint8_t room[kLanes * kPixelBytes] = {};
    const std::uint8_t* at = texels_of(plane, run, kPixelBytes, room);
    return by_number(load_halves(at), load_halves(at + 16), load_halves(at + 32), load_halves(at + 48));
}

INLINE_VECTORS shared::lanes::vec3 unpack_normal(shared::lanes::real x, shared::lanes::real y) {
    using shared::lanes::vec2;
    return direction_from_octahedral(vec2(x, y) * 0.5f + vec2(0.5f));
}

INLINE_VECTORS void add_light(std::uint8_t* at, const shared::lanes::vec3& light) {
    const F8 zero = _mm256_setzero_ps();
    const F8 rg0 = _mm256_unpacklo_ps(light.x.v, light.y.v), rg2 = _mm256_unpackhi_ps(light.x.v, light.y.v);
    const F8 b0 = _mm256_unpacklo_ps(light.z.v, zero), b2 = _mm256_unpackhi_ps(light.z.v, zero);
    const F8 p04 = _mm256_shuffle_ps(rg0, b0, 0x44), p15 = _mm256_shuffle_ps(rg0, b0, 0xEE);
    const F8 p26 = _mm256_shuffle_ps(rg2, b2, 0x44), p37 = _mm256_shuffle_ps(rg2, b2, 0xEE);
    const F8 pairs[4] = {_mm256_permute2f128_ps(p04, p15, 0x20), _mm256_permute2f128_ps(p26, p37, 0x20),
                         _mm256_permute2f128_ps(p04, p15, 0x31), _mm256_permute2f128_ps(p26, p37, 0x31)};
    for (int k = 0; k < 4; ++k)
        store_halves(at + 16 * k, to_store(_mm256_add_ps(load_halves(at + 16 * k), pairs[k])));
}

// drawn += light.
INLINE_VECTORS void add_run(const Plane& drawn, const Run& run, const shared::lanes::vec3& light) {
    if (run.joined) {
        add_light(drawn.row(run.y) + kPixelBytes * static_cast<std::size_t>(run.x), light);
        return;
    }
    alignas(32) std::uint8_t room[kLanes * kPixelBytes] = {};
    texels_of(drawn, run, kPixelBytes, room);
    add_light(room, light);
    for (int k = 0; k < run.count; ++k) {
        const int x = (run.x + k) % drawn.width, y = run.y + (run.x + k) / drawn.width;
        std::memcpy(drawn.row(y) + kPixelBytes * static_cast<std::size_t>(x),
                    room + kPixelBytes * static_cast<std::size_t>(k), kPixelBytes);
    }
}

using UnitLights = std::vector<const MarkedLight*>;

// On all cores: each run of each unit that a light is marked for.
template <class Surfaces>
void each_run(const Surfaces& where, const std::vector<MarkedLight>& lights, const Plane& drawn,
              void (*light_run)(const Surfaces&, const UnitLights&, const Run&, const Plane& drawn)) {
    each_rows(where.tiles + where.blocks, [&](int from, int to) {
        UnitLights of_unit;
        for (int unit = from; unit < to; ++unit) {
            of_unit.clear();
            for (const MarkedLight& light : lights)
                if ((light.marks[unit / 32] >> (unit % 32) & 1u) != 0) of_unit.push_back(&light);
            for (int number = 0; number < kRunsOfUnit && !of_unit.empty(); ++number)
                if (const Run run = run_of(where, unit, number); run.count > 0)
                    light_run(where, of_unit, run, drawn);
        }
    });
}

} // namespace ghost::render
#endif
