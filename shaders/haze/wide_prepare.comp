#version 460
// SPDX-License-Identifier: Apache-2.0
// Which rays of wide beams each pixel takes its haze from, and which pixels are lonely (shared/wide.h). Once for each camera.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/wide.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, rgba32f) readonly uniform image2DArray places;
layout(binding = 2, rgba8) writeonly uniform image2DArray weights; // of (0, 0), (1, 0), (0, 1), (1, 1)
layout(binding = 3, r16ui) writeonly uniform uimage2DArray lonely;
layout(push_constant, scalar) uniform Push { WidePush p; };

shared uint lonely_count;

float octaves(ivec2 at) {
    vec4 place = imageLoad(places, ivec3(at, 0));
    return log2(place.w < 0.0 ? view.far_m : length(place.xyz - view.eye_m));
}

void main() {
    if (gl_LocalInvocationIndex == 0u) lonely_count = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 last = ivec2(view.width, view.height) - 1;
    ivec2 at = min(pixel, last);
    int step = int(p.step);
    ivec2 low = at / step;
    ivec2 high = min(low + 1, last / step);
    vec2 part = vec2(at - low * step) / float(step);
    vec4 near = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y, part.x * part.y);
    vec4 there = vec4(octaves(low * step), octaves(ivec2(high.x, low.y) * step), octaves(ivec2(low.x, high.y) * step),
                      octaves(high * step));
    vec4 weight = mix(vec4(0.0), near, lessThan(abs(there - octaves(at)), vec4(kWideAlike)));
    float sum = dot(weight, vec4(1.0));
    bool is_lonely = sum < kWideLeast;

    // In steps of 1 / 255 that sum to one: the last of them makes up for the rounding of the others.
    vec4 most = floor(weight / max(sum, 1e-6) * 255.0 + 0.5);
    float rest = 255.0 - dot(most, vec4(1.0));
    float largest = max(max(most.x, most.y), max(most.z, most.w));
    vec4 first = most.x == largest   ? vec4(1, 0, 0, 0)
                 : most.y == largest ? vec4(0, 1, 0, 0)
                 : most.z == largest ? vec4(0, 0, 1, 0)
                                     : vec4(0, 0, 0, 1);
    bool inside = all(lessThanEqual(pixel, last));
    if (inside) imageStore(weights, ivec3(at, 0), is_lonely ? vec4(0.0) : (most + rest * first) / 255.0);

    uint slot = 0u;
    if (inside && is_lonely) slot = atomicAdd(lonely_count, 1u);
    barrier();
    ivec2 tile = ivec2(gl_WorkGroupID.xy * uvec2(kTileWidth, kTileHeight));
    uint count = lonely_count << kLonelyCount;
    if (inside && is_lonely)
        imageStore(lonely, ivec3(tile + ivec2(slot % kTileWidth, slot / kTileWidth), 0),
                   uvec4(gl_LocalInvocationIndex | (slot == 0u ? count : 0u)));
    if (gl_LocalInvocationIndex == 0u && count == 0u) imageStore(lonely, ivec3(tile, 0), uvec4(0u));
}
