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
SHARED_CONST uint kMaskWords = 8u;

// Kept images hold cd/m^2 times this as half floats: 0.004 .. 4,000,000 cd/m^2 at full precision.
SHARED_CONST float kImageScale = 1.0f / 64.0f;
// See kRadianceScale in scene/passes.h.
SHARED_CONST float kPassScale = 1024.0f;

SHARED_CONST uint kDrawSurfaces = 1u;
SHARED_CONST uint kDrawHaze = 2u;
SHARED_CONST uint kMarch = 4u;      // samples over the whole ray instead of its part in the cone
SHARED_CONST uint kOutputFrame = 8u; // the frame, else a kept image
SHARED_CONST uint kAccumulate = 16u; // on top of what the output holds
SHARED_CONST uint kAddBase = 32u;    // the picture without lights is added

// Which lights can reach which tile.
struct CullPush {
    uint light_count;
    uint tiles_x;
    uint tiles_y;
};
SHARED_SIZE(CullPush, 12);

// Sum of some lights and of some kept images into one image.
SHARED_CONST uint kMaxAddends = 20u; // of one dispatch; the tree needs one per level
struct RelightPush {
    uint light_count;
    uint addend_count;
    uint tiles_x;
    uint flags;
    uint march_steps;
    uint target;               // layer of the kept images
    uint addend[kMaxAddends];  // layers of the kept images
};
SHARED_SIZE(RelightPush, 104);

struct MeterPush {
    uint width;
    uint height;
    float ev100; // used unless automatic
    uint automatic;
};
SHARED_SIZE(MeterPush, 16);

SHARED_END
#endif
