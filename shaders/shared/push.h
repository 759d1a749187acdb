// SPDX-License-Identifier: Apache-2.0
// Push constants and limits that the compute shaders and their callers share.
#ifndef GHOST_SHARED_PUSH_H
#define GHOST_SHARED_PUSH_H
#include "shared/types.h"

SHARED_BEGIN

// A tile is one workgroup of the relight shader.
SHARED_CONST uint kTileWidth = 16u;
SHARED_CONST uint kTileHeight = 8u;
SHARED_CONST uint kTilePixels = kTileWidth * kTileHeight;

// Lights of one uniform buffer (64 KiB).
SHARED_CONST uint kLightsPerChunk = 128u;
// The lights of a chunk are drawn in batches: on a GPU all at once, each pixel looping over a mask of the lights that reach
// its tile; on lavapipe one by one, because there a value that is the same for all lanes is only cheap where the compiler
// can see that it is (measured: 20 of 50 ms went into loading the light again for every lane).
SHARED_CONST uint kMaskWords = 4u; // a tile: a bit a light

// All pictures of light are half floats: 0.05 % steps, and a lens at close range is clipped here, in cd/m^2.
SHARED_CONST float kMostLight = 65000.0f;

#ifndef __cplusplus
// Rounded to the nearest half float: a store may as well cut off, and hundreds of sums would drift (measured: 3 % of 700 lights).
vec4 light_to_store(vec4 light) {
    return min(uintBitsToFloat((floatBitsToUint(light) + 0x1000u) & 0xffffe000u), vec4(kMostLight));
}
#endif

// See kRadianceScale in passes/passes.h.
SHARED_CONST float kPassScale = 1024.0f;

// Which lights of each batch can reach which tile; the tiles that any of them reaches are appended to the batch's lists for
// the passes below. A batch has four lists, one after the other: haze, surfaces, what of these sees a lamp for which that must be made
// (shared/visibility.h), and surfaces of single lights for which it is worked out just where light falls. How long they are
// stands before all lists, for a device may not begin as many workgroups as a list of a large picture has tiles: then each draws several.
SHARED_CONST uint kHazeList = 0u, kSurfaceList = 1u, kMadeList = 2u, kDirectList = 3u;
SHARED_CONST uint kListCounts = 4u * kLightsPerChunk;
SHARED_FN uint list_count(uint batch, uint kind) { return 4u * batch + kind; }
SHARED_FN uint lists_length(uint tiles, uint blocks) { return 4u * tiles + 3u * blocks; }
SHARED_FN uint haze_list(uint batch, uint tiles, uint blocks) { return kListCounts + batch * lists_length(tiles, blocks); }
SHARED_FN uint surface_list(uint batch, uint tiles, uint blocks) { return haze_list(batch, tiles, blocks) + tiles; }
SHARED_FN uint made_list(uint batch, uint tiles, uint blocks) { return surface_list(batch, tiles, blocks) + tiles + blocks; }
SHARED_FN uint direct_list(uint batch, uint tiles, uint blocks) { return made_list(batch, tiles, blocks) + tiles + blocks; }
struct CullPush {
    uint light_count;
    uint batch_size; // 1 or kLightsPerChunk
    uint tiles_x;
    uint tiles;    // of the picture
    uint blocks;   // of kTilePixels extra fragments, listed after the tiles
    uint surfaces; // 1: list tiles and blocks for the surface pass
    uint air;      // 1: list tiles for the haze pass
    uint haze_group; // tiles that a workgroup of the haze pass draws
    uint now;        // shared/visibility.h; 0: nothing is kept
    uint pages;      // of kept visibility
    uint units;      // tiles and room for blocks
    uint most_made;  // of them in a frame
    uint most_groups; // of an indirect dispatch
    uint marks;       // 0: none; else, of single lights, the first one's number + 1: surfaces are not listed, unless direct, but marked
};
SHARED_SIZE(CullPush, 56);

// Workgroups of the indirect dispatches of a batch, as Vulkan wants them.
struct TileGroups {
    uint surface[4]; // the last one is not used
    uint haze[4];
    uint made[4];
    uint direct[4];
};
SHARED_SIZE(TileGroups, 64);

// What the lists of a frame add up to: tiles (and blocks) that are drawn, once for each light that reaches them.
struct FrameWork {
    uint haze_tiles;
    uint surface_tiles;
    uint made_units; // of surface_tiles: what they see of a lamp was made, to be kept
    uint direct_units; // likewise: it was worked out just where light falls
    uint units_to_make; // of single lights, those beyond CullPush::most_made too
    uint units_without_page; // there was no room to keep it
};
SHARED_SIZE(FrameWork, 24);

// target = kept images (+ the picture without lights).
SHARED_CONST uint kMostAddends = 2048u; // as many as there can be layers
struct Addend {
    uint layer;
    vec3 weight; // of an image of one light
};
SHARED_SIZE(Addend, 16);
SHARED_CONST uint kSumToFrame = 1u; // else to a kept image
SHARED_CONST uint kSumBase = 2u;    // with the picture without lights
SHARED_CONST uint kSumDrawn = 4u;   // and the lights drawn just now
SHARED_CONST uint kManyAddends = 17u;
struct SumPush {
    uint target; // layer of the kept images
    uint addend_count;
    uint tiles_x;
    uint listed; // 1: only the tiles of a list
};
SHARED_SIZE(SumPush, 16);

// drawn = 0 on the tiles of a list and in the blocks of their extra fragments.
struct ClearPush {
    uint count; // of the list
    uint listed; // 0: all tiles of the picture, then blocks
    uint tiles;
    uint tiles_x;
    uint width;
    uint height;
};
SHARED_SIZE(ClearPush, 24);

// drawn += lights, on the tiles of the list. Layer 0: surfaces, layer 1: haze.
struct RelightPush {
    uint light_count; // of the chunk
    uint batch;
    uint tiles_x;
    uint tiles;
    uint blocks;
    uint march_steps; // 0: samples inside the cone; else over the whole ray
    uint units;       // of kept visibility
    uint direct;      // 1: the list of surfaces for which it is not kept
};
SHARED_SIZE(RelightPush, 32);

// Fills the tables of lights first, first + 1, .. of a chunk.
struct FanPush {
    uint first;
};
SHARED_SIZE(FanPush, 4);

// drawn += haze from fans, on the tiles of the list.
struct GatePush {
    uint light_count; // of the chunk
    uint batch;
    uint tiles_x;
    uint tiles;
    uint blocks;
    float segments_per_rad; // from the error wanted
    uint most_segments;
    float shade_rad; // what the edge of a shadow may be off
    uint step;       // of the wide beams' rays, see shared/wide.h
};
SHARED_SIZE(GatePush, 36);

// A light's haze on a grid of camera rays (render/haze/private/haze_grid.h). Rows: even in the fan's row coordinate -1..1. Columns: of h = tan(phi / 2),
// phi the angle of the ray from the way to the lamp.
struct HazeGrid {
    uint columns;
    uint rows;
    float near_h;   // of the first column
    float per_h;    // 1 / what h grows to the last one
    float bend;     // the first columns are 1 + bend times as close as even ones
    float most_doubt; // fraction of a value that columns may deviate by from a straight line
};
SHARED_SIZE(HazeGrid, 24);

struct GridPush {
    GatePush gate;
    HazeGrid grid;
    uint layer; // the first of the light's
};
SHARED_SIZE(GridPush, 64);

// Pixels that a light's grid does not know: groups as Vulkan wants them, their number, then y << 16 | x of each.
struct LeftHead {
    uint groups[3];
    uint count;
};
SHARED_SIZE(LeftHead, 16);

// Columns and rows of a grid, at most; its layers: what rays see, where they end.
SHARED_CONST uint kMostGridColumns = 192u;
SHARED_CONST uint kMostGridRows = 512u;
SHARED_CONST uint kGridLayers = 2u; // of a light

struct BouncePush {
    uint light_count; // of the chunk
};
SHARED_SIZE(BouncePush, 4);

struct FoldPush {
    uint edge_count; // pixels with extra fragments
    uint listed;     // 1: only those of the tiles of a list
};
SHARED_SIZE(FoldPush, 8);

// Of the nine pixels round one on an edge, by rows: itself.
SHARED_CONST uint kOwnHaze = 4u;

struct MeterPush {
    uint width;
    uint height;
    float ev100; // used unless automatic
    uint automatic;
};
SHARED_SIZE(MeterPush, 16);

SHARED_END
#endif
