// SPDX-License-Identifier: Apache-2.0
// Bounced light in a picture: what C++ and the shaders share (render/relight/room_light.h).
#ifndef GHOST_SHARED_ROOM_LIGHT_H
#define GHOST_SHARED_ROOM_LIGHT_H
#include "shared/types.h"

SHARED_BEGIN

SHARED_CONST uint kGlowStep = 4u; // pixels between rays of the glow
SHARED_CONST uint kMostGlowSlices = 48u;

// The glow of the air before each ray, summed up to slices at even distances.
struct RoomLightPush {
    vec3 low_m;
    float surfel_m;
    vec3 surfels; // voxels
    float cell_m;
    vec3 cells;
    float near_m; // distance of slice 0
    float slice_m;
    uint slices;
    uint glow_width; // rays
    uint glow_height;
    uint edges;  // above 0: extra fragments of so many pixels, instead of the main ones
    uint as_lux; // 1: what falls on surfaces, and no glow
};
SHARED_SIZE(RoomLightPush, 72);

SHARED_END
#endif
