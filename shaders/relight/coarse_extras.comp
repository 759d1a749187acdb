#version 460
// SPDX-License-Identifier: Apache-2.0
// The same as coarse_cells.comp for the extra fragments of pixels on silhouettes: weights for its surface and its haze, what it reflects
// and its fraction of the pixel. An invocation is one pixel on an edge.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"
#include "common/coarse.glsl"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; }; // of the picture
layout(binding = 1, rgba32f) readonly uniform image2DArray places;
layout(binding = 2, rgba16f) readonly uniform image2DArray diffuse;
layout(binding = 3, rgba16f) readonly uniform image2DArray specular;
layout(binding = 4, rgba16f) readonly uniform image2DArray normals;
layout(binding = 5, rgba32f) readonly uniform image2DArray point_places;
layout(binding = 6, rgba16f) readonly uniform image2DArray point_normals;
layout(binding = 7) uniform usampler2DArray edges;
layout(binding = 8, rgba32ui) writeonly uniform uimage2DArray extras;
layout(binding = 9, scalar) readonly buffer TileList { uint tile_list[]; }; // of the picture
layout(binding = 10, scalar) readonly buffer Rooms { TileRoom rooms[]; };
layout(push_constant, scalar) uniform Push { CoarsePush p; };

void weigh(uint i) {
    uvec2 edge = texelFetch(edges, ivec3(i % view.width, i / view.width, 0), 0).xy;
    uint count = edge.y & 3u;
    if (count == 0u) return; // room for an edge
    ivec2 at = ivec2(edge.x % view.width, edge.x / view.width);
    ivec2 cell = (at + 1) / 2, last = (ivec2(view.width, view.height) + 1) / 2 - 1;
    vec4 near = bilinear(uvec2(at + 1) & 1u);
    float pixel = 2.0 * length(view.right) / float(view.width);
    Spot points[4];
    for (int k = 0; k < 4; ++k) {
        ivec3 from = ivec3(clamp(cell - 1 + ivec2(k & 1, k >> 1), ivec2(0), last), 0);
        points[k] = spot_of(imageLoad(point_places, from), imageLoad(point_normals, from), view.eye_m, view.far_m);
    }
    for (uint k = edge.y >> 2; k < (edge.y >> 2) + count; ++k) {
        ivec3 from = ivec3(k % view.width, view.height + k / view.width, 0);
        vec4 place = imageLoad(places, from);
        Spot fragment = spot_of(place, imageLoad(normals, from), view.eye_m, view.far_m);
        vec4 surface = near, haze = near;
        for (int n = 0; n < 4; ++n) {
            surface[n] *= likeness(fragment, points[n], pixel);
            haze[n] *= haze_likeness(fragment.away_m, points[n].away_m);
        }
        float fraction = max(place.w, 0.0);
        uint reflects = pack_shared_exponent(fraction * reflected(imageLoad(diffuse, from), imageLoad(specular, from)));
        imageStore(extras, ivec3(k % view.width, k / view.width, 0),
                   uvec4(pack_weights(surface), pack_weights(haze), fraction > 0.0 ? reflects : 0u, floatBitsToUint(fraction)));
    }
}

void main() {
    uint first = gl_GlobalInvocationID.x;
    uint end = min(first + 1u, p.count);
    if (p.listed != 0u) {
        TileRoom room = rooms[tile_list[gl_WorkGroupID.x]];
        first = room.first_edge + gl_LocalInvocationIndex;
        end = room.first_edge + room.edges;
    }
    for (uint i = first; i < end; i += 64u) weigh(i);
}
