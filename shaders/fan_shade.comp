#version 460
// SPDX-License-Identifier: Apache-2.0
// How far the light gets along the directions of a fan (shared/fan.h), from the light's distance map: nearest and farthest of
// 1, 2, 4 .. neighbouring columns (Chen et al. 2011). One invocation is one row.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define DISTANCE_MAPS 3
#include "octahedral_map.glsl"
#include "shared/fan.h"

layout(local_size_x = 16) in;
layout(binding = 0, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 1, scalar) uniform FanBlock { Fan fans[kLightsPerChunk]; };
layout(binding = 2, rg32f) uniform image2DArray shade;
layout(push_constant, scalar) uniform Push { FanPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

void fill(uint map, Fan fan) {
    int size = textureSize(distance_maps, 0).x;
    uint row = gl_GlobalInvocationID.x;
    vec2 meridian = fan_meridian(fan, (2.0 * float(row) + 1.0) / float(kShadeRows) - 1.0);
    vec4 chord = fan_chord(fan, meridian.x);
    vec3 aside = fan.along * meridian.x + fan.across * meridian.y;
    vec3 centre = fan.pole * chord.x + aside * chord.y;
    vec3 turn = aside * chord.x - fan.pole * chord.y;
    for (uint column = 0u; column < kShadeColumns; ++column) {
        float u = chord.w * ((2.0 * float(column) + 1.0) / float(kShadeColumns) - 1.0);
        vec2 place = octahedral_from(centre + turn * u) * float(size);
        float reach_m = map_texel(map, ivec2(floor(place)), size);
        reach_m = map == 0u ? kNothing_m : reach_m;
        imageStore(shade, ivec3(column, row, fan.layer), vec4(reach_m, reach_m, 0.0, 0.0));
    }
    uint left = 0u;
    for (uint columns = kShadeColumns / 2u; columns > 0u; columns /= 2u) {
        uint next = left + 2u * columns;
        for (uint column = 0u; column < columns; ++column) {
            vec2 a = imageLoad(shade, ivec3(left + 2u * column, row, fan.layer)).xy;
            vec2 b = imageLoad(shade, ivec3(left + 2u * column + 1u, row, fan.layer)).xy;
            imageStore(shade, ivec3(next + column, row, fan.layer), vec4(min(a.x, b.x), max(a.y, b.y), 0.0, 0.0));
        }
        left = next;
    }
}

void main() {
    if (kSingle)
        fill(lights[p.first].map, fans[p.first]);
    else
        fill(lights[p.first + gl_WorkGroupID.y].map, fans[p.first + gl_WorkGroupID.y]);
}
