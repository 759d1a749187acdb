// SPDX-License-Identifier: Apache-2.0
// Push constants and limits that the compute shaders and their callers share.
#ifndef GHOST_SHARED_PUSH_H
#define GHOST_SHARED_PUSH_H
#include "shared/types.h"

SHARED_BEGIN

// A tile is one workgroup of the relight shader.
SHARED_CONST uint kTileWidth = 16u;
SHARED_CONST uint kTileHeight = 8u;

// Lights of one dispatch: as many as a uniform buffer of 64 KiB holds, in whole mask words.
SHARED_CONST uint kLightsPerDispatch = 256u;
SHARED_CONST uint kMaskWords = 8u; // a tile: a bit a light

// See kRadianceScale in scene/passes.h.
SHARED_CONST float kPassScale = 1024.0f;

// Which lights can reach which tile; the tiles that any of them reaches are appended to the lists of the two passes below.
struct CullPush {
    uint light_count;
    uint tiles_x;
    uint tiles_y;
    uint surfaces; // 1: list tiles for the surface pass
    uint air;      // 1: list tiles for the haze pass
};
SHARED_SIZE(CullPush, 20);

// Workgroups of the two indirect dispatches, as Vulkan wants them, with room between for its alignment.
struct TileGroups {
    uint surface[4];
    uint haze[4];
};
SHARED_SIZE(TileGroups, 32);

// target = kept images (+ the picture without lights). Layer 0 is the frame.
SHARED_CONST uint kMaxAddends = 20u; // of one dispatch; the tree needs one per level
struct SumPush {
    uint target;
    uint accumulate; // 1: on top of what the target holds
    uint add_base;
    uint addend_count;
    uint addend[kMaxAddends];
};
SHARED_SIZE(SumPush, 96);

// target += lights, on the tiles of the list.
struct RelightPush {
    uint target;
    uint light_count;
    uint tiles_x;
    uint march_steps; // 0: samples inside the cone; else over the whole ray
};
SHARED_SIZE(RelightPush, 16);

struct MeterPush {
    uint width;
    uint height;
    float ev100; // used unless automatic
    uint automatic;
};
SHARED_SIZE(MeterPush, 16);

SHARED_END
#endif
