// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/surfaces.h"

#include "render/pixels/private/fragment_runs.h"
#include "shared/visibility.h"

#include <algorithm>

#if defined(__x86_64__)
namespace ghost::render {
namespace {

using shared::lanes::any;
using shared::lanes::real;
using shared::lanes::truth;
using shared::lanes::vec2;
using shared::lanes::vec3;
using shared::lanes::vec4;

// Where a light may send anything.
INLINE_VECTORS truth in_beam(const shared::Light& light, const vec3& q) {
    const float k = light.tan_field * light.cut_radius;
    return q.z > std::max(light.lens_m, 1e-4f) && q.x * q.x + q.y * q.y < k * k * (q.z * q.z);
}

VECTORS void light_pass_run(const PassSurfaces& where, const UnitLights& lights, const Run& run,
                            const Plane& drawn) {
    const vec4 place = load_places(where.places, run);
    const vec3 place_m(place.x, place.y, place.z);
    const shared::Haze& haze = where.view.haze;
    vec3 sum(0.0f);
    bool is_lit = false;
    for (const MarkedLight* marked : lights) {
        const shared::Light& light = marked->light;
        const vec3 way_m = place_m - light.position_m;
        const vec3 q = to_gate(light, way_m);
        if (!any(in_beam(light, q))) continue;
        is_lit = true;
        const vec4 radiance = load_run(where.passes[light.pass], run);
        sum += beam_candela(light, q, *where.gobos) * vec3(radiance.x, radiance.y, radiance.z) *
               (pass_fraction(light, way_m) * haze_transmittance(haze, way_from_lens_m(light, q)) *
                attenuation_factor(where.attenuation, length(q)));
    }
    if (!is_lit) return;
    const real seen =
        haze_transmittance(haze, length(place_m - where.view.eye_m)) * (1.0f / shared::kPassScale);
    add_run(drawn, run, sum * select(place.w >= 0.0f, seen, 0.0f));
}

struct LitFragment {
    vec3 normal, facet, to_eye;
    real eye_m, area_m2; // that the pixel shows
    shared::lanes::Brdf brdf;
};

INLINE_VECTORS LitFragment fragment_of(const LiveSurfaces& where, const vec4& place, const Run& run) {
    LitFragment f;
    const vec4 normals = load_run(where.normals, run), diffuse = load_run(where.diffuse, run),
               specular = load_run(where.specular, run);
    f.normal = unpack_normal(normals.x, normals.y);
    f.facet = unpack_normal(normals.z, normals.w);
    const vec3 way_m = vec3(where.view.eye_m) - vec3(place.x, place.y, place.z);
    f.eye_m = max(length(way_m), 1e-4f);
    f.to_eye = way_m * (1.0f / f.eye_m);
    const real pixel_m =
        f.eye_m * (2.0f * glm::length(where.view.right) / static_cast<float>(where.view.width));
    f.area_m2 = place.w * pixel_m * pixel_m / max(dot(f.facet, f.to_eye), 0.25f);
    f.brdf.diffuse = vec3(diffuse.x, diffuse.y, diffuse.z);
    f.brdf.alpha = diffuse.w;
    f.brdf.f0 = vec3(specular.x, specular.y, specular.z);
    f.brdf.f90 = specular.w;
    return f;
}

// What fragments see of the lamp, from the page of their unit.
INLINE_VECTORS real kept_fraction(const LiveSurfaces& where, const MarkedLight& marked, const Run& run) {
    if (marked.light.map == 0 || !marked.entries) return 1.0f;
    const std::uint32_t page = std::max(marked.entries[2 * run.unit], 1u) - 1;
    const std::uint32_t in_layer = page % shared::kPagesOfLayer;
    const std::uint32_t x = in_layer % shared::kPagesAcross * shared::kTileWidth;
    const std::uint32_t y = in_layer / shared::kPagesAcross * shared::kTileHeight;
    const std::uint8_t* row =
        where.pages[page / shared::kPagesOfLayer].row(static_cast<int>(y) + run.number / kRunsOfRow);
    const I8 texels =
        _mm256_loadu_si256(reinterpret_cast<const I8*>(row + std::size_t{4} * x) + run.number % kRunsOfRow);
    return real(_mm256_cvtepi32_ps(_mm256_and_si256(texels, _mm256_set1_epi32(0xffff)))) * (1.0f / 65535.0f);
}

// As surface_live.comp has it.
INLINE_VECTORS vec3 shown(const LiveSurfaces& where, const MarkedLight& marked, const LitFragment& f,
                          const vec3& from_light, const vec3& q, const Run& run) {
    const shared::Light& light = marked.light;
    const real distance2 = max(dot(from_light, from_light), 1e-4f);
    const real distance_m = sqrt(distance2);
    const vec3 from_map = from_light + light.off_map_m;
    const vec3 to_light = from_map * (-1.0f / max(length(from_map), 0.01f));
    const truth meets = in_beam(light, q) && dot(f.facet, to_light) > 0.0f;
    if (!any(meets)) return vec3(0.0f);
    const real kept = kept_fraction(where, marked, run);
    if (!any(meets && kept > 0.0f)) return vec3(0.0f);
    const real width_m = sqrt(f.area_m2 * max(-dot(f.facet, from_light) / distance_m, 0.0f));
    const real z = max(q.z, 1e-4f);
    const real per_m = 1.0f / (z * light.tan_field);
    shared::lanes::Focus focus = beam_focus(light, z);
    focus.least = (light.figure.kind != shared::kNoFigure ? 1.0f : 0.5f) * width_m * per_m;
    const vec3 light_cd =
        vec3(light.intensity_cd) * beam_gate(light, vec2(q.x, q.y) * per_m, focus, *where.gobos) *
        (near_fraction(light, distance2) * haze_transmittance(where.view.haze, way_from_lens_m(light, q)) *
         attenuation_factor(where.attenuation, distance_m) / distance2);
    const vec3 value = light_cd * brdf_times_cosine(f.brdf, f.normal, f.to_eye, to_light);
    return select(meets, value * kept, vec3(0.0f));
}

VECTORS void light_stage_run(const LiveSurfaces& where, const UnitLights& lights, const Run& run,
                             const Plane& drawn) {
    const vec4 place = load_places(where.places, run);
    const vec3 place_m(place.x, place.y, place.z);
    if (!any(place.w > 0.0f)) return;
    LitFragment f;
    vec3 sum(0.0f);
    bool is_lit = false;
    for (const MarkedLight* marked : lights) {
        const vec3 from_light = place_m - marked->light.position_m;
        const vec3 q = to_gate(marked->light, from_light);
        if (!any(in_beam(marked->light, q))) continue;
        if (!is_lit) f = fragment_of(where, place, run);
        is_lit = true;
        sum += shown(where, *marked, f, from_light, q, run);
    }
    if (!is_lit) return;
    // What no fragment fills may hold anything.
    add_run(
        drawn, run,
        select(place.w > 0.0f, sum * (place.w * haze_transmittance(where.view.haze, f.eye_m)), vec3(0.0f)));
}

} // namespace

void light_passes(const PassSurfaces& where, const std::vector<MarkedLight>& lights, const Plane& drawn) {
    each_run(where, lights, drawn, light_pass_run);
}

void light_stage(const LiveSurfaces& where, const std::vector<MarkedLight>& lights, const Plane& drawn) {
    each_run(where, lights, drawn, light_stage_run);
}

} // namespace ghost::render
#endif
