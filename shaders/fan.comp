#version 460
// SPDX-License-Identifier: Apache-2.0
// Fills the fans of a batch of lights (shared/fan.h): along every meridian the prefix sums of what the gate lets through and,
// in alpha, of the first moment of its luminance, once for each level of blur. One invocation is one row of one level.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/develop.h"
#include "shared/fan.h"

layout(local_size_x = 16) in;
layout(binding = 1, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform FanBlock { Fan fans[kLightsPerChunk]; };
layout(binding = 3) writeonly uniform image2DArray table;
layout(push_constant, scalar) uniform Push { FanPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

void fill(Light light, Fan fan) {
    // Rows of all levels lie one after another.
    uint level = 0u;
    uint row = gl_GlobalInvocationID.x;
    for (uint before = 0u; before < kFanLevels; ++before) {
        uint rows = fan_side(fan.size, before);
        bool beyond = level == before && row >= rows;
        row -= beyond ? rows : 0u;
        level += beyond ? 1u : 0u;
    }
    bool wanted = level < fan.levels;
    level = min(level, fan.levels - 1u);
    uint side = fan_side(fan.size, level);
    float blur = fan.levels > 1u ? fan.sharpest * exp2(float(level)) : max(light.edge, fan.sharpest);
    float most = fan_most(light.colour_b);

    vec2 meridian = fan_meridian(fan, 2.0 * float(row) / float(side - 1u) - 1.0);
    vec2 chord = fan_chord(fan, meridian.x);
    vec3 aside = fan.along * meridian.x + fan.across * meridian.y;
    vec3 pole = vec3(dot(fan.pole, light.axis_u), dot(fan.pole, light.axis_v), dot(fan.pole, light.axis_w));
    vec3 side_axis = vec3(dot(aside, light.axis_u), dot(aside, light.axis_v), dot(aside, light.axis_w));
    float step_rad = max(chord.y - chord.x, 0.0) / float(side - 1u);
    float share = 1.0 / float(side - 1u);
    // The direction turns by one step per column.
    vec2 turn = vec2(cos(step_rad), sin(step_rad));
    vec2 now = vec2(cos(chord.x + 0.5 * step_rad), sin(chord.x + 0.5 * step_rad));
    vec4 sum = vec4(0.0);
    ivec3 at = ivec3(fan_left(fan, level), row, fan.layer);
    uint columns = wanted ? side : 0u;
    for (uint column = 0u; column < columns; ++column) {
        imageStore(table, at, sum);
        vec3 direction = pole * now.x + side_axis * now.y;
        vec2 gate = direction.xy / (max(direction.z, 1e-4) * light.tan_field);
        vec3 value = beam_gate(light, gate, blur) * (share / most);
        sum += vec4(value, luminance_of(value) * (float(column) + 0.5) * share);
        now = vec2(now.x * turn.x - now.y * turn.y, now.y * turn.x + now.x * turn.y);
        at.x += 1;
    }
}

void main() {
    if (kSingle)
        fill(lights[p.first], fans[p.first]);
    else
        fill(lights[p.first + gl_WorkGroupID.y], fans[p.first + gl_WorkGroupID.y]);
}
