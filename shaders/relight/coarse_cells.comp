#version 460
// SPDX-License-Identifier: Apache-2.0
// Weights of the coarse points for the main fragments of the pixels between them (shared/coarse.h). An invocation is a cell: the four
// pixels between the points (x - 1, y - 1) .. (x, y).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"
#include "common/coarse.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; }; // of the picture
layout(binding = 1, rgba32f) readonly uniform image2DArray places;
layout(binding = 2, rgba16f) readonly uniform image2DArray diffuse;
layout(binding = 3, rgba16f) readonly uniform image2DArray specular;
layout(binding = 4, rgba16f) readonly uniform image2DArray normals;
layout(binding = 5, rgba32f) readonly uniform image2DArray point_places;
layout(binding = 6, rgba16f) readonly uniform image2DArray point_normals;
layout(binding = 7, rgba32ui) writeonly uniform uimage2DArray cells;
layout(binding = 8, scalar) readonly buffer TileList { uint tile_list[]; };
layout(push_constant, scalar) uniform Push { CoarsePush p; };

void main() {
    uint tile = gl_WorkGroupID.y * p.tiles_x + gl_WorkGroupID.x;
    if (p.listed != 0u) tile = tile_list[gl_WorkGroupID.x];
    uvec2 corner = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight);
    ivec2 cell = ivec2(corner + gl_LocalInvocationID.xy);
    ivec2 size = ivec2(view.width, view.height), last = (size + 1) / 2 - 1;
    if (any(greaterThan(cell, last + 1))) return;
    float pixel = 2.0 * length(view.right) / float(size.x);
    Spot points[4];
    for (int k = 0; k < 4; ++k) {
        ivec3 at = ivec3(clamp(cell - 1 + ivec2(k & 1, k >> 1), ivec2(0), last), 0);
        points[k] = spot_of(imageLoad(point_places, at), imageLoad(point_normals, at), view.eye_m, view.far_m);
    }
    uvec4 surfaces, hazes, reflects;
    for (int k = 0; k < 4; ++k) {
        uvec2 local = uvec2(k & 1, k >> 1);
        ivec3 at = ivec3(clamp(2 * cell - 1 + ivec2(local), ivec2(0), size - 1), 0);
        vec4 place = imageLoad(places, at);
        Spot fragment = spot_of(place, imageLoad(normals, at), view.eye_m, view.far_m);
        vec4 surface = bilinear(local), haze = surface;
        for (int n = 0; n < 4; ++n) {
            surface[n] *= likeness(fragment, points[n], pixel);
            haze[n] *= haze_likeness(fragment.away_m, points[n].away_m);
        }
        surfaces[k] = pack_weights(surface);
        hazes[k] = pack_weights(haze);
        reflects[k] = place.w > 0.0 ? pack_shared_exponent(place.w * reflected(imageLoad(diffuse, at), imageLoad(specular, at))) : 0u;
    }
    imageStore(cells, ivec3(cell, kCellSurfaces), surfaces);
    imageStore(cells, ivec3(cell, kCellHaze), hazes);
    imageStore(cells, ivec3(cell, kCellReflects), reflects);
}
