#version 460
// SPDX-License-Identifier: Apache-2.0
// From light at coarse points to the picture (shared/coarse.h). An invocation is a cell of four pixels, which share four points.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "common/coarse.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32ui) readonly uniform uimage2DArray sums;
layout(binding = 1, rgba32ui) readonly uniform uimage2DArray cells;
layout(binding = 2, rgba16f) readonly uniform image2DArray base; // the picture without lights
layout(binding = 3, rgba16f) writeonly uniform image2DArray frame;

#include "common/coarse_light.glsl"

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy), size = imageSize(base).xy, last = (size + 1) / 2 - 1;
    if (any(greaterThan(cell, last + 1))) return;
    CoarseLight light[4];
    for (int k = 0; k < 4; ++k) light[k] = coarse_light(clamp(cell - 1 + ivec2(k & 1, k >> 1), ivec2(0), last));
    uvec4 surfaces = imageLoad(cells, ivec3(cell, kCellSurfaces)), hazes = imageLoad(cells, ivec3(cell, kCellHaze)),
          reflects = imageLoad(cells, ivec3(cell, kCellReflects));
    for (int k = 0; k < 4; ++k) {
        ivec2 at = 2 * cell - 1 + ivec2(k & 1, k >> 1);
        bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
        vec4 w = unpackUnorm4x8(surfaces[k]), h = unpackUnorm4x8(hazes[k]);
        vec3 white = w.x * light[0].white + w.y * light[1].white + w.z * light[2].white + w.w * light[3].white;
        vec3 haze = h.x * light[0].haze + h.y * light[1].haze + h.z * light[2].haze + h.w * light[3].haze;
        vec3 sum = imageLoad(base, ivec3(clamp(at, ivec2(0), size - 1), 0)).rgb + white * unpack_shared_exponent(reflects[k]) + haze;
        if (inside) imageStore(frame, ivec3(at, 0), light_to_store(vec4(sum, 0.0)));
    }
}
