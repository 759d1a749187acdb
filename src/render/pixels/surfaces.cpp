// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/surfaces.h"

#include "render/pixels/private/beam_lanes.h"
#include "render/pixels/processor.h"
#include "shared/push.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

using shared::lanes::any;
using shared::lanes::bits_of;
using shared::lanes::real;
using shared::lanes::truth;
using shared::lanes::vec3;
using shared::lanes::vec4;

constexpr int kLanes = 8;
constexpr std::size_t kPlaceBytes = 16;
constexpr int kRunsOfTile = static_cast<int>(shared::kTilePixels) / kLanes;
constexpr int kRunsOfRow = static_cast<int>(shared::kTileWidth) / kLanes;

// Lights that reach a tile or a block, for eight of them.
using Reaching = std::array<std::vector<const shared::Light*>, kLanes>;

// Eight fragments, side by side but at the end of a row.
struct Run {
    int x = 0;
    int y = 0;
    int count = kLanes; // fewer at the right border of the picture
    bool joined = true; // else each is looked for: extra fragments go on in the next row
};

Run run_of(const PassSurfaces& where, int unit, int number) {
    const auto width = static_cast<int>(where.view.width), height = static_cast<int>(where.view.height);
    if (unit < where.tiles) {
        const int x =
            (unit % where.tiles_x) * static_cast<int>(shared::kTileWidth) + number % kRunsOfRow * kLanes;
        const int y = (unit / where.tiles_x) * static_cast<int>(shared::kTileHeight) + number / kRunsOfRow;
        const int count = y < height ? std::clamp(width - x, 0, kLanes) : 0;
        return {x, y, count, count == kLanes};
    }
    const int extra = (unit - where.tiles) * static_cast<int>(shared::kTilePixels) + number * kLanes;
    const int x = extra % width;
    return {x, height + extra / width, kLanes, x + kLanes <= width};
}

// Where the texels of a run lie; those that are not side by side are brought together at `room`.
const std::uint8_t* texels_of(const Plane& plane, const Run& run, std::size_t bytes, std::uint8_t* room) {
    const auto at = [&](int x, int y) { return plane.row(y) + bytes * static_cast<std::size_t>(x); };
    if (run.joined) return at(run.x, run.y);
    for (int k = 0; k < run.count; ++k)
        std::memcpy(room + bytes * static_cast<std::size_t>(k),
                    at((run.x + k) % plane.width, run.y + (run.x + k) / plane.width), bytes);
    return room;
}

// Four numbers of each of eight pixels, the first two pixels in the first vector, to all first numbers, all
// second ones ...
INLINE_VECTORS vec4 by_number(F8 a, F8 b, F8 c, F8 d) {
    const F8 p04 = _mm256_permute2f128_ps(a, c, 0x20), p15 = _mm256_permute2f128_ps(a, c, 0x31);
    const F8 p26 = _mm256_permute2f128_ps(b, d, 0x20), p37 = _mm256_permute2f128_ps(b, d, 0x31);
    const F8 xy0 = _mm256_unpacklo_ps(p04, p15), zw0 = _mm256_unpackhi_ps(p04, p15);
    const F8 xy2 = _mm256_unpacklo_ps(p26, p37), zw2 = _mm256_unpackhi_ps(p26, p37);
    return {_mm256_shuffle_ps(xy0, xy2, 0x44), _mm256_shuffle_ps(xy0, xy2, 0xEE),
            _mm256_shuffle_ps(zw0, zw2, 0x44), _mm256_shuffle_ps(zw0, zw2, 0xEE)};
}

INLINE_VECTORS vec4 load_floats(const std::uint8_t* at) {
    const auto* from = reinterpret_cast<const float*>(at);
    return by_number(_mm256_loadu_ps(from), _mm256_loadu_ps(from + 8), _mm256_loadu_ps(from + 16),
                     _mm256_loadu_ps(from + 24));
}

INLINE_VECTORS vec3 load_light(const std::uint8_t* at) {
    const vec4 rgba =
        by_number(load_halves(at), load_halves(at + 16), load_halves(at + 32), load_halves(at + 48));
    return {rgba.x, rgba.y, rgba.z};
}

INLINE_VECTORS void add_light(std::uint8_t* at, const vec3& light) {
    const F8 rg0 = _mm256_unpacklo_ps(light.x.v, light.y.v), rg2 = _mm256_unpackhi_ps(light.x.v, light.y.v);
    const F8 zero = _mm256_setzero_ps();
    const F8 b0 = _mm256_unpacklo_ps(light.z.v, zero), b2 = _mm256_unpackhi_ps(light.z.v, zero);
    const F8 p04 = _mm256_shuffle_ps(rg0, b0, 0x44), p15 = _mm256_shuffle_ps(rg0, b0, 0xEE);
    const F8 p26 = _mm256_shuffle_ps(rg2, b2, 0x44), p37 = _mm256_shuffle_ps(rg2, b2, 0xEE);
    const F8 pairs[4] = {_mm256_permute2f128_ps(p04, p15, 0x20), _mm256_permute2f128_ps(p26, p37, 0x20),
                         _mm256_permute2f128_ps(p04, p15, 0x31), _mm256_permute2f128_ps(p26, p37, 0x31)};
    for (int k = 0; k < 4; ++k)
        store_halves(at + 16 * k, to_store(_mm256_add_ps(load_halves(at + 16 * k), pairs[k])));
}

// As cull.comp: the sphere round what a unit shows meets the cone.
VECTORS int find_lights(const PassSurfaces& where, const std::vector<shared::Light>& lights, int first,
                        Reaching& reaching) {
    alignas(32) float sphere[4][kLanes];
    const int units = where.tiles + where.blocks;
    for (int k = 0; k < kLanes; ++k) {
        reaching[static_cast<std::size_t>(k)].clear();
        const glm::vec4 of_unit =
            first + k < units ? where.bounds[2 * (first + k)] : glm::vec4(0.0f, 0.0f, 0.0f, -1.0f);
        for (int c = 0; c < 4; ++c) sphere[c][k] = of_unit[c];
    }
    const vec3 middle_m(_mm256_load_ps(sphere[0]), _mm256_load_ps(sphere[1]), _mm256_load_ps(sphere[2]));
    const real radius_m = _mm256_load_ps(sphere[3]);
    int count = 0;
    for (const shared::Light& light : lights) {
        const float k = light.tan_field * light.cut_radius;
        const vec3 q = to_gate(light, middle_m - light.position_m);
        const real z = q.z + radius_m * (std::sqrt(1.0f + k * k) / k);
        const truth meets = radius_m >= 0.0f && z > 0.0f && q.x * q.x + q.y * q.y < k * k * (z * z);
        for (unsigned left = bits_of(meets); left != 0; left &= left - 1, ++count)
            reaching[static_cast<std::size_t>(__builtin_ctz(left))].push_back(&light);
    }
    return count;
}

INLINE_VECTORS vec3 shown(const PassSurfaces& where, const shared::Light& light, const vec3& place_m,
                          const Run& run, const vec3& sum) {
    const vec3 way_m = place_m - light.position_m;
    const vec3 q = to_gate(light, way_m);
    const float k = light.tan_field * light.cut_radius;
    const truth meets = q.z > std::max(light.lens_m, 1e-4f) && q.x * q.x + q.y * q.y < k * k * (q.z * q.z);
    if (!any(meets)) return sum;
    alignas(32) std::uint8_t room[kLanes * kPixelBytes] = {};
    const vec3 radiance = load_light(texels_of(where.passes[light.pass], run, kPixelBytes, room));
    return sum +
           beam_candela(light, q, *where.gobos) * radiance *
               (pass_fraction(light, way_m) * haze_transmittance(where.view.haze, way_from_lens_m(light, q)) *
                attenuation_factor(where.attenuation, length(q)));
}

VECTORS void light_run(const PassSurfaces& where, const std::vector<const shared::Light*>& lights,
                       const Run& run, const Plane& drawn) {
    alignas(32) std::uint8_t room[kLanes * kPlaceBytes] = {};
    const vec4 place = load_floats(texels_of(where.places, run, kPlaceBytes, room));
    const vec3 place_m(place.x, place.y, place.z);
    vec3 sum(0.0f);
    for (const shared::Light* light : lights) sum = shown(where, *light, place_m, run, sum);
    const real seen =
        haze_transmittance(where.view.haze, length(place_m - where.view.eye_m)) * (1.0f / shared::kPassScale);
    sum *= select(place.w >= 0.0f, seen, 0.0f);
    if (run.joined) {
        add_light(drawn.row(run.y) + kPixelBytes * static_cast<std::size_t>(run.x), sum);
        return;
    }
    texels_of(drawn, run, kPixelBytes, room);
    add_light(room, sum);
    for (int k = 0; k < run.count; ++k) {
        const int x = (run.x + k) % drawn.width, y = run.y + (run.x + k) / drawn.width;
        std::memcpy(drawn.row(y) + kPixelBytes * static_cast<std::size_t>(x),
                    room + kPixelBytes * static_cast<std::size_t>(k), kPixelBytes);
    }
}

} // namespace

int light_surfaces(const PassSurfaces& where, const std::vector<shared::Light>& lights, const Plane& drawn) {
    const int units = where.tiles + where.blocks;
    std::atomic<int> count = 0;
    each_rows((units + kLanes - 1) / kLanes, [&](int from, int to) {
        Reaching reaching;
        for (int first = from * kLanes; first < to * kLanes; first += kLanes) {
            count += find_lights(where, lights, first, reaching);
            for (int k = 0; k < kLanes; ++k) {
                const auto& of_unit = reaching[static_cast<std::size_t>(k)];
                for (int number = 0; number < kRunsOfTile && !of_unit.empty(); ++number)
                    if (const Run run = run_of(where, first + k, number); run.count > 0)
                        light_run(where, of_unit, run, drawn);
            }
        }
    });
    return count;
}

} // namespace ghost::render
#endif
