#version 460
// SPDX-License-Identifier: Apache-2.0
// Silhouettes: adds the light of extra fragments to their pixels, and mends the haze, which was summed up to the main fragment
// only: for the share of the pixel that an extra fragment covers, it is that of the neighbour whose surface lies as far away.
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
layout(push_constant, scalar) uniform Push { FoldPush p; };
layout(constant_id = 0) const bool kHaze = true;
layout(constant_id = 1) const bool kCorners = false; // haze was sampled at the corners of the pixels, see sum.comp

// Surfaces whose distances differ by less, in octaves, have the same haze in front.
const float kStep = 0.1;

float distance_m(vec4 place) { return place.w < 0.0 ? view.far_m : length(place.xyz - view.eye_m); }

vec4 haze_of(ivec2 at, ivec2 last) {
    vec4 haze = imageLoad(drawn, ivec3(at, 1));
    if (!kCorners) return haze;
    ivec2 next = min(at + 1, last);
    return 0.25 * (haze + imageLoad(drawn, ivec3(next.x, at.y, 1)) + imageLoad(drawn, ivec3(at.x, next.y, 1)) +
                   imageLoad(drawn, ivec3(next, 1)));
}

void fold_edge(uint i) {
    uvec2 edge = texelFetch(edges, ivec3(i % view.width, i / view.width, 0), 0).xy;
    ivec3 at = ivec3(edge.x % view.width, edge.x / view.width, 0);
    uint first = edge.y >> 2;
    uint count = edge.y & 3u;
    if (count == 0u) return; // room for an edge
    vec4 sum = imageLoad(drawn, at);
    for (uint k = first; k < first + count; ++k)
        sum += imageLoad(drawn, ivec3(k % view.width, view.height + k / view.width, 0));
    if (kHaze) {
        // Logarithms: a surface twice as far is as different as one half as far.
        vec3 wanted = vec3(0.0), cover = vec3(0.0);
        for (uint k = 0u; k < count; ++k) {
            vec4 place = imageLoad(places, ivec3((first + k) % view.width, view.height + (first + k) / view.width, 0));
            wanted[k] = log2(distance_m(place));
            cover[k] = place.w;
        }
        ivec2 last = ivec2(view.width, view.height) - 1;
        vec4 here = haze_of(at.xy, last);
        vec4 mended[3] = vec4[3](here, here, here);
        // A neighbour is some other ray: only where that error is the smaller one.
        vec3 step = abs(wanted - log2(distance_m(imageLoad(places, at))));
        vec3 worst = mix(vec3(-1.0), 0.3 * step, greaterThan(step, vec3(kStep)));
        for (int n = 0; n < 8; ++n) {
            int cell = n < 4 ? n : n + 1;
            ivec2 to = clamp(at.xy + ivec2(cell % 3 - 1, cell / 3 - 1), ivec2(0), last);
            vec3 apart = abs(wanted - log2(distance_m(imageLoad(places, ivec3(to, 0)))));
            vec4 there = haze_of(to, last);
            mended[0] = apart.x < worst.x ? there : mended[0];
            mended[1] = apart.y < worst.y ? there : mended[1];
            mended[2] = apart.z < worst.z ? there : mended[2];
            worst = min(worst, apart);
        }
        sum += cover.x * (mended[0] - here) + cover.y * (mended[1] - here) + cover.z * (mended[2] - here);
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
