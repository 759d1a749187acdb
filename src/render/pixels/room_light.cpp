// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/room_light.h"

#include "render/pixels/private/fragment_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

using shared::lanes::any;
using shared::lanes::real;
using shared::lanes::truth;
using shared::lanes::vec3;
using shared::lanes::vec4;

constexpr float kLeastRoomKnown = 0.05f; // of a place, by weight
constexpr float kLeastSide = 0.02f;      // of a normal
constexpr int kRoomEdgesTogether = 64;
constexpr std::size_t kEdgeBytes = 8;

// Eight places between the texels of one side of a volume: the first of eight texels, from there to the
// others, and weights.
struct Between {
    alignas(32) int first[kLanes], right[kLanes], below[kLanes], behind[kLanes];
    alignas(32) float across[kLanes]; // of the right ones
    alignas(32) float row[4][kLanes]; // of each row of two
};

INLINE_VECTORS void put(int* to, I8 value) {
    _mm256_store_si256(reinterpret_cast<I8*>(to), value);
}

INLINE_VECTORS I8 numbers_of(real a) {
    return _mm256_cvttps_epi32(a.v);
}

// As common/room_volume.glsl has it; voxels: places in the volume.
INLINE_VECTORS void find_between(const glm::ivec3& size, const vec3& voxels, Between& places) {
    const glm::vec3 last(size - 1);
    const real x = clamp(voxels.x - 0.5f, 0.0f, last.x), y = clamp(voxels.y - 0.5f, 0.0f, last.y),
               z = clamp(voxels.z - 0.5f, 0.0f, last.z);
    const real x0 = floor(x), y0 = floor(y), z0 = floor(z);
    const real fx = x - x0, fy = y - y0, fz = z - z0;
    const I8 across = _mm256_set1_epi32(size.x), layer = _mm256_set1_epi32(size.x * size.y);
    const I8 first = _mm256_add_epi32(_mm256_add_epi32(_mm256_mullo_epi32(numbers_of(z0), layer),
                                                       _mm256_mullo_epi32(numbers_of(y0), across)),
                                      numbers_of(x0));
    put(places.first, first);
    // No further than the last texel.
    put(places.right, numbers_of(min(last.x - x0, 1.0f)));
    put(places.below, _mm256_mullo_epi32(numbers_of(min(last.y - y0, 1.0f)), across));
    put(places.behind, _mm256_mullo_epi32(numbers_of(min(last.z - z0, 1.0f)), layer));
    _mm256_store_ps(places.across, fx.v);
    _mm256_store_ps(places.row[0], ((1.0f - fy) * (1.0f - fz)).v);
    _mm256_store_ps(places.row[1], (fy * (1.0f - fz)).v);
    _mm256_store_ps(places.row[2], ((1.0f - fy) * fz).v);
    _mm256_store_ps(places.row[3], (fy * fz).v);
}

INLINE_VECTORS F8 load_two(const std::uint64_t* left, const std::uint64_t* right) {
    const __m128d lower = _mm_load_sd(reinterpret_cast<const double*>(left));
    return _mm256_cvtph_ps(_mm_castpd_si128(_mm_loadh_pd(lower, reinterpret_cast<const double*>(right))));
}

// sum += weight * side, left texels in the lower half.
INLINE_VECTORS F8 add_rows(F8 sum, const std::uint64_t* side, const Between& places, int k, float weight) {
    const std::uint64_t* upper = side + places.first[k];
    const std::uint64_t* lower = upper + places.below[k];
    const std::ptrdiff_t right = places.right[k], behind = places.behind[k];
    const F8 all = _mm256_set1_ps(weight);
    const F8 of_row[4] = {_mm256_mul_ps(all, _mm256_broadcast_ss(&places.row[0][k])),
                          _mm256_mul_ps(all, _mm256_broadcast_ss(&places.row[1][k])),
                          _mm256_mul_ps(all, _mm256_broadcast_ss(&places.row[2][k])),
                          _mm256_mul_ps(all, _mm256_broadcast_ss(&places.row[3][k]))};
    sum = _mm256_fmadd_ps(load_two(upper, upper + right), of_row[0], sum);
    sum = _mm256_fmadd_ps(load_two(lower, lower + right), of_row[1], sum);
    sum = _mm256_fmadd_ps(load_two(upper + behind, upper + behind + right), of_row[2], sum);
    return _mm256_fmadd_ps(load_two(lower + behind, lower + behind + right), of_row[3], sum);
}

INLINE_VECTORS __m128 mix_halves(F8 both, float part) {
    const __m128 lower = _mm256_castps256_ps128(both);
    return _mm_fmadd_ps(_mm_sub_ps(_mm256_extractf128_ps(both, 1), lower), _mm_set1_ps(part), lower);
}

// Eight facets: what of each falls on which of six sides.
struct Facing {
    alignas(32) float weight[3][kLanes];
    unsigned negative[3]; // a bit each
};

INLINE_VECTORS Facing facing_of(const vec3& normal) {
    Facing facing;
    const real axes[3] = {normal.x, normal.y, normal.z};
    for (int axis = 0; axis < 3; ++axis) {
        _mm256_store_ps(facing.weight[axis], (axes[axis] * axes[axis]).v);
        facing.negative[axis] = bits_of(axes[axis] < 0.0f);
    }
    return facing;
}

// Lux and how much of it is known, of fragment k.
INLINE_VECTORS __m128 sides_at(const scene::BounceVolume& volume, const Between& places, const Facing& facing,
                               int k) {
    const std::size_t side_texels = volume.texels.size() / 6;
    F8 sum = _mm256_setzero_ps();
    for (unsigned axis = 0; axis < 3; ++axis) {
        const float weight = facing.weight[axis][k];
        if (weight <= kLeastSide) continue;
        const unsigned side = 2 * axis + (facing.negative[axis] >> k & 1u);
        sum = add_rows(sum, volume.texels.data() + side * side_texels, places, k, weight);
    }
    return mix_halves(sum, places.across[k]);
}

INLINE_VECTORS float known(__m128 found) {
    return _mm_cvtss_f32(_mm_permute_ps(found, 0xFF));
}

INLINE_VECTORS vec4 by_fragment(const float (&found)[kLanes][4]) {
    return by_number(_mm256_load_ps(found[0]), _mm256_load_ps(found[2]), _mm256_load_ps(found[4]),
                     _mm256_load_ps(found[6]));
}

// wanted: a bit for each fragment; others get none.
INLINE_VECTORS vec3 lux_on_run(const RoomPlanes& where, const vec3& place_m, const vec3& normal,
                               unsigned wanted) {
    const scene::BounceVolumes& volumes = *where.volumes;
    const Facing facing = facing_of(normal);
    const vec3 from_m = place_m - vec3(volumes.low_m);
    alignas(32) float found[kLanes][4];
    Between places;
    find_between(volumes.surfaces.size, from_m * (1.0f / volumes.surfel_m), places);
    unsigned unknown = 0;
    for (int k = 0; k < kLanes; ++k) {
        const bool is_wanted = (wanted >> k & 1u) != 0;
        const __m128 lux = is_wanted ? sides_at(volumes.surfaces, places, facing, k) : _mm_setzero_ps();
        _mm_store_ps(found[k], lux);
        if (is_wanted && known(lux) < kLeastRoomKnown) unknown |= 1u << k;
    }
    // What no surfel stands for, thin things and bodies, gets what falls on a surface in the air there.
    if (unknown != 0) {
        const vec3 before_m = from_m + normal * (0.5f * volumes.cell_m);
        find_between(volumes.air.size, before_m * (1.0f / volumes.cell_m), places);
        for (int k = 0; k < kLanes; ++k)
            if ((unknown >> k & 1u) != 0) _mm_store_ps(found[k], sides_at(volumes.air, places, facing, k));
    }
    const vec4 lux = by_fragment(found);
    const real share = select(lux.w < kLeastRoomKnown, 0.0f, 1.0f / max(lux.w, kLeastRoomKnown));
    return vec3(lux.x, lux.y, lux.z) * share;
}

// Of eight fragments.
struct RoomRun {
    vec4 place, normals, diffuse, specular;
};

INLINE_VECTORS vec3 reflected(const RoomPlanes& where, const RoomRun& run) {
    const truth stands = run.place.w > 0.0f;
    if (!any(stands)) return vec3(0.0f);
    const vec3 place_m(run.place.x, run.place.y, run.place.z);
    const vec3 lux = lux_on_run(where, place_m, unpack_normal(run.normals.z, run.normals.w), bits_of(stands));
    const real covers = min(run.place.w, 1.0f);
    if (where.room.as_lux != 0) return select(stands, lux * covers, vec3(0.0f));
    const vec3 way = place_m - vec3(where.view.eye_m);
    const real away_m = length(way);
    shared::lanes::Brdf brdf;
    brdf.diffuse = vec3(run.diffuse.x, run.diffuse.y, run.diffuse.z);
    brdf.alpha = run.diffuse.w;
    brdf.f0 = vec3(run.specular.x, run.specular.y, run.specular.z);
    brdf.f90 = run.specular.w;
    const vec3 albedo =
        brdf_albedo(brdf, abs(dot(unpack_normal(run.normals.x, run.normals.y), way)) / max(away_m, 1e-6f));
    const vec3 shown =
        albedo * lux * (haze_transmittance(where.view.haze, away_m) * covers * (1.0f / shared::kPi));
    return select(stands, shown, vec3(0.0f));
}

constexpr float ray_part(int pixel) {
    constexpr auto kStep = static_cast<int>(shared::kGlowStep);
    return (static_cast<float>(pixel % kStep) + 0.5f) / static_cast<float>(kStep);
}

// Of eight pixels of a row, from x on, each as far as it sees.
INLINE_VECTORS vec3 glow_before(const RoomPlanes& where, const GlowSlices& slices, int x, int y, int count,
                                real distance_m) {
    const shared::RoomLightPush& room = where.room;
    const auto last = static_cast<float>(room.slices - 1);
    const real at = clamp((distance_m - room.near_m) * (1.0f / room.slice_m), 0.0f, last);
    const real below = min(floor(at), last - 1.0f);
    alignas(32) int slice[kLanes];
    alignas(32) float beyond[kLanes], found[kLanes][4];
    put(slice, numbers_of(below));
    _mm256_store_ps(beyond, (at - below).v);
    constexpr int kStep = static_cast<int>(shared::kGlowStep);
    const std::size_t of_row = std::size_t{room.glow_width} * room.slices;
    const std::uint64_t* row = slices.data() + of_row * static_cast<std::size_t>(y / kStep);
    const float down = ray_part(y);
    for (int k = 0; k < kLanes; ++k) {
        if (k >= count) {
            _mm_store_ps(found[k], _mm_setzero_ps());
            continue;
        }
        const float right = ray_part(x + k);
        const std::uint64_t* ray =
            row + std::size_t{room.slices} * static_cast<std::size_t>((x + k) / kStep) + slice[k];
        F8 sum = _mm256_mul_ps(load_halves(ray), _mm256_set1_ps((1 - right) * (1 - down)));
        sum = _mm256_fmadd_ps(load_halves(ray + room.slices), _mm256_set1_ps(right * (1 - down)), sum);
        sum = _mm256_fmadd_ps(load_halves(ray + of_row), _mm256_set1_ps((1 - right) * down), sum);
        sum = _mm256_fmadd_ps(load_halves(ray + of_row + room.slices), _mm256_set1_ps(right * down), sum);
        _mm_store_ps(found[k], mix_halves(sum, beyond[k]));
    }
    const vec4 glow = by_fragment(found);
    return vec3(glow.x, glow.y, glow.z);
}

VECTORS void add_row(const RoomPlanes& where, const GlowSlices& slices, const Plane& frame, int y) {
    for (int x = 0; x < frame.width; x += kLanes) {
        const int count = std::min(kLanes, frame.width - x);
        const Run run{0, 0, x, y, count, count == kLanes};
        const RoomRun fragments{load_places(where.places, run), load_run(where.normals, run),
                                load_run(where.diffuse, run), load_run(where.specular, run)};
        vec3 sum = reflected(where, fragments);
        if (where.room.as_lux == 0) {
            const vec4& place = fragments.place;
            const vec3 way = vec3(place.x, place.y, place.z) - vec3(where.view.eye_m);
            sum += glow_before(where, slices, x, y, count,
                               select(place.w > 0.0f, length(way), where.view.far_m));
        }
        add_run(frame, run, sum);
    }
}

// Up to eight extra fragments, each with the pixel that it is of.
struct Extras {
    int count = 0;
    std::uint32_t fragment[kLanes];
    std::uint32_t pixel[kLanes];
};

inline const std::uint8_t* texels_of_extras(const Plane& plane, const Extras& extras, int height,
                                            std::size_t bytes, std::uint8_t* room) {
    const auto width = static_cast<std::uint32_t>(plane.width);
    for (int k = 0; k < extras.count; ++k) {
        const std::uint32_t fragment = extras.fragment[k];
        std::memcpy(room + bytes * static_cast<std::size_t>(k),
                    plane.row(height + static_cast<int>(fragment / width)) + bytes * (fragment % width),
                    bytes);
    }
    return room;
}

INLINE_VECTORS vec4 load_extras(const Plane& plane, const Extras& extras, int height) {
    alignas(32) std::uint8_t room[kLanes * kPixelBytes] = {};
    texels_of_extras(plane, extras, height, kPixelBytes, room);
    return by_number(load_halves(room), load_halves(room + 16), load_halves(room + 32),
                     load_halves(room + 48));
}

VECTORS void add_extras(const RoomPlanes& where, const Extras& extras, const Plane& frame) {
    const int height = frame.height;
    alignas(32) std::uint8_t room[kLanes * kPlaceBytes] = {};
    texels_of_extras(where.places, extras, height, kPlaceBytes, room);
    const auto* places = reinterpret_cast<const float*>(room);
    const RoomRun fragments{by_number(_mm256_load_ps(places), _mm256_load_ps(places + 8),
                                      _mm256_load_ps(places + 16), _mm256_load_ps(places + 24)),
                            load_extras(where.normals, extras, height),
                            load_extras(where.diffuse, extras, height),
                            load_extras(where.specular, extras, height)};
    const vec3 light = reflected(where, fragments);
    alignas(32) float r[kLanes], g[kLanes], b[kLanes];
    _mm256_store_ps(r, light.x.v);
    _mm256_store_ps(g, light.y.v);
    _mm256_store_ps(b, light.z.v);
    const auto width = static_cast<std::uint32_t>(frame.width);
    for (int k = 0; k < extras.count; ++k) {
        const std::uint32_t pixel = extras.pixel[k];
        std::uint8_t* to = frame.row(static_cast<int>(pixel / width)) + kPixelBytes * (pixel % width);
        const F8 more = _mm256_setr_ps(r[k], g[k], b[k], 0, 0, 0, 0, 0);
        store_four_halves(to, to_store(_mm256_add_ps(load_four_halves(to), more)));
    }
}

void add_edges(const RoomPlanes& where, const Plane& frame, std::uint32_t from, std::uint32_t to) {
    const auto width = static_cast<std::uint32_t>(frame.width);
    Extras extras;
    for (std::uint32_t i = from; i < to; ++i) {
        std::array<std::uint32_t, 2> edge; // pixel, first extra * 4 + number of extras
        std::memcpy(edge.data(), where.edges.row(static_cast<int>(i / width)) + kEdgeBytes * (i % width),
                    kEdgeBytes);
        for (std::uint32_t k = 0; k < (edge[1] & 3u); ++k) {
            extras.fragment[extras.count] = (edge[1] >> 2) + k;
            extras.pixel[extras.count] = edge[0];
            if (++extras.count < kLanes) continue;
            add_extras(where, extras, frame);
            extras.count = 0;
        }
    }
    if (extras.count > 0) add_extras(where, extras, frame);
}

// Of the air before a ray; the first slice is dark.
VECTORS void sum_ray(const RoomPlanes& where, const glm::vec3& way, const float* passes,
                     std::uint64_t* slices) {
    const shared::RoomLightPush& room = where.room;
    const scene::BounceVolume& glow = where.volumes->glow;
    const vec3 from((where.view.eye_m - room.low_m) / room.cell_m);
    const vec3 step(way / room.cell_m);
    const real lanes = _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7);
    const vec3 zero(0.0f), size(room.cells);
    Between places;
    __m128 sum = _mm_setzero_ps();
    slices[0] = 0;
    for (std::uint32_t first = 1; first < room.slices; first += kLanes) {
        const real distance_m =
            real(room.near_m) + (lanes + (static_cast<float>(first) - 0.5f)) * room.slice_m;
        const vec3 voxels = from + step * distance_m;
        const unsigned inside = bits_of(voxels.x > zero.x && voxels.y > zero.y && voxels.z > zero.z &&
                                        voxels.x < size.x && voxels.y < size.y && voxels.z < size.z);
        if (inside != 0) find_between(glow.size, voxels, places);
        const int count = std::min(kLanes, static_cast<int>(room.slices - first));
        for (int k = 0; k < count; ++k) {
            if ((inside >> k & 1u) != 0) {
                const __m128 found = mix_halves(
                    add_rows(_mm256_setzero_ps(), glow.texels.data(), places, k, 1.0f), places.across[k]);
                const float part = known(found);
                const std::uint32_t slice = first + static_cast<std::uint32_t>(k);
                if (part > kLeastRoomKnown) sum = _mm_fmadd_ps(found, _mm_set1_ps(passes[slice] / part), sum);
            }
            _mm_storel_epi64(reinterpret_cast<__m128i*>(slices + first + k),
                             _mm_cvtps_ph(sum, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
        }
    }
}

} // namespace

void sum_glow(const RoomPlanes& where, GlowSlices& slices) {
    const shared::RoomLightPush& room = where.room;
    const shared::View& view = where.view;
    slices.resize(std::size_t{room.glow_width} * room.glow_height * room.slices);
    std::array<float, shared::kMostGlowSlices> passes{}; // of the light of a slice, times its length
    for (std::uint32_t k = 1; k < room.slices; ++k)
        passes[k] = room.slice_m * std::exp(-view.haze.extinction_per_m *
                                            (room.near_m + (static_cast<float>(k) - 0.5f) * room.slice_m));
    each_rows(static_cast<int>(room.glow_height), [&](int from, int to) {
        for (int y = from; y < to; ++y)
            for (std::uint32_t x = 0; x < room.glow_width; ++x) {
                const glm::vec2 at =
                    glm::vec2(x * shared::kGlowStep, static_cast<std::uint32_t>(y) * shared::kGlowStep) /
                        glm::vec2(view.width, view.height) * 2.0f -
                    1.0f;
                const glm::vec3 way = glm::normalize(view.forward + view.right * at.x - view.up * at.y);
                const std::size_t ray = static_cast<std::size_t>(y) * room.glow_width + x;
                sum_ray(where, way, passes.data(), slices.data() + ray * room.slices);
            }
    });
}

void add_room_light(const RoomPlanes& where, const GlowSlices& slices, const Plane& frame) {
    each_rows(frame.height, [&](int from, int to) {
        for (int y = from; y < to; ++y) add_row(where, slices, frame, y);
    });
    const std::uint32_t count = where.room.edges;
    each_rows(static_cast<int>((count + kRoomEdgesTogether - 1) / kRoomEdgesTogether), [&](int from, int to) {
        add_edges(where, frame, static_cast<std::uint32_t>(from * kRoomEdgesTogether),
                  std::min(static_cast<std::uint32_t>(to * kRoomEdgesTogether), count));
    });
}

} // namespace ghost::render
#endif
