#version 460
// SPDX-License-Identifier: Apache-2.0
// Fills the fans of a batch of lights (shared/fan.h): along every meridian the prefix sums of what the gate lets through and,
// in alpha, of the first moment of its luminance, once for each level of blur. One invocation is one row of one level.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define GOBO_LEVEL
#define SLIDES 4
#include "common/gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/develop.h"
#include "shared/fan.h"

layout(local_size_x = 16) in;
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 3) writeonly uniform image2DArray table;
layout(push_constant, scalar) uniform Push { FanPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

// Of the line from + u step through the gate, scaled so that z is 1 there: where it runs over the panel of a projector, blurred. All
// bounds are linear in u.
vec2 panel_part(Light light, vec3 from, vec3 step, float blur) {
    const float kSpare = 1.03;
    vec3 row_z = light.slide.panel[2];
    vec2 part = vec2(-1e9, 1e9);
    for (int side = 0; side < 4; ++side) {
        vec3 row = light.slide.panel[side >> 1];
        float rim = kSpare + blur / max(row_z.z, 1e-3) * length(row.xy);
        vec3 inside = rim * row_z + ((side & 1) == 0 ? row : -row);
        float at = dot(inside, from), slope = dot(inside, step);
        float meets = -at / (abs(slope) < 1e-9 ? 1e-9 : slope);
        if (slope >= 0.0) part.x = max(part.x, meets);
        else part.y = min(part.y, meets);
    }
    return part;
}

void fill(Light light, Fan fan) {
    // Rows of all levels lie one after another.
    uint level = 0u;
    uint row = gl_GlobalInvocationID.x;
    for (uint before = 0u; before < (IS_SHAPED(light) ? fan.levels : kFanLevels); ++before) {
        uint rows = IS_SHAPED(light) ? fan_node_side(fan.place[before]) : fan_side(fan, before);
        bool beyond = level == before && row >= rows;
        row -= beyond ? rows : 0u;
        level += beyond ? 1u : 0u;
    }
    bool wanted = level < fan.levels;
    level = min(level, fan.levels - 1u);
    uint side = IS_SHAPED(light) ? fan_node_side(fan.place[level]) : fan_side(fan, level);
    uvec2 corner = IS_SHAPED(light) ? fan_node_corner(fan.place[level]) : uvec2(fan_left(fan, level), 0u);
    float blur = fan.levels > 1u ? fan.sharpest * exp2(float(level)) : max(light.edge, fan.sharpest);
    Focus focus = even_focus(light, blur);
    // Detail finer than a column would be cut into steps.
    if (IS_SHAPED(light)) focus = focus_at(light, fan.node[level].x, 2.0 * light.cut_radius / float(side));
    vec2 meridian = fan_meridian(fan.beam, 2.0 * float(row) / float(side - 1u) - 1.0);
    vec4 chord = fan_chord(fan.beam, meridian);
    vec3 aside = fan.beam.along * meridian.x + fan.beam.across * meridian.y;
    vec3 pole = vec3(dot(fan.beam.pole, light.axis_u), dot(fan.beam.pole, light.axis_v), dot(fan.beam.pole, light.axis_w));
    vec3 side_axis = vec3(dot(aside, light.axis_u), dot(aside, light.axis_v), dot(aside, light.axis_w));
    // The line in the gate, and how far a column goes along it.
    vec3 centre = pole * chord.x + side_axis * chord.y;
    vec3 turn = side_axis * chord.x - pole * chord.y;
    uint columns = IS_SHAPED(light) ? side >> fan.plain : side;
    float fraction = 1.0 / float(columns - 1u);
    float u = chord.w * (fraction - 1.0);
    float step_u = 2.0 * chord.w * fraction;
    vec4 sum = vec4(0.0);
    float place = 0.5 * fraction;
    ivec3 at = ivec3(corner.x, corner.y + row, fan.layer);
    // Levels of blur are whole levels of the gobos; a level between two costs twice as much.
    float whole = gobo_level_of(blur);
    gobo_level = fan.levels > 1u ? floor(whole + 0.5) : whole;
    if (IS_SHAPED(light)) gobo_level = fan.plain != 0u ? kWholeLevelOfBlur : kLevelOfBlur;
    if (HAS_SLIDE(light) && !IS_SHAPED(light)) {
        whole = slide_level_of(blur / light.slide.texel);
        slide_level = fan.levels > 1u ? floor(whole + 0.5) : whole;
    }
    columns = wanted ? columns : 0u;
    uint begin = 0u, end = columns;
    if (HAS_SLIDE(light)) {
        // Nothing shines beside the panel: nearly half of a table.
        vec3 to_gate = vec3(1.0, 1.0, light.tan_field);
        vec2 part = panel_part(light, centre * to_gate, turn * to_gate, blur_of(light, focus, 0.0));
        vec2 column = clamp((part - u) / max(step_u, 1e-9), 0.0, float(columns));
        begin = uint(column.x);
        end = clamp(uint(ceil(column.y)) + 1u, begin, columns);
        for (uint before = 0u; before < begin; ++before) {
            imageStore(table, at, sum);
            at.x += 1;
        }
        u += float(begin) * step_u;
        place += float(begin) * fraction;
    }
    for (uint column = begin; column < end; ++column) {
        imageStore(table, at, sum);
        vec3 direction = centre + turn * u;
        vec2 gate = direction.xy / (max(direction.z, 1e-4) * light.tan_field);
        vec3 value = beam_gate(light, gate, focus) * (fraction / (fan.most * (1.0 + u * u)));
        sum += vec4(value, luminance_of(value) * place);
        u += step_u;
        place += fraction;
        at.x += 1;
    }
    if (!HAS_SLIDE(light)) return;
    for (uint after = end; after < columns; ++after) {
        imageStore(table, at, sum);
        at.x += 1;
    }
}

void main() {
    if (kSingle)
        fill(lights[p.first], fans[p.first]);
    else
        fill(lights[p.first + gl_WorkGroupID.y], fans[p.first + gl_WorkGroupID.y]);
}
