#version 460
// SPDX-License-Identifier: Apache-2.0
// Fills the grid of a light (grid.glsl): layer 0 with what rays gather up to the surface that they meet, layer 1 with where they end.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#include "shared/develop.h"
#include "shared/fan.h"
#include "shared/haze.h"
#include "shared/optics.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 3, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 4, rgba16f) writeonly uniform image2DArray grid;
layout(push_constant, scalar) uniform Push { GridPush p; };

#define GATE p.gate
#define TABLES 5
#include "common/gate_scatter.glsl"
#include "common/grid.glsl"

const float kMargin = 0.1;  // of the picture, beyond which no node is needed
const float kRim = 0.9995; // the last rows are those of the rim

void main() {
    fan_index = p.gate.batch;
    uvec2 node = gl_GlobalInvocationID.xy;
    bool inside = node.x < p.grid.columns && node.y < p.grid.rows;
    float h = grid_tangent(float(node.x) / float(p.grid.columns - 1u));
    float row = clamp(2.0 * float(node.y) / float(p.grid.rows - 1u) - 1.0, -kRim, kRim);
    float cosine = (h * h - 1.0) / (1.0 + h * h), sine = max(2.0 * h / (1.0 + h * h), kLeastSine);
    vec2 meridian = fan_meridian(fans[fan_index].beam, row);
    vec3 dir = fans[fan_index].beam.pole * cosine + (fans[fan_index].beam.along * meridian.x + fans[fan_index].beam.across * meridian.y) * sine;
    float depth = dot(dir, view.forward);
    vec2 ndc = vec2(dot(dir, view.right) / dot(view.right, view.right), dot(dir, view.up) / dot(view.up, view.up)) / max(depth, 1e-3);
    bool seen = inside && depth > 1e-3 && all(lessThan(abs(ndc), vec2(1.0 + kMargin)));
    vec2 size = vec2(view.width, view.height);
    ivec2 at = ivec2(clamp((vec2(0.5) + vec2(0.5, -0.5) * ndc) * size, vec2(0.0), size - 1.0));
    vec4 surface = imageLoad(places, ivec3(at, 0));
    float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;
    GridRay ray = grid_ray(lights[fan_index], fans[fan_index], dir, far);
    vec3 sum = kGridScale * gathered(lights[fan_index], fans[fan_index], dir, seen ? far : 0.0);
    if (!inside) return;
    imageStore(grid, ivec3(node, 0), vec4(sum, seen ? 0.0 : kUnknown));
    imageStore(grid, ivec3(node, 1), vec4(clamp(ray.end, 0.0, 1.0), 0.0, 0.0, 0.0));
}
