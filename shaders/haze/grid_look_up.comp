#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds a light's haze from its grid (grid.glsl) to the tiles that it reaches, and lists the pixels for which the grid does not know it.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"
#include "shared/fan.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 3, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 4) uniform sampler2DArray grid;
layout(binding = 5, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, scalar) buffer Left { LeftHead head; uint left[]; };
layout(push_constant, scalar) uniform Push { GridPush p; };

#include "common/grid.glsl"


void draw(uint tile) {
    uint batch = p.gate.batch;
    uvec2 size = uvec2(view.width, view.height);
    uvec2 pixel = uvec2(tile % p.gate.tiles_x, tile / p.gate.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    bool inside = pixel.x < size.x && pixel.y < size.y;
    ivec2 at = ivec2(min(pixel, size - 1u));
    vec2 ndc = vec2(2.0 * (float(at.x) + 0.5) / float(size.x) - 1.0, 1.0 - 2.0 * (float(at.y) + 0.5) / float(size.y));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec4 surface = imageLoad(places, ivec3(at, 0));
    float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;
    GridRay ray = grid_ray(lights[batch], fans[batch], dir, far);
    bool hit = ray.hit && inside;
    float column = grid_column(ray.h);
    vec2 place = (0.5 + vec2(column, 0.5 * ray.row + 0.5) * (vec2(p.grid.columns, p.grid.rows) - 1.0)) / vec2(kMostGridColumns, kMostGridRows);
    vec4 value = textureLod(grid, vec3(place, float(p.layer)), 0.0);
    float end_there = textureLod(grid, vec3(place, float(p.layer + 1u)), 0.0).x, end = min(ray.end, 1.0);
    bool ends = abs(end_there - end) <= kEndDoubt * end;
    value.rgb *= end < 1.0 ? clamp(end / max(end_there, 1e-3), 1.0 - kEndDoubt, 1.0 + kEndDoubt) : 1.0;
    bool known = column >= 0.0 && column <= 1.0 && ends && value.a <= p.grid.most_doubt;
    if (hit && known) {
        vec3 sum = value.rgb / kGridScale * lights[batch].intensity_cd *
                   (view.haze.scattering_per_m * 2.0 * ray.half_chord * fans[batch].most / (fans[batch].beam.eye_m * ray.sine));
        ivec3 to = ivec3(at, 1);
        imageStore(drawn, to, light_to_store(imageLoad(drawn, to) + vec4(sum, 0.0)));
    }
    if (hit && !known) {
        uint slot = atomicAdd(head.count, 1u);
        if (slot % kTilePixels == 0u) atomicAdd(head.groups[0], 1u);
        left[slot] = uint(at.y) << 16u | uint(at.x);
    }
}

void main() { draw(list[haze_list(p.gate.batch, p.gate.tiles, p.gate.blocks) + gl_WorkGroupID.x]); }
