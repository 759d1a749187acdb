#version 460
// SPDX-License-Identifier: Apache-2.0
// A copy of the bounds of tiles and blocks for cull.comp in which everything is empty but some tiles and the blocks that hold the
// extra fragments of some of them: what is culled with it is drawn there and nowhere else. Tiles first, then, in a
// dispatch of its own, blocks.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/g_buffer.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) readonly buffer TileBounds { vec4 tile_bounds[]; };
layout(binding = 1, scalar) writeonly buffer ChangedBounds { vec4 changed_bounds[]; };
layout(binding = 2, scalar) readonly buffer Rooms { TileRoom rooms[]; };
layout(binding = 3, scalar) readonly buffer Wanted { uint wanted[]; }; // a bit a tile; of the tiles to draw or of those whose blocks are wanted
layout(push_constant, scalar) uniform Push { ChangedBoundsPush p; };

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at >= p.tiles + p.blocks) return;
    uint bit = 1u << (at & 31u);
    if (p.add_blocks == 0u) {
        bool drawn = false;
        if (at < p.tiles) drawn = (wanted[at / 32u] & bit) != 0u;
        changed_bounds[at * 2u] = drawn ? tile_bounds[at * 2u] : vec4(0.0, 0.0, 0.0, -1.0);
        changed_bounds[at * 2u + 1u] = drawn ? tile_bounds[at * 2u + 1u] : vec4(-1.0, 0.0, 0.0, 0.0);
        return;
    }
    if (at >= p.tiles || (wanted[at / 32u] & bit) == 0u) return;
    TileRoom room = rooms[at];
    if (room.extras == 0u) return;
    for (uint block = room.first_extra / kTilePixels; block * kTilePixels < room.first_extra + room.extras; ++block) {
        uint to = (p.tiles + block) * 2u;
        changed_bounds[to] = tile_bounds[to];
        changed_bounds[to + 1u] = tile_bounds[to + 1u];
    }
}
