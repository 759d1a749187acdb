#version 460
// SPDX-License-Identifier: Apache-2.0
// Notes that the fragments of some tiles are others now, and those in the blocks of their extra fragments (shared/visibility.h).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/g_buffer.h"
#include "shared/visibility.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) readonly buffer TileList { uint tile_list[]; };
layout(binding = 1, scalar) readonly buffer Rooms { TileRoom rooms[]; };
layout(binding = 2, scalar) writeonly buffer Changed { uint changed_at[]; }; // of tiles, then blocks
layout(push_constant, scalar) uniform Push { VisibilityTouchPush p; };

void main() {
    if (gl_GlobalInvocationID.x >= p.count) return;
    uint tile = tile_list[gl_GlobalInvocationID.x];
    changed_at[tile] = p.now;
    TileRoom room = rooms[tile];
    for (uint block = room.first_extra / kTilePixels; room.extras > 0u && block * kTilePixels < room.first_extra + room.extras; ++block)
        changed_at[p.tiles + block] = p.now;
}
