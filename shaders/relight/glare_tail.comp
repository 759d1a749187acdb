#version 460
// SPDX-License-Identifier: Apache-2.0
// The far part of the glare: every texel of the coarsest level lights every other one, so that a strong source has a round halo
// without an end. A few hundred texels.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/glare.h"

layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray from;
layout(binding = 1, rgba16f) writeonly uniform image2DArray to;
layout(push_constant, scalar) uniform Push { GlareTailPush p; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(to).xy;
    if (any(greaterThanEqual(at, size))) return;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            sum += imageLoad(from, ivec3(x, y, 0)) * glare_tail(vec2(at - ivec2(x, y)), p.texel_deg);
    imageStore(to, ivec3(at, 0), light_to_store(sum * p.weight));
}
