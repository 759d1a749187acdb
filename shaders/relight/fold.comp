#version 460
// SPDX-License-Identifier: Apache-2.0
// Silhouettes: adds the light of extra fragments to their pixels, and mends the haze, which was summed up to the main fragment
// only: for the fraction of the pixel that an extra fragment covers, it is that of the neighbour whose surface lies as far away
// (silhouettes.comp).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1) uniform usampler2DArray edges; // pixel, index of its first extra fragment * 4 + their number
layout(binding = 2, rgba16f) uniform image2DArray drawn;
layout(binding = 3, rgba32f) readonly uniform image2DArray places;
layout(binding = 4, scalar) readonly buffer Rooms { TileRoom rooms[]; };
layout(binding = 5, scalar) readonly buffer TileList { uint tile_list[]; };
layout(binding = 6, r16ui) readonly uniform uimage2DArray sources; // of the haze, see silhouettes.comp
layout(push_constant, scalar) uniform Push { FoldPush p; };
layout(constant_id = 0) const bool kHaze = true;
layout(constant_id = 1) const bool kCorners = false; // haze was sampled at the corners of the pixels, see sum.comp

vec4 haze_of(ivec2 at, ivec2 last) {
    vec4 haze = imageLoad(drawn, ivec3(at, 1));
    if (!kCorners) return haze;
    ivec2 next = min(at + 1, last);
    return 0.25 * (haze + imageLoad(drawn, ivec3(next.x, at.y, 1)) + imageLoad(drawn, ivec3(at.x, next.y, 1)) +
                   imageLoad(drawn, ivec3(next, 1)));
}

void fold_edge(uint i) {
    ivec3 entry = ivec3(i % view.width, i / view.width, 0);
    uvec2 edge = texelFetch(edges, entry, 0).xy;
    ivec3 at = ivec3(edge.x % view.width, edge.x / view.width, 0);
    uint first = edge.y >> 2;
    uint count = edge.y & 3u;
    if (count == 0u) return; // room for an edge
    vec4 sum = imageLoad(drawn, at);
    ivec2 last = ivec2(view.width, view.height) - 1;
    vec4 here = vec4(0.0);
    uint source = 0u;
    if (kHaze) {
        here = haze_of(at.xy, last);
        source = imageLoad(sources, entry).x;
    }
    for (uint k = first; k < first + count; ++k) {
        ivec3 extra = ivec3(k % view.width, view.height + k / view.width, 0);
        sum += imageLoad(drawn, extra);
        if (!kHaze) continue;
        uint cell = source & 15u;
        source >>= 4;
        ivec2 to = clamp(at.xy + ivec2(cell % 3u, cell / 3u) - 1, ivec2(0), last);
        sum += imageLoad(places, extra).w * (haze_of(to, last) - here);
    }
    imageStore(drawn, at, light_to_store(sum));
}

void main() {
    uint first = gl_GlobalInvocationID.x;
    uint end = min(first + 1u, p.edge_count);
    if (p.listed != 0u) { // the edges of a tile
        TileRoom room = rooms[tile_list[gl_WorkGroupID.x]];
        first = room.first_edge + gl_LocalInvocationIndex;
        end = room.first_edge + room.edges;
    }
    for (uint i = first; i < end; i += 64u) fold_edge(i);
}
