#version 460
// SPDX-License-Identifier: Apache-2.0
// Silhouettes of a picture whose light is coarse: adds the light of extra fragments to their pixels, and for their fraction of the pixel the haze
// in front of them instead of that before the main one (as fold.comp).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "common/coarse.glsl"

layout(local_size_x = 64) in;
layout(binding = 0, rgba32ui) readonly uniform uimage2DArray sums;
layout(binding = 1, rgba32ui) readonly uniform uimage2DArray cells;
layout(binding = 2) uniform usampler2DArray edges;
layout(binding = 3, rgba32ui) readonly uniform uimage2DArray extras;
layout(binding = 4, rgba16f) uniform image2DArray frame;
layout(push_constant, scalar) uniform Push { CoarsePush p; };

#include "common/coarse_light.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    ivec2 size = imageSize(frame).xy, last = (size + 1) / 2 - 1;
    uint width = uint(size.x);
    if (i >= p.count) return;
    uvec2 edge = texelFetch(edges, ivec3(i % width, i / width, 0), 0).xy;
    uint count = edge.y & 3u;
    if (count == 0u) return; // room for an edge
    ivec2 at = ivec2(edge.x % width, edge.x / width), cell = (at + 1) / 2, local = (at + 1) & 1;
    CoarseLight light[4];
    for (int k = 0; k < 4; ++k) light[k] = coarse_light(clamp(cell - 1 + ivec2(k & 1, k >> 1), ivec2(0), last));
    vec4 main_haze = unpackUnorm4x8(imageLoad(cells, ivec3(cell, kCellHaze))[local.x + 2 * local.y]);
    vec3 sum = imageLoad(frame, ivec3(at, 0)).rgb;
    for (uint k = edge.y >> 2; k < (edge.y >> 2) + count; ++k) {
        uvec4 extra = imageLoad(extras, ivec3(k % width, k / width, 0));
        vec4 w = unpackUnorm4x8(extra.x), h = uintBitsToFloat(extra.w) * (unpackUnorm4x8(extra.y) - main_haze);
        vec3 white = w.x * light[0].white + w.y * light[1].white + w.z * light[2].white + w.w * light[3].white;
        sum += white * unpack_shared_exponent(extra.z) + h.x * light[0].haze + h.y * light[1].haze + h.z * light[2].haze + h.w * light[3].haze;
    }
    imageStore(frame, ivec3(at, 0), light_to_store(vec4(max(sum, vec3(0.0)), 0.0)));
}
