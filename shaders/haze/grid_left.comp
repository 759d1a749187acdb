#version 460
// SPDX-License-Identifier: Apache-2.0
// Draws the pixels that a light's grid left (grid_look_up.comp), ray by ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#include "shared/develop.h"
#include "shared/fan.h"
#include "shared/haze.h"
#include "shared/optics.h"

layout(local_size_x = 128) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 3, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 4, rgba16f) uniform image2DArray drawn;
layout(binding = 8, scalar) readonly buffer Left { LeftHead head; uint left[]; };
layout(push_constant, scalar) uniform Push { GridPush p; };

#define GATE p.gate
#define TABLES 5
#include "common/gate_scatter.glsl"

void main() {
    fan_index = p.gate.batch;
    bool inside = gl_GlobalInvocationID.x < head.count;
    uint pixel = inside ? left[gl_GlobalInvocationID.x] : 0u;
    ivec2 at = ivec2(pixel & 0xffffu, pixel >> 16u);
    vec2 ndc = vec2(2.0 * (float(at.x) + 0.5) / float(view.width) - 1.0, 1.0 - 2.0 * (float(at.y) + 0.5) / float(view.height));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec4 surface = imageLoad(places, ivec3(at, 0));
    float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;
    vec3 sum = scattered(lights[fan_index], fans[fan_index], dir, inside ? far : 0.0);
    ivec3 to = ivec3(at, 1);
    if (inside) imageStore(drawn, to, light_to_store(imageLoad(drawn, to) + vec4(sum, 0.0)));
}
