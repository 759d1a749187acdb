#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds the light of extra fragments to their pixels: silhouettes.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1) uniform usampler2DArray edges; // pixel, index of its first extra fragment * 4 + their number
layout(binding = 2, rgba16f) uniform image2DArray drawn;
layout(push_constant, scalar) uniform Push { FoldPush p; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= p.edge_count) return;
    uvec2 edge = texelFetch(edges, ivec3(i % view.width, i / view.width, 0), 0).xy;
    ivec3 at = ivec3(edge.x % view.width, edge.x / view.width, 0);
    uint first = edge.y >> 2;
    vec4 sum = imageLoad(drawn, at);
    for (uint k = first; k < first + (edge.y & 3u); ++k)
        sum += imageLoad(drawn, ivec3(k % view.width, view.height + k / view.width, 0));
    imageStore(drawn, at, light_to_store(sum));
}
