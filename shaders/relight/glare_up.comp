#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds a coarser level of the glare to the next finer one, or the finest to the frame. An invocation makes 2x2 texels.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/glare.h"
#include "common/glare_up.glsl"

layout(binding = 2, rgba16f) writeonly uniform image2DArray sum;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = ivec2(p.width, p.height);
    if (any(greaterThanEqual(2 * at, size))) return;
    vec3 above[4];
    load_above(at, above);
    for (int k = 0; k < 4; ++k) {
        ivec2 to = 2 * at + ivec2(k & 1, k >> 1);
        if (any(greaterThanEqual(to, size))) continue;
        vec3 light = with_glare(to, above[k]);
        float over = max(max(light.x, max(light.y, light.z)) / kMostLight, 1.0);
        imageStore(sum, ivec3(to, 0), light_to_store(vec4(light / over, over - 1.0)));
    }
}
