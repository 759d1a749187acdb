#version 460
// SPDX-License-Identifier: Apache-2.0
// How far each node of a light's grid is from a straight line between the columns beside it (grid.glsl).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"
#include "shared/fan.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray filled;
layout(binding = 1, rgba16f) writeonly uniform image2DArray grid;
layout(push_constant, scalar) uniform Push { GridPush p; };

const float kUnknown = 1e4;

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (node.x >= int(p.grid.columns) || node.y >= int(p.grid.rows)) return;
    for (int layer = 0; layer < 2; ++layer) {
        vec4 here = imageLoad(filled, ivec3(node, layer));
        vec4 before = imageLoad(filled, ivec3(max(node.x - 1, 0), node.y, layer));
        vec4 after = imageLoad(filled, ivec3(min(node.x + 1, int(p.grid.columns) - 1), node.y, layer));
        bool rim = node.x == 0 || node.x == int(p.grid.columns) - 1;
        float bent = abs(luminance_of(before.rgb + after.rgb - 2.0 * here.rgb));
        bool known = here.a == 0.0 && (rim || (before.a == 0.0 && after.a == 0.0));
        imageStore(grid, ivec3(node, layer), vec4(here.rgb, known ? bent : kUnknown));
    }
    imageStore(grid, ivec3(node, 2), imageLoad(filled, ivec3(node, 2)));
}
