// SPDX-License-Identifier: Apache-2.0
// Light at half the size of the picture, under silhouettes and materials of the full one. A coarse point is a point of the stage behind the
// middle of 2x2 pixels; lights are drawn on these points. Between four of them lie 2x2 pixels (a cell): each takes from the four what belongs
// to its own surface and to its own distance, by weights that rest while stage and camera do, and multiplies with what its own material
// reflects. Joint bilateral upsampling (Kopf et al. 2007), with its weights kept.
#ifndef GHOST_SHARED_COARSE_H
#define GHOST_SHARED_COARSE_H
#include "shared/types.h"

SHARED_BEGIN

struct CoarsePush {
    uint tiles_x; // of kTileWidth x kTileHeight points or cells
    uint listed;  // 1: only the tiles of a list
    uint count;   // edges, or tiles that are listed
    uint width;   // of the picture
    uint height;
};
SHARED_SIZE(CoarsePush, 20);

// Layers of the image of sums: light on a white surface and haze as six halves; in the other, of each point, what to multiply light with
// to have it on white (three floats).
SHARED_CONST uint kCoarseLight = 0u;
SHARED_CONST uint kCoarseWhite = 1u;

// Layers of a cell, each with a word for each of its four pixels: weights of the four points for surfaces and for haze (a byte each), and
// what the pixel's main fragment reflects, times its fraction of the pixel (RGB9E5).
SHARED_CONST uint kCellSurfaces = 0u;
SHARED_CONST uint kCellHaze = 1u;
SHARED_CONST uint kCellReflects = 2u;

SHARED_END
#endif
