// SPDX-License-Identifier: Apache-2.0
// Push constants of the compute shaders. Buffers are passed by address; in C++ an address is a std::uint64_t.
#ifndef GHOST_SHARED_PUSH_H
#define GHOST_SHARED_PUSH_H
#include "shared/types.h"

#ifdef __cplusplus
#define BUFFER_OF(type) std::uint64_t
#else
#define BUFFER_OF(type) type
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
layout(buffer_reference, scalar) readonly buffer ViewBuffer { View view; };
layout(buffer_reference, scalar) readonly buffer LightBuffer { Light light[]; };
layout(buffer_reference, scalar) buffer UintBuffer { uint at[]; };
layout(buffer_reference, scalar) readonly buffer FloatBuffer { float at[]; };
layout(buffer_reference, scalar) readonly buffer Vec4Buffer { vec4 at[]; };
layout(buffer_reference, scalar) buffer ColourBuffer { vec4 at[]; };
layout(buffer_reference, scalar) buffer HalfBuffer { uvec2 at[]; };
layout(buffer_reference, scalar) readonly buffer HalfTable { HalfBuffer at[]; };
#endif

SHARED_BEGIN

// A tile is one workgroup of the relight shader.
SHARED_CONST uint kTileWidth = 16u;
SHARED_CONST uint kTileHeight = 8u;

// Cached images hold cd/m^2 times this as half floats: 0.004 .. 4,000,000 cd/m^2 at full precision.
SHARED_CONST float kImageScale = 1.0f / 64.0f;
// See kRadianceScale in scene/passes.h.
SHARED_CONST float kPassScale = 1024.0f;

SHARED_CONST uint kDrawSurfaces = 1u;
SHARED_CONST uint kDrawHaze = 2u;
SHARED_CONST uint kMarch = 4u;     // samples over the whole ray instead of its part in the cone
SHARED_CONST uint kOutputFloat = 8u; // the frame (vec4, cd/m^2), else a cached image

// Which lights of a list can reach which tile.
struct CullPush {
    BUFFER_OF(ViewBuffer) view;
    BUFFER_OF(LightBuffer) lights;
    BUFFER_OF(UintBuffer) list;       // indices of the lights to draw
    BUFFER_OF(FloatBuffer) tile_far;  // distance of the farthest fragment in each tile
    BUFFER_OF(UintBuffer) tile_count; // out: how many of the lights, per tile
    BUFFER_OF(UintBuffer) tile_light; // out: their indices, list_count places per tile
    uint list_count;
    uint tiles_x;
    uint tiles_y;
};
SHARED_SIZE(CullPush, 64);

// Sum of some lights and of some cached images into one image.
struct RelightPush {
    BUFFER_OF(ViewBuffer) view;
    BUFFER_OF(LightBuffer) lights;
    BUFFER_OF(UintBuffer) tile_count;
    BUFFER_OF(UintBuffer) tile_light;
    BUFFER_OF(Vec4Buffer) fragments;
    BUFFER_OF(UintBuffer) extra_first;
    BUFFER_OF(HalfTable) passes;
    BUFFER_OF(HalfTable) addends;
    BUFFER_OF(ColourBuffer) frame; // one of these two is written
    BUFFER_OF(HalfBuffer) image;
    uint list_count;   // places per tile in tile_light
    uint addend_count;
    uint tiles_x;
    uint flags;
    uint march_steps;
};
SHARED_SIZE(RelightPush, 104);

struct MeterPush {
    BUFFER_OF(ColourBuffer) frame;
    BUFFER_OF(ColourBuffer) exposure; // out: x = factor from cd/m^2 to display
    uint pixel_count;
    float ev100;  // used unless automatic
    uint automatic;
};
SHARED_SIZE(MeterPush, 32);

struct DevelopPush {
    BUFFER_OF(ColourBuffer) frame;
    BUFFER_OF(ColourBuffer) exposure;
    BUFFER_OF(UintBuffer) pixels; // out: RGBA8, sRGB
    uint pixel_count;
};
SHARED_SIZE(DevelopPush, 32);

SHARED_END
#endif
