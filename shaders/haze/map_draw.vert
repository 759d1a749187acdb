#version 460
// SPDX-License-Identifier: Apache-2.0
// A mesh in one octant of a distance map.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_ARB_shader_viewport_layer_array : require
#include "shared/map_draw.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 axis_x; // the rest is of a MapDraw
layout(location = 3) in vec3 axis_y;
layout(location = 4) in vec3 axis_z;
layout(location = 5) in vec3 place_m;
layout(location = 6) in vec3 signs;
layout(location = 7) in uint layer;
layout(location = 0) out vec2 out_uv;
layout(push_constant, scalar) uniform Push { MapDrawPush p; };

void main() {
    vec3 from_map_m = axis_x * position.x + axis_y * position.y + axis_z * position.z + place_m;
    gl_Position = map_clip(from_map_m, signs);
    vec3 inside = map_inside(from_map_m, signs, gl_Position.w, p.side);
    gl_ClipDistance[0] = inside.x;
    gl_ClipDistance[1] = inside.y;
    gl_ClipDistance[2] = inside.z;
    gl_Layer = int(layer);
    out_uv = uv;
}
