// SPDX-License-Identifier: Apache-2.0
// Attenuation (shared/types.h) as a factor of light that was computed by the inverse square. d in metres.
#ifndef GHOST_SHARED_ATTENUATION_H
#define GHOST_SHARED_ATTENUATION_H
#include "shared/types.h"

SHARED_BEGIN

// Nearer than this a light is taken to be this far away.
SHARED_CONST float kAttenuationNearest_m = 0.001f;
// Without a quadratic part the factor grows with the distance; all three at 0 would make it infinite.
SHARED_CONST float kAttenuationMost = 1e6f;

// What to multiply a quantity with that was computed by the inverse square: d^2 / (constant + linear d + quadratic d^2), 0 to
// kAttenuationMost. Factors must not be negative. As a sum of quotients, so that (0, 0, 1) gives exactly 1 on every device: d^2 / d^2
// need not.
SHARED_FN real attenuation_factor(Attenuation a, real d) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real per_m = 1.0f / max(d, kAttenuationNearest_m);
    real weakening = a.quadratic + per_m * (a.linear + per_m * a.constant);
    return 1.0f / max(weakening, 1.0f / kAttenuationMost);
}

SHARED_END
#endif
