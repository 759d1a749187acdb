// SPDX-License-Identifier: Apache-2.0
// A cell of a distance map, for soft shadows (render/haze/private/blockers.h): four half floats, which are where the nearer of its two groups of
// texels begins and ends in metres, parts, and where the other group ends. Parts is a whole number: the nearer group's fraction of the
// cell, and where the other group begins, by its inverse distance between the two ends.
#ifndef GHOST_SHARED_BLOCKERS_H
#define GHOST_SHARED_BLOCKERS_H
#include "shared/types.h"

SHARED_BEGIN

SHARED_CONST float kFractionSteps = 63.0f;
SHARED_CONST float kFromSteps = 31.0f;

// Both are whole numbers of steps.
SHARED_FN float pack_parts(float fraction_steps, float from_steps) {
    return fraction_steps * (kFromSteps + 1.0f) + from_steps;
}

// The fraction, and 0 to 1 from the end of the nearer group to that of the other one.
SHARED_FN vec2 unpack_parts(float parts) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float fraction_steps = floor(parts / (kFromSteps + 1.0f));
    return vec2(fraction_steps / kFractionSteps, (parts - fraction_steps * (kFromSteps + 1.0f)) / kFromSteps);
}

SHARED_END
#endif
