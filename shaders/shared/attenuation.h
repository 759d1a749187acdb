// SPDX-License-Identifier: Apache-2.0
// Attenuation as OpenGL and the thesis have it: light grows weaker with 1 / (constant + linear d + quadratic d^2). Physics is
// (0, 0, 1); everything else is taste. d in metres.
#ifndef GHOST_SHARED_ATTENUATION_H
#define GHOST_SHARED_ATTENUATION_H
#include "shared/types.h"

SHARED_BEGIN

struct Attenuation {
    float constant;
    float linear;
    float quadratic;
};
SHARED_SIZE(Attenuation, 12);

// Nearer than this a light is taken to be this far away.
SHARED_CONST float kAttenuationNearest_m = 0.001f;
// Without a quadratic part the factor grows with the distance; all three at 0 would make it infinite.
SHARED_CONST float kAttenuationMost = 1e6f;

// What to multiply a quantity with that was computed by the inverse square: d^2 / (constant + linear d + quadratic d^2), 0 to
// kAttenuationMost. Factors must not be negative. As a sum of quotients, so that (0, 0, 1) gives exactly 1 on every device: d^2 / d^2
// need not.
SHARED_FN float attenuation_factor(Attenuation a, float d) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float per_m = 1.0f / max(d, kAttenuationNearest_m);
    float weakening = a.quadratic + per_m * (a.linear + per_m * a.constant);
    return 1.0f / max(weakening, 1.0f / kAttenuationMost);
}

SHARED_END
#endif
