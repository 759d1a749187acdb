#version 460
// SPDX-License-Identifier: Apache-2.0
// How far each node of a light's grid is from a straight line between the columns beside it, as a fraction of its light (grid.glsl).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"
#include "shared/fan.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray filled;
layout(binding = 1, rgba16f) writeonly uniform image2DArray grid;
layout(push_constant, scalar) uniform Push { GridPush p; };

#include "common/grid.glsl"

const float kFaint = 0.03; // in grid units: what is darker is not seen

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (node.x >= int(p.grid.columns) || node.y >= int(p.grid.rows)) return;
    ivec2 left = ivec2(max(node.x - 1, 0), node.y), right = ivec2(min(node.x + 1, int(p.grid.columns) - 1), node.y);
    vec4 here = imageLoad(filled, ivec3(node, 0)), before = imageLoad(filled, ivec3(left, 0)), after = imageLoad(filled, ivec3(right, 0));
    float end = imageLoad(filled, ivec3(node, 1)).x;
    // Beside a ray that ends elsewhere the pixels find out for themselves.
    before = before.a > 0.0 || abs(imageLoad(filled, ivec3(left, 1)).x - end) > kEndDoubt * end ? here : before;
    after = after.a > 0.0 || abs(imageLoad(filled, ivec3(right, 1)).x - end) > kEndDoubt * end ? here : after;
    float doubt = abs(luminance_of(before.rgb + after.rgb - 2.0 * here.rgb)) / (luminance_of(here.rgb) + kFaint);
    imageStore(grid, ivec3(node, p.layer), vec4(here.rgb, here.a > 0.0 ? kUnknown : min(doubt, kUnknown)));
    imageStore(grid, ivec3(node, p.layer + 1u), vec4(end, 0.0, 0.0, 0.0));
}
