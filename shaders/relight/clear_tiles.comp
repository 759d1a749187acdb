#version 460
// SPDX-License-Identifier: Apache-2.0
// Sets the light drawn into some tiles and into the blocks that hold their extra fragments to zero, or into all of them: where little is
// drawn again, little is cleared.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/g_buffer.h"
#include "shared/push.h"

layout(local_size_x = 128) in;
layout(binding = 0, scalar) readonly buffer TileList { uint tile_list[]; };
layout(binding = 1, scalar) readonly buffer Rooms { TileRoom rooms[]; };
layout(binding = 2, rgba16f) writeonly uniform image2DArray drawn; // layer 0 surfaces, layer 1 haze
layout(push_constant, scalar) uniform Push { ClearPush p; };

void clear_tile(uint tile) {
    uvec2 local = uvec2(gl_LocalInvocationIndex % kTileWidth, gl_LocalInvocationIndex / kTileWidth);
    uvec2 at = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + local;
    if (at.x >= p.width || at.y >= p.height) return;
    imageStore(drawn, ivec3(at, 0), vec4(0.0));
    imageStore(drawn, ivec3(at, 1), vec4(0.0));
}

// Extra fragments have no haze.
void clear_block(uint block) {
    uint extra = block * kTilePixels + gl_LocalInvocationIndex;
    imageStore(drawn, ivec3(extra % p.width, p.height + extra / p.width, 0), vec4(0.0));
}

void main() {
    uint number = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (number >= p.count) return;
    if (p.listed == 0u) { // tiles, then blocks
        if (number < p.tiles) clear_tile(number);
        else clear_block(number - p.tiles);
        return;
    }
    uint tile = tile_list[number];
    clear_tile(tile);
    TileRoom room = rooms[tile];
    if (room.extras == 0u) return;
    for (uint block = room.first_extra / kTilePixels; block * kTilePixels < room.first_extra + room.extras; ++block) clear_block(block);
}
