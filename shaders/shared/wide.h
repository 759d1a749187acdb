// SPDX-License-Identifier: Apache-2.0
#ifndef GHOST_SHARED_WIDE_H
#define GHOST_SHARED_WIDE_H
#include "shared/push.h"

// Haze of wide beams at every `step`th ray: texel (i, j) of a small picture is the ray through pixel (i step, j step). A pixel
// between takes the mean of the four around it, weighed by nearness, of those whose surface is as far away as its own. One
// that finds too little of that is lonely (thin things, corners) and gets a ray of its own. After Kopf et al. 2007 (joint
// bilateral upsampling).

SHARED_BEGIN

struct WidePush {
    uint step;
};
SHARED_SIZE(WidePush, 4);

// Surfaces whose distances differ by less, in octaves, have the same haze in front.
SHARED_CONST float kWideAlike = 0.1f;
// A pixel whose neighbours of the same distance have less than this of the weight is lonely.
SHARED_CONST float kWideLeast = 0.2f;

// So many steps from its lens on, a beam is drawn pixel by pixel: there it is too narrow, and bright.
SHARED_CONST float kWideTip = 12.0f;

// Lonely pixels are listed in the texels of their tile; the first one holds their number, too.
SHARED_CONST uint kLonelyPlace = 0xffu; // of the texel: the pixel's place in its tile
SHARED_CONST uint kLonelyCount = 8u;    // bits that the number is shifted by

SHARED_END
#endif
