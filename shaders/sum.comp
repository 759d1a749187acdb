#version 460
// SPDX-License-Identifier: Apache-2.0
// A sum of kept images, each with its weight: the additions of the light tree (Screen Space Re-Rendering, section 3).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray base;  // the picture without lights
layout(binding = 1, rgba16f) readonly uniform image2DArray drawn; // lights drawn just now: layer 0 surfaces, layer 1 haze
layout(binding = 2, rgba16f) uniform image2DArray images;
layout(binding = 3, scalar) readonly buffer TileList { uint tile_list[]; };
layout(binding = 4, scalar) uniform AddendBlock { Addend addends[kMostAddends]; };
layout(push_constant, scalar) uniform Push { SumPush p; };
// Haze was sampled at the corners of the pixels, not in their middle.
layout(constant_id = 0) const bool kCorners = false;

void main() {
    uvec2 tile = gl_WorkGroupID.xy;
    if (p.listed != 0u) {
        uint number = tile_list[gl_WorkGroupID.x];
        tile = uvec2(number % p.tiles_x, number / p.tiles_x);
    }
    ivec2 at = ivec2(tile * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
    ivec2 last = imageSize(base).xy - 1;
    if (any(greaterThan(at, last))) return;
    vec4 sum = p.add_base != 0u ? imageLoad(base, ivec3(at, 0)) : vec4(0.0);
    for (uint once = p.add_drawn != 0u ? 0u : 1u; once < 1u; ++once) {
        sum += imageLoad(drawn, ivec3(at, 0));
        if (kCorners) {
            // Every corner of a 2x2 block has its own offset along the ray (interleaved sampling, Keller & Heidrich 2001): the
            // mean of the four corners has all offsets, everywhere, so hardly any noise is left.
            ivec2 next = min(at + 1, last);
            sum += 0.25 * (imageLoad(drawn, ivec3(at, 1)) + imageLoad(drawn, ivec3(next.x, at.y, 1)) +
                           imageLoad(drawn, ivec3(at.x, next.y, 1)) + imageLoad(drawn, ivec3(next, 1)));
        } else {
            sum += imageLoad(drawn, ivec3(at, 1));
        }
    }
    if (p.accumulate != 0u) sum += imageLoad(images, ivec3(at, p.target));
    for (uint k = 0u; k < p.addend_count; ++k)
        sum.rgb += addends[k].weight * imageLoad(images, ivec3(at, addends[k].layer)).rgb;
    imageStore(images, ivec3(at, p.target), light_to_store(sum));
}
