#version 460
// SPDX-License-Identifier: Apache-2.0
// Surfaces (Screen Space Re-Rendering, section 2.1): every fragment shows its pass times the beam. A
// workgroup is a tile of the picture or a block of extra fragments, which lie in the rows below it; fold.comp adds those to
// their pixels.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#define SLIDES 9
#include "common/gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray fragments; // position, coverage; extra fragments in the rows below the picture
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, rgba16f) readonly uniform image2DArray passes;  // radiance of every fragment, one layer a pass
layout(binding = 8, scalar) uniform AirBlock { Air air; };
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light
layout(constant_id = 2) const bool kThin = false;   // some beam may be narrower than two pixels

#include "common/thin_dot.glsl"

// From a pixel to the next along a row or column, on the side where the surface goes on.
vec3 to_next(ivec2 at, ivec2 step, vec3 here_m) {
    vec3 ways_m[2];
    float lengths[2];
    for (int side = 0; side < 2; ++side) {
        ivec2 next = at + (side == 0 ? step : -step);
        bool inside = all(greaterThanEqual(next, ivec2(0))) && all(lessThan(next, ivec2(view.width, view.height)));
        vec4 place = imageLoad(fragments, ivec3(inside ? next : at, 0));
        ways_m[side] = (place.xyz - here_m) * (side == 0 ? 1.0 : -1.0);
        lengths[side] = inside && place.w >= 0.0 ? dot(ways_m[side], ways_m[side]) : 1e30;
    }
    return lengths[0] <= lengths[1] ? ways_m[0] : ways_m[1];
}

vec3 shown(Light light, vec3 position_m, ivec2 row, Haze haze) {
    vec3 way_m = position_m - light.position_m;
    vec3 q = to_gate(light, way_m);
    vec3 radiance = imageLoad(passes, ivec3(row, light.pass)).rgb;
    float distance_m = length(q);
    vec3 beam_cd = beam_candela(light, q);
    if (kThin) {
        bool of_picture = row.y < int(view.height) && q.z > max(light.lens_m, 1e-4);
        vec3 across = to_next(row, ivec2(1, 0), position_m), down = to_next(row, ivec2(0, 1), position_m);
        float fraction = of_picture ? thin_dot_fraction(light, q, across, down) : -1.0;
        beam_cd = fraction >= 0.0 ? lumens_of(light) * (fraction * dot(way_m, way_m)) : beam_cd;
    }
    return beam_cd * radiance *
           (pass_fraction(light, way_m) * haze_transmittance(haze, way_from_lens_m(light, q)) *
            attenuation_factor(air.attenuation, distance_m));
}

void draw(uint tile) {
    uvec2 size = uvec2(view.width, view.height);
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    uint extra = (tile - p.tiles) * kTilePixels + gl_LocalInvocationIndex;
    bool is_extra = tile >= p.tiles;
    bool inside = is_extra || (pixel.x < size.x && pixel.y < size.y);
    pixel = is_extra ? uvec2(extra % size.x, size.y + extra / size.x) : min(pixel, size - 1u);
    ivec2 at = ivec2(pixel);
    Haze haze = view.haze;
    vec4 fragment = imageLoad(fragments, ivec3(at, 0));

    vec3 sum = vec3(0.0);
    if (kSingle) {
        sum = shown(lights[p.batch], fragment.xyz, at, haze);
    } else {
        uint words = (p.light_count + 31u) / 32u;
        for (uint word = 0u; word < words; ++word) {
            uint mask = mask_of[tile * kMaskWords + word];
            while (mask != 0u) {
                sum += shown(lights[word * 32u + uint(findLSB(mask))], fragment.xyz, at, haze);
                mask &= mask - 1u;
            }
        }
    }
    float seen = haze_transmittance(haze, length(fragment.xyz - view.eye_m)) / kPassScale;
    sum *= fragment.w >= 0.0 ? seen : 0.0;
    if (inside)
        imageStore(drawn, ivec3(at, 0), light_to_store(imageLoad(drawn, ivec3(at, 0)) + vec4(sum, 0.0)));
}

void main() {
    // Of a single light each has its tile: in a loop lavapipe would load all that is the same for its lanes for each of them.
    if (kSingle) {
        draw(list[surface_list(p.batch, p.tiles, p.blocks) + gl_WorkGroupID.x]);
        return;
    }
    uint count = list[list_count(p.batch, kSurfaceList)];
    for (uint number = gl_WorkGroupID.x; number < count; number += gl_NumWorkGroups.x) draw(list[surface_list(p.batch, p.tiles, p.blocks) + number]);
}
