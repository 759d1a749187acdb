#version 460
// SPDX-License-Identifier: Apache-2.0
// Surfaces (Screen Space Re-Rendering, section 2.1): every fragment of the pixel shows its pass times the beam.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5) uniform sampler2DArray fragments; // position, coverage; extra fragments in the rows below the picture
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7) uniform sampler2DArray passes;  // radiance of every fragment, one layer a pass
layout(binding = 8) uniform usampler2DArray extras; // of a pixel: index of its first extra fragment * 4 + their number
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

vec3 shown(Light light, vec3 position_m, ivec2 row, Haze haze) {
    vec3 q = to_gate(light, position_m - light.position_m);
    vec3 radiance = texelFetch(passes, ivec3(row, light.pass), 0).rgb;
    return beam_candela(light, q) * radiance * haze_transmittance(haze, length(q));
}

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tiles = p.tiles_x * p.tiles_y;
    uint tile = list[2u * p.batch * tiles + gl_WorkGroupID.x];
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    bool inside = pixel.x < size.x && pixel.y < size.y;
    pixel = min(pixel, size - 1u);
    ivec2 at = ivec2(pixel);
    uint extra = texelFetch(extras, ivec3(at, 0), 0).x;
    uint extra_first = extra >> 2;
    uint count = 1u + (extra & 3u);
    uint words = (p.light_count + 31u) / 32u;
    Haze haze = view.haze;

    vec3 sum = vec3(0.0);
    for (uint f = 0u; f < count; ++f) {
        uint index = extra_first + f - 1u;
        ivec2 row = f == 0u ? at : ivec2(index % size.x, size.y + index / size.x);
        vec4 fragment = texelFetch(fragments, ivec3(row, 0), 0);
        vec3 light_sum = vec3(0.0);
        if (kSingle) {
            light_sum = shown(lights[p.batch], fragment.xyz, row, haze);
        } else {
            for (uint word = 0u; word < words; ++word) {
                uint mask = mask_of[tile * kMaskWords + word];
                while (mask != 0u) {
                    light_sum += shown(lights[word * 32u + uint(findLSB(mask))], fragment.xyz, row, haze);
                    mask &= mask - 1u;
                }
            }
        }
        float seen = haze_transmittance(haze, length(fragment.xyz - view.eye_m)) / kPassScale;
        sum += light_sum * (fragment.w >= 0.0 ? seen : 0.0);
    }
    if (inside) imageStore(drawn, ivec3(at, 0), min(imageLoad(drawn, ivec3(at, 0)) + vec4(sum, 0.0), vec4(kMostLight)));
}
