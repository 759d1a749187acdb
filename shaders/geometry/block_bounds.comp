#version 460
// SPDX-License-Identifier: Apache-2.0
// Bounds of the blocks of extra fragments, as those of the tiles. Places that no fragment fills are no surface; those of the
// last block are made so here.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"
#include "common/bounds.glsl"

layout(local_size_x = 128) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, rgba32f) uniform image2DArray places;
layout(binding = 2, scalar) writeonly buffer TileBounds { vec4 tile_bounds[]; };
layout(binding = 3, scalar) readonly buffer Counts { GatherCounts counts; };
layout(binding = 4, scalar) readonly buffer BlockList { BlockListHead block_head; uint block_list[]; };
layout(push_constant, scalar) uniform Push { GatherPush p; };

void main() {
    uint listed = gl_WorkGroupID.x;
    if (p.listed != 0u) listed = block_list[gl_WorkGroupID.x];
    uint index = listed * kTilePixels + gl_LocalInvocationIndex;
    ivec3 at = ivec3(index % view.width, view.height + index / view.width, 0);
    bool taken = index < counts.used;
    vec4 found = imageLoad(places, at);
    vec3 place = found.xyz;
    bool filled = taken && found.w >= 0.0;
    if (!taken) imageStore(places, at, vec4(0.0, 0.0, 0.0, -1.0));
    Box box = Box(filled ? place : vec3(kNowhere), filled ? place : vec3(-kNowhere), filled ? length(place - view.eye_m) : 0.0);
    box = box_of_group(box);
    vec3 centre = box.low.x <= box.high.x ? (box.low + box.high) * 0.5 : vec3(0.0);
    float reach_m = kBlockReach_px * 2.0 * length(view.right) / float(view.width) * length(place - view.eye_m);
    float radius = most_of_group(filled ? length(place - centre) + reach_m : -1.0);
    if (gl_LocalInvocationIndex == 0u) {
        uint block = p.tiles + listed;
        tile_bounds[block * 2u] = vec4(centre, radius);
        tile_bounds[block * 2u + 1u] = vec4(box.far_m, 0.0, 0.0, 0.0);
    }
}
