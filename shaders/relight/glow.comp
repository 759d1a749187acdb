#version 460
// SPDX-License-Identifier: Apache-2.0
// How bounced light glows in the haze before every kGlowStep-th ray of the picture, summed up to slices at even distances, whatever
// surfaces stand there: a pixel between takes what it needs by its own distance (room_light.comp).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/haze.h"
#include "shared/room_light.h"
#include "common/room_volume.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1) uniform sampler2DArray glow;
layout(binding = 2, rgba16f) writeonly uniform image2DArray slices;
layout(push_constant, scalar) uniform Push { RoomLightPush p; };

void main() {
    uvec2 ray = gl_GlobalInvocationID.xy;
    if (ray.x >= p.glow_width || ray.y >= p.glow_height) return;
    vec2 at = vec2(ray * kGlowStep) / vec2(view.width, view.height) * 2.0 - 1.0;
    vec3 way = normalize(view.forward + view.right * at.x - view.up * at.y);
    vec3 sum = vec3(0.0);
    imageStore(slices, ivec3(ray, 0), vec4(0.0));
    for (uint k = 1u; k < p.slices; ++k) {
        float distance_m = p.near_m + (float(k) - 0.5) * p.slice_m;
        vec3 voxels = (view.eye_m + way * distance_m - p.low_m) / p.cell_m;
        if (all(greaterThan(voxels, vec3(0.0))) && all(lessThan(voxels, p.cells))) {
            vec4 found = volume_at(glow, voxels, p.cells, 0.0);
            if (found.w > 0.05) sum += found.rgb * (haze_transmittance(view.haze, distance_m) * p.slice_m / found.w);
        }
        imageStore(slices, ivec3(ray, k), vec4(sum, 0.0));
    }
}
