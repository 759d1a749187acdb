// SPDX-License-Identifier: Apache-2.0
// Kept visibility: what fraction of its lens a lamp shows to a fragment rests while lamp, stage and camera do (shaders/common/soft_shadow.glsl),
// whatever the beam does. It is made when a beam reaches a tile (or a block of extra fragments) once more and kept in a page, a texel a
// fragment. Before that, and where things move all the time, it is worked out just where light falls, for what is seen once is not worth
// a page; no more of them are made in a frame than CullPush::most_made, so that none is late because a beam sweeps. (Where many
// lights share a dispatch it is made at once.) Entry of a place (a distance map, with the size of a lens) and a unit (tile, then block): x:
// its page + 1, 0: none; y: when it was made << kTimeShift, + kMakes: it is made by the draw that reads this, + kAsked: it was not made,
// but asked for then, + kHasOld: its page holds what fragments saw that are where they were: each texel knows its fragment again, by
// 16 bits of what it is.
#ifndef GHOST_SHARED_VISIBILITY_H
#define GHOST_SHARED_VISIBILITY_H
#include "shared/push.h"

SHARED_BEGIN

// Of a light, beside it in its chunk.
struct Keep {
    uint place; // + 1; 0: nothing is kept for this light
    uint since; // what was made before is stale
};
SHARED_SIZE(Keep, 8);

SHARED_CONST uint kMakes = 1u;
SHARED_CONST uint kHasOld = 2u;
SHARED_CONST uint kAsked = 4u;
SHARED_CONST uint kTimeShift = 3u;

SHARED_CONST uint kPagesAcross = 256u; // of an atlas layer, and down
SHARED_CONST uint kPagesOfLayer = kPagesAcross * kPagesAcross;

struct VisibilityTouchPush {
    uint count; // of the list
    uint tiles; // of the picture
    uint now;
};
SHARED_SIZE(VisibilityTouchPush, 12);

SHARED_END
#endif
