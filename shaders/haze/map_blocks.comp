#version 460
// SPDX-License-Identifier: Apache-2.0
// From the depth of a drawn layer to a block of a distance map: metres along the ray of each texel, rounded as scene::to_half does.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/map_draw.h"
#include "shared/octahedral.h"

layout(local_size_x = 32, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1, scalar) readonly buffer Blocks { MapBlock blocks[]; };
layout(binding = 2) uniform writeonly image2DArray texels;
layout(push_constant, scalar) uniform Push { MapBlocksPush p; };

const uint kNoSurface = 0x7b53u; // scene::kNoSurface
const float kNoSurface_m = 6e4;
const float kLeastNormal = 6.103515625e-5;

uint half_of(float metres) {
    if (metres < kLeastNormal) return packHalf2x16(vec2(metres, 0.0)) & 0xffffu;
    return ((floatBitsToUint(metres) + (1u << 12)) >> 13) - ((127u - 15u) << 10);
}

void main() {
    MapBlock block = blocks[p.first + gl_WorkGroupID.x];
    for (uint row = gl_LocalInvocationID.y; row < kMapBlock; row += gl_WorkGroupSize.y) {
        uvec2 at = uvec2(block.x + gl_LocalInvocationID.x, block.y + row);
        float depth = texelFetch(depths, ivec3(at, block.layer), 0).x;
        vec3 way = direction_from_octahedral((vec2(at) + 0.5) / float(p.side));
        float metres = kMapNear_m / (max(depth, 1e-30) * (abs(way.x) + abs(way.y) + abs(way.z)));
        uint bits = metres < kNoSurface_m ? half_of(metres) : kNoSurface;
        imageStore(texels, ivec3(at, block.map), vec4(unpackHalf2x16(bits).x, 0.0, 0.0, 0.0));
    }
}
