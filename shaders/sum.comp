#version 460
// SPDX-License-Identifier: Apache-2.0
// A sum of kept images: the additions of the light tree (Screen Space Re-Rendering, section 3).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray base; // the picture without lights
layout(binding = 1, rgba32f) uniform image2DArray images;
layout(push_constant, scalar) uniform Push { SumPush p; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, textureSize(base, 0).xy))) return;
    vec4 sum = p.add_base != 0u ? texelFetch(base, ivec3(at, 0), 0) : vec4(0.0);
    uint first = p.accumulate != 0u ? 0u : 1u;
    for (uint k = first; k < p.addend_count + 1u; ++k)
        sum += imageLoad(images, ivec3(at, k == 0u ? p.target : p.addend[k - 1u]));
    imageStore(images, ivec3(at, p.target), sum);
}
