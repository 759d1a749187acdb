#version 460
// SPDX-License-Identifier: Apache-2.0
// Makes the coarse points of a picture (shared/coarse.h) and the bounds of their tiles. Where the four pixels show one surface the point is
// where the ray through their middle meets it; where they do not, every other point takes the nearest of their surfaces, the rest the
// farthest, so that both sides of a silhouette have points beside it.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"
#include "common/bounds.glsl"
#include "common/coarse.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; }; // of the points
layout(binding = 1, rgba32f) readonly uniform image2DArray places;
layout(binding = 2, rgba16f) readonly uniform image2DArray diffuse;
layout(binding = 3, rgba16f) readonly uniform image2DArray specular;
layout(binding = 4, rgba16f) readonly uniform image2DArray normals;
layout(binding = 5, rgba32f) writeonly uniform image2DArray point_places;
layout(binding = 6, rgba16f) writeonly uniform image2DArray point_diffuse;
layout(binding = 7, rgba16f) writeonly uniform image2DArray point_specular;
layout(binding = 8, rgba16f) writeonly uniform image2DArray point_normals;
layout(binding = 9, rgba32ui) writeonly uniform uimage2DArray sums;
layout(binding = 10, scalar) writeonly buffer TileBounds { vec4 tile_bounds[]; };
layout(binding = 11, scalar) readonly buffer TileList { uint tile_list[]; };
layout(push_constant, scalar) uniform Push { CoarsePush p; };

const float kMostMove = 2.0; // pixels, across, that a point is moved along its surface

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tile = gl_WorkGroupID.y * p.tiles_x + gl_WorkGroupID.x;
    if (p.listed != 0u) tile = tile_list[gl_WorkGroupID.x];
    uvec2 corner = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight);
    uvec2 point = corner + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(point, size));
    ivec2 at = ivec2(min(point, size - 1u));
    bool wants_near = ((at.x + at.y) & 1) == 0;
    ivec2 whole = ivec2(p.width, p.height); // the last points of an odd one have pixels on one side only
    int chosen = 0;
    float best = wants_near ? 1e30 : -1.0;
    vec4 place = vec4(0.0, 0.0, 0.0, -1.0);
    for (int k = 0; k < 4; ++k) {
        vec4 one = imageLoad(places, ivec3(min(2 * at + ivec2(k & 1, k >> 1), whole - 1), 0));
        float away = one.w >= 0.0 ? length(one.xyz - view.eye_m) : view.far_m;
        bool better = wants_near ? away < best : away > best;
        best = better ? away : best;
        chosen = better ? k : chosen;
        place = better ? one : place;
    }
    ivec3 from = ivec3(min(2 * at + ivec2(chosen & 1, chosen >> 1), whole - 1), 0);
    vec4 both = imageLoad(normals, from);
    vec4 layer = imageLoad(diffuse, from), mirror = imageLoad(specular, from);
    bool there = place.w >= 0.0;
    vec2 ndc = vec2(1.0, -1.0) * (vec2(2 * (2 * at + 1)) / vec2(whole) - 1.0);
    vec3 dir = view.forward + view.right * ndc.x + view.up * ndc.y;
    vec3 way = place.xyz - view.eye_m, facet = unpack_normal(both.zw);
    float fall = dot(facet, dir);
    vec3 moved = dir * (dot(facet, way) / (abs(fall) < 1e-6 ? 1e-6 : fall));
    float pixel = 2.0 * length(view.right) / float(whole.x); // of the picture, at 1 m
    float slant = max(abs(fall) / length(dir), 0.05);
    bool near = dot(moved, dir) > 0.0 && length(moved - way) < kMostMove * pixel * length(way) / slant;
    way = near ? moved : way;
    vec3 white = 1.0 / reflected(layer, mirror);
    if (inside) {
        imageStore(point_places, ivec3(at, 0), there ? vec4(view.eye_m + way, 1.0) : vec4(0.0, 0.0, 0.0, -1.0));
        imageStore(point_diffuse, ivec3(at, 0), layer);
        imageStore(point_specular, ivec3(at, 0), mirror);
        imageStore(point_normals, ivec3(at, 0), both);
        imageStore(sums, ivec3(at, kCoarseWhite), uvec4(floatBitsToUint(white), 0u));
    }
    bool lit = inside && there;
    vec3 point_m = view.eye_m + way;
    Box box = Box(lit ? point_m : vec3(kNowhere), lit ? point_m : vec3(-kNowhere), inside ? (there ? length(way) : view.far_m) : 0.0);
    box = box_of_group(box);
    vec3 centre = box.low.x <= box.high.x ? (box.low + box.high) * 0.5 : vec3(0.0);
    float radius = most_of_group(lit ? length(point_m - centre) : -1.0);
    if (gl_LocalInvocationIndex == 0u) {
        tile_bounds[tile * 2u] = vec4(centre, radius);
        tile_bounds[tile * 2u + 1u] = vec4(box.far_m, 0.0, 0.0, 0.0);
    }
}
