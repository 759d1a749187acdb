#version 460
// SPDX-License-Identifier: Apache-2.0
// Which rays of a plane the light of a direction still reaches (fan_shade in shared/fan.h), from the light's distance map: least
// and most of 1, 2, 4 .. neighbouring columns (Chen et al. 2011). One invocation is one row; rows lie along x.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define DISTANCE_MAPS 3
#include "common/octahedral_map.glsl"
#include "shared/fan.h"

layout(local_size_x = 16) in;
layout(binding = 0, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 1, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 2, rg32f) uniform image2DArray shade;
layout(push_constant, scalar) uniform Push { FanPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

const float kAlwaysLit = 2.0; // above every cosine

// How far from the map's place the light gets in a direction (unit).
float reach_of(uint map, vec3 direction, int size) {
    ivec2 at = min(ivec2(octahedral_from(direction) * float(size)), size - 1);
    return map == 0u ? kNothing_m : texelFetch(distance_maps, ivec3(at, int(max(map, 1u)) - 1), 0).x;
}

void fill(uint map, Fan fan) {
    int size = textureSize(distance_maps, 0).x;
    uint side = fan_shade_side(fan), rows = fan_shade_rows(fan);
    uint row = gl_GlobalInvocationID.x;
    vec2 meridian = fan_meridian(fan.shade, fan_straight((2.0 * float(row) + 1.0) / float(rows) - 1.0, fan.row_bend));
    vec4 chord = fan_chord(fan.shade, meridian);
    vec3 aside = fan.shade.along * meridian.x + fan.shade.across * meridian.y;
    vec3 centre = fan.shade.pole * chord.x + aside * chord.y;
    vec3 turn = aside * chord.x - fan.shade.pole * chord.y;
    float step = 2.0 / float(side);
    float place = 0.5 * step - 1.0;
    // The last rows and columns are for what lies beside the cone, right before the lens.
    bool beside = fan.shade.row_scale > 0.0 && (row == 0u || row == rows - 1u);
    uint columns = row < rows ? side : 0u;
    // Levels of 1, 2 and 4 columns.
    for (uint column = 0u; column < columns; column += 4u) {
        vec4 edge;
        for (uint k = 0u; k < 4u; ++k) {
            float u = chord.w * fan_straight(place, fan.column_bend);
            float unit = inversesqrt(1.0 + u * u);
            float reach_m = reach_of(map, (centre + turn * u) * unit, size);
            edge[k] = fan_shade(fan, (chord.xy + u * vec2(-chord.y, chord.x)) * unit, reach_m);
            edge[k] = beside || column + k == 0u || column + k == side - 1u ? kAlwaysLit : edge[k];
            imageStore(shade, ivec3(row, column + k, fan.layer), edge[k].xxxx);
            place += step;
        }
        vec2 least = min(edge.xz, edge.yw), most = max(edge.xz, edge.yw);
        imageStore(shade, ivec3(row, side + column / 2u, fan.layer), vec4(least.x, most.x, 0.0, 0.0));
        imageStore(shade, ivec3(row, side + column / 2u + 1u, fan.layer), vec4(least.y, most.y, 0.0, 0.0));
        imageStore(shade, ivec3(row, side + side / 2u + column / 4u, fan.layer),
                   vec4(min(least.x, least.y), max(most.x, most.y), 0.0, 0.0));
    }
    uint left = side + side / 2u;
    for (uint half_columns = columns / 8u; half_columns > 0u; half_columns /= 2u) {
        uint next = left + 2u * half_columns;
        for (uint column = 0u; column < half_columns; ++column) {
            vec2 a = imageLoad(shade, ivec3(row, left + 2u * column, fan.layer)).xy;
            vec2 b = imageLoad(shade, ivec3(row, left + 2u * column + 1u, fan.layer)).xy;
            imageStore(shade, ivec3(row, next + column, fan.layer), vec4(min(a.x, b.x), max(a.y, b.y), 0.0, 0.0));
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
