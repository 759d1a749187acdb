#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds a coarser level of the glare to the next finer one, or the finest to the frame: texels blended 3 : 1 along both axes.
// An invocation makes 2x2 texels of 3x3. (Loads of its own: four samples of a sampler take twice as long on lavapipe.)
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/glare.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray coarse;
layout(binding = 1, rgba16f) readonly uniform image2DArray fine;
layout(binding = 2, rgba16f) writeonly uniform image2DArray sum;
layout(push_constant, scalar) uniform Push { GlareUpPush p; };

void put(ivec2 at, ivec2 size, vec4 above) {
    if (any(greaterThanEqual(at, size))) return;
    vec3 light = light_of_frame(imageLoad(fine, ivec3(at, 0))) * p.fine_weight + above.rgb * (p.coarse_weight / 16.0);
    float over = max(max(light.x, max(light.y, light.z)) / kMostLight, 1.0);
    imageStore(sum, ivec3(at, 0), light_to_store(vec4(light / over, over - 1.0)));
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = ivec2(p.width, p.height);
    if (any(greaterThanEqual(2 * at, size))) return;
    ivec2 last = imageSize(coarse).xy - 1;
    ivec2 low = max(at - 1, 0), high = min(at + 1, last);
    vec4 left[3], right[3];
    for (int y = 0; y < 3; ++y) {
        int row = y == 0 ? low.y : (y == 1 ? at.y : high.y);
        vec4 middle = 3.0 * imageLoad(coarse, ivec3(at.x, row, 0));
        left[y] = middle + imageLoad(coarse, ivec3(low.x, row, 0));
        right[y] = middle + imageLoad(coarse, ivec3(high.x, row, 0));
    }
    put(2 * at, size, 3.0 * left[1] + left[0]);
    put(2 * at + ivec2(1, 0), size, 3.0 * right[1] + right[0]);
    put(2 * at + ivec2(0, 1), size, 3.0 * left[1] + left[2]);
    put(2 * at + 1, size, 3.0 * right[1] + right[2]);
}
