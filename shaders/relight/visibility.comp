#version 460
// SPDX-License-Identifier: Apache-2.0
// Makes what units see of a lamp where it is not kept (shared/visibility.h), for all their fragments.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define DISTANCE_MAPS 4
#include "common/octahedral_map.glsl"
#define BLOCKERS 5
#include "common/soft_shadow.glsl"
#include "shared/g_buffer.h"

layout(local_size_x = 128) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 3, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 6, rgba32f) readonly uniform image2DArray places;
layout(binding = 7, rgba16f) readonly uniform image2DArray normals; // and the facets', packed
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

#include "common/lit_fraction.glsl"
#define KEEPS 8
#include "common/visibility.glsl"

void make(Light light, Keep keep, vec3 place_m, vec3 facet, uint unit, bool there) {
    Page page = page_of(keep, unit);
    vec3 from_map = place_m - light.position_m + light.off_map_m;
    bool wanted = there && light.map != 0u && page.there && page.make && dot(facet, from_map) < 0.0;
    float mark = mark_of(place_m, facet);
    bool same = page.has_old && page.there && abs(imageLoad(pages, page.texel).y - mark) < 0.5 / 65535.0;
    float fraction = lit_fraction(light, facet, from_map, wanted && !same);
    if (page.there && page.make && !same) imageStore(pages, page.texel, vec4(wanted ? as_kept(fraction) : 0.0, mark, 0.0, 0.0));
}

void make_unit(uint unit) {
    uvec2 size = uvec2(view.width, view.height);
    uvec2 local = uvec2(gl_LocalInvocationIndex % kTileWidth, gl_LocalInvocationIndex / kTileWidth);
    uvec2 pixel = uvec2(unit % p.tiles_x, unit / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + local;
    uint extra = (unit - p.tiles) * kTilePixels + gl_LocalInvocationIndex;
    bool is_extra = unit >= p.tiles;
    bool inside = is_extra || (pixel.x < size.x && pixel.y < size.y);
    pixel = is_extra ? uvec2(extra % size.x, size.y + extra / size.x) : min(pixel, size - 1u);
    vec4 place = imageLoad(places, ivec3(pixel, 0));
    vec3 facet = unpack_normal(imageLoad(normals, ivec3(pixel, 0)).zw);
    bool there = inside && place.w > 0.0;
    if (kSingle) {
        make(lights[p.batch], keeps[p.batch], place.xyz, facet, unit, there);
        return;
    }
    // Workgroups share out the lights of a unit: each has so many that follow one another.
    uint each = kLightsPerChunk / gl_NumWorkGroups.y, first = gl_WorkGroupID.y * each;
    for (uint word = first / 32u; word * 32u < min(first + each, p.light_count); ++word) {
        uint own = each < 32u ? ((1u << each) - 1u) << (first % 32u) : ~0u;
        for (uint mask = mask_of[unit * kMaskWords + word] & own; mask != 0u; mask &= mask - 1u) {
            uint index = word * 32u + uint(findLSB(mask));
            make(lights[index], keeps[index], place.xyz, facet, unit, there);
        }
    }
}

void main() {
    // Of a single light each has its tile: in a loop lavapipe would load all that is the same for its lanes for each of them.
    if (kSingle) {
        make_unit(list[made_list(p.batch, p.tiles, p.blocks) + gl_WorkGroupID.x]);
        return;
    }
    uint count = list[list_count(p.batch, kMadeList)];
    for (uint number = gl_WorkGroupID.x; number < count; number += gl_NumWorkGroups.x) make_unit(list[made_list(p.batch, p.tiles, p.blocks) + number]);
}
