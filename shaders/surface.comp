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
#include "gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray fragments; // position, coverage; extra fragments in the rows below the picture
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, rgba16f) readonly uniform image2DArray passes;  // radiance of every fragment, one layer a pass
layout(binding = 8, scalar) uniform AirBlock { Air air; };
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

vec3 shown(Light light, vec3 position_m, ivec2 row, Haze haze) {
    vec3 way_m = position_m - light.position_m;
    vec3 q = to_gate(light, way_m);
    vec3 radiance = imageLoad(passes, ivec3(row, light.pass)).rgb;
    float distance_m = length(q);
    return beam_candela(light, q) * radiance *
           (pass_share(light, way_m) * haze_transmittance(haze, way_from_lens_m(light, q)) *
            attenuation_factor(air.attenuation, distance_m));
}

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tile = list[p.batch * (2u * p.tiles + p.blocks) + p.tiles + gl_WorkGroupID.x];
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
