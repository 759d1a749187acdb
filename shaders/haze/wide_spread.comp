#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds the haze of wide beams, which was drawn for every few pixels only, to all pixels (shared/wide.h).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/wide.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba8) readonly uniform image2DArray weights;
layout(binding = 1, rgba16f) readonly uniform image2DArray rays;
layout(binding = 2, rgba16f) uniform image2DArray drawn;
layout(push_constant, scalar) uniform Push { WidePush p; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 last = imageSize(weights).xy - 1;
    if (any(greaterThan(at, last))) return;
    ivec2 low = at / int(p.step);
    ivec2 high = min(low + 1, last / int(p.step));
    vec4 weight = imageLoad(weights, ivec3(at, 0));
    vec4 sum = imageLoad(drawn, ivec3(at, 1));
    sum += weight.x * imageLoad(rays, ivec3(low, 0)) + weight.y * imageLoad(rays, ivec3(high.x, low.y, 0)) +
           weight.z * imageLoad(rays, ivec3(low.x, high.y, 0)) + weight.w * imageLoad(rays, ivec3(high, 0));
    imageStore(drawn, ivec3(at, 1), light_to_store(sum));
}
