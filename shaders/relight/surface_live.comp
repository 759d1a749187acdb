#version 460
// SPDX-License-Identifier: Apache-2.0
// Surfaces of a free camera: every fragment of the G-buffer shows its material under the beam, behind the shadow of the light's
// distance map. Laid out as surface.comp.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#define DISTANCE_MAPS 8
#define SLIDES 13
#include "common/gobo_texture.glsl"
#include "common/octahedral_map.glsl"
#define BLOCKERS 12
#include "common/soft_shadow.glsl"
#include "shared/beam.h"
#include "shared/brdf.h"
#include "shared/g_buffer.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray places;
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, rgba16f) readonly uniform image2DArray diffuse; // Brdf::diffuse, alpha
layout(binding = 9, rgba16f) readonly uniform image2DArray specular; // Brdf::f0, f90
layout(binding = 10, rgba16f) readonly uniform image2DArray normals; // and the facets', packed
layout(binding = 11, scalar) uniform AirBlock { Air air; };
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light
layout(constant_id = 2) const bool kShadows = true;
layout(constant_id = 3) const bool kIlluminance = false; // lux on the surface, instead of what the eye sees of it
layout(constant_id = 4) const bool kThin = false;        // some beam may be narrower than two pixels
layout(constant_id = 5) const bool kKeeps = true;        // shadows are made before and kept; else here, just where light falls

#include "common/thin_dot.glsl"
#include "common/lit_fraction.glsl"
#define KEEPS 14
#include "common/visibility.glsl"

const float kNowhere_m = 1e9; // farther than anything

struct Fragment {
    vec3 position_m;
    vec3 normal;
    vec3 facet;
    vec3 to_eye;
    float area_m2; // that the pixel shows
    float reach_m; // how far from a beam's rim it still gets light
    Brdf brdf;
};

// Made before, or, where many lights share a dispatch and there is no page for it, now.
float kept_fraction(Light light, Keep keep, Fragment f, vec3 from_map, bool wanted, uint unit) {
    if (light.map == 0u) return 1.0;
    if (!kKeeps) return as_kept(lit_fraction(light, f.facet, from_map, wanted));
    Page page = page_of(keep, unit);
    if (kSingle) return as_kept(imageLoad(pages, page.texel).x);
    float fraction = lit_fraction(light, f.facet, from_map, wanted && !page.there);
    return as_kept(page.there ? imageLoad(pages, page.texel).x : fraction);
}

vec3 shown(Light light, Keep keep, Fragment f, Haze haze, uint unit) {
    vec3 from_light = f.position_m - light.position_m;
    float distance2 = max(dot(from_light, from_light), 1e-4);
    float distance_m = sqrt(distance2);
    vec3 q = to_gate(light, from_light);
    float facing = -dot(f.facet, from_light) / distance_m;
    // It comes from the lens, not from the apex behind it; a cell of a bar is a bit beside the place where the map was made.
    vec3 from_map = from_light + light.off_map_m;
    vec3 to_light = -from_map / max(length(from_map), 0.01);
    float k = light.tan_field * light.cut_radius;
    float reached = q.z + f.reach_m * sqrt(1.0 + k * k) / k; // as in cull.comp
    bool meets = reached > 0.0 && dot(q.xy, q.xy) < k * k * reached * reached && dot(f.facet, to_light) > 0.0;
    // Of many lights a tile's are for all its fragments, and most fragments lie beside most beams.
    if (!kSingle && !meets) return vec3(0.0);
    // The beam's mean over the fragment: a blur as wide as that is in the gate. (Shadows as wide as the fragment gain .1 dB, but
    // their relative error grows by up to 9 %.)
    float width_m = sqrt(f.area_m2 * max(facing, 0.0));
    float z = max(q.z, 1e-4);
    float per_m = 1.0 / (z * light.tan_field);
    Focus focus = beam_focus(light, z);
    // The curve of a laser is a normal distribution across: as bright in any row of pixels if it deviates by half a pixel.
    focus.least = (HAS_FIGURE(light) ? 1.0 : 0.5) * width_m * per_m;
    vec3 beam_cd = q.z > max(light.lens_m, 1e-4) ? light.intensity_cd * beam_gate(light, q.xy * per_m, focus) * near_fraction(light, distance2) : vec3(0.0);
    if (kThin) {
        // To what the next pixels show of the plane that the surface lies in.
        vec3 way_m = f.position_m - view.eye_m;
        float depth_m = max(dot(way_m, view.forward), 1e-4);
        vec3 along = way_m / (min(dot(f.facet, way_m), -1e-4) / depth_m);
        vec3 right = view.right * (2.0 / float(view.width)), up = view.up * (2.0 / float(view.height));
        right = depth_m * right - along * dot(f.facet, right);
        up = depth_m * up - along * dot(f.facet, up);
        float fraction = q.z > max(light.lens_m, 1e-4) ? thin_dot_fraction(light, q, right, up) : -1.0;
        beam_cd = fraction >= 0.0 ? lumens_of(light) * (fraction * distance2) : beam_cd;
    }
    vec3 light_cd = beam_cd *
                    (haze_transmittance(haze, way_from_lens_m(light, q)) * attenuation_factor(air.attenuation, distance_m) / distance2);
    vec3 value = light_cd * (kIlluminance ? vec3(max(dot(f.normal, to_light), 0.0)) : brdf_times_cosine(f.brdf, f.normal, f.to_eye, to_light));
    value = meets ? value : vec3(0.0);
    if (kShadows)
        value *= kept_fraction(light, keep, f, from_map, max(max(value.r, value.g), value.b) > 0.0, unit);
    return value;
}

void draw(uint tile) {
    uvec2 size = uvec2(view.width, view.height);
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    uint extra = (tile - p.tiles) * kTilePixels + gl_LocalInvocationIndex;
    bool is_extra = tile >= p.tiles;
    bool inside = is_extra || (pixel.x < size.x && pixel.y < size.y);
    pixel = is_extra ? uvec2(extra % size.x, size.y + extra / size.x) : min(pixel, size - 1u);
    ivec3 at = ivec3(pixel, 0);
    Haze haze = view.haze;
    vec4 place = imageLoad(places, at);
    vec4 normal = imageLoad(normals, at);
    vec4 layer = imageLoad(diffuse, at);
    vec4 mirror = imageLoad(specular, at);
    Fragment f;
    f.position_m = place.xyz;
    f.normal = unpack_normal(normal.xy);
    f.facet = unpack_normal(normal.zw);
    float eye_m = max(length(view.eye_m - place.xyz), 1e-4);
    f.to_eye = (view.eye_m - place.xyz) / eye_m;
    float pixel_m = 2.0 * length(view.right) / float(view.width) * eye_m;
    // Seen at a low angle it is long and narrow: a round blur twice as wide as it is narrow keeps what runs along it.
    f.area_m2 = place.w * pixel_m * pixel_m / max(dot(f.facet, f.to_eye), 0.25);
    f.reach_m = is_extra ? kExtraReach_px * pixel_m : kNowhere_m;
    f.brdf = Brdf(layer.rgb, layer.a, mirror.rgb, mirror.a);

    vec3 sum = vec3(0.0);
    if (kSingle) {
        sum = shown(lights[p.batch], keeps[p.batch], f, haze, tile);
    } else {
        uint words = (p.light_count + 31u) / 32u;
        for (uint word = 0u; word < words; ++word) {
            uint mask = mask_of[tile * kMaskWords + word];
            while (mask != 0u) {
                uint index = word * 32u + uint(findLSB(mask));
                sum += shown(lights[index], keeps[index], f, haze, tile);
                mask &= mask - 1u;
            }
        }
    }
    // What no fragment fills may hold anything.
    sum = place.w > 0.0 ? sum * (place.w * (kIlluminance ? 1.0 : haze_transmittance(haze, eye_m))) : vec3(0.0);
    if (inside)
        imageStore(drawn, at, light_to_store(imageLoad(drawn, at) + vec4(sum, 0.0)));
}

void main() {
    uint first = p.direct != 0u ? direct_list(p.batch, p.tiles, p.blocks) : surface_list(p.batch, p.tiles, p.blocks);
    // Of a single light each has its tile: in a loop lavapipe would load all that is the same for its lanes for each of them.
    if (kSingle) {
        draw(list[first + gl_WorkGroupID.x]);
        return;
    }
    uint count = list[list_count(p.batch, p.direct != 0u ? kDirectList : kSurfaceList)];
    for (uint number = gl_WorkGroupID.x; number < count; number += gl_NumWorkGroups.x) draw(list[first + number]);
}
