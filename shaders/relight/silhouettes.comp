#version 460
// SPDX-License-Identifier: Apache-2.0
// From which of a pixel's neighbours each of its extra fragments takes its haze (fold.comp): the one whose surface is as far away.
// Once for each picture of the stage; frames look it up. One invocation is one pixel on an edge.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1) uniform usampler2DArray edges; // pixel, index of its first extra fragment * 4 + their number
layout(binding = 2, rgba32f) readonly uniform image2DArray places;
layout(binding = 3, r16ui) writeonly uniform uimage2DArray sources; // as edges: four bits for each extra fragment, see push.h
layout(push_constant, scalar) uniform Push { FoldPush p; };

// Surfaces whose distances differ by less, in octaves, have the same haze in front.
const float kStep = 0.1;

float distance_m(vec4 place) { return place.w < 0.0 ? view.far_m : length(place.xyz - view.eye_m); }

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= p.edge_count) return;
    ivec3 entry = ivec3(i % view.width, i / view.width, 0);
    uvec2 edge = texelFetch(edges, entry, 0).xy;
    ivec2 at = ivec2(edge.x % view.width, edge.x / view.width);
    uint first = edge.y >> 2;
    uint count = edge.y & 3u;
    // Logarithms: a surface twice as far is as different as one half as far.
    vec3 wanted = vec3(0.0);
    for (uint k = 0u; k < count; ++k)
        wanted[k] = log2(distance_m(imageLoad(places, ivec3((first + k) % view.width, view.height + (first + k) / view.width, 0))));
    ivec2 last = ivec2(view.width, view.height) - 1;
    uvec3 source = uvec3(kOwnHaze);
    // A neighbour is some other ray: only where that error is the smaller one.
    vec3 step = abs(wanted - log2(distance_m(imageLoad(places, ivec3(at, 0)))));
    vec3 worst = mix(vec3(-1.0), 0.3 * step, greaterThan(step, vec3(kStep)));
    for (uint n = 0u; n < 8u; ++n) {
        uint cell = n < kOwnHaze ? n : n + 1u;
        ivec2 to = clamp(at + ivec2(cell % 3u, cell / 3u) - 1, ivec2(0), last);
        vec3 apart = abs(wanted - log2(distance_m(imageLoad(places, ivec3(to, 0)))));
        source = mix(source, uvec3(cell), lessThan(apart, worst));
        worst = min(worst, apart);
    }
    imageStore(sources, entry, uvec4(source.x | source.y << 4 | source.z << 8, 0u, 0u, 0u));
}
