// SPDX-License-Identifier: Apache-2.0
// Scattering in homogeneous haze: transmittance and the two-term Henyey-Greenstein phase function.
#ifndef GHOST_SHARED_HAZE_H
#define GHOST_SHARED_HAZE_H
#include "shared/types.h"

SHARED_BEGIN

// Henyey-Greenstein, 1/sr; cosine of the angle between the light's way and the scattered way (1 = straight on).
SHARED_FN real henyey_greenstein(real g, real cosine) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real base = max(1.0f + g * g - 2.0f * g * cosine, 1e-4f);
    return (1.0f - g * g) / (4.0f * kPi * base * sqrt(base));
}

// Light that comes from a disc is scattered less sharply: narrow is the cosine of half the angle that it is wide, 1 for a point.
SHARED_FN real haze_phase(Haze haze, real cosine, real narrow) {
    return (1.0f - haze.back_weight) * henyey_greenstein(haze.forward_g * narrow, cosine) +
           haze.back_weight * henyey_greenstein(haze.back_g * narrow, cosine);
}

SHARED_FN real haze_transmittance(Haze haze, real distance_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return exp(-haze.extinction_per_m * distance_m);
}

SHARED_END
#endif
