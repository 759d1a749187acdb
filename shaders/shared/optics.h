// SPDX-License-Identifier: Apache-2.0
// Focus: how far a point of the gate is blurred along the beam. Apart from beam.h because haze needs it without the gobos.
#ifndef GHOST_SHARED_OPTICS_H
#define GHOST_SHARED_OPTICS_H
#include "shared/types.h"

SHARED_BEGIN

// Radius of the blur disc in gate units at distance z along the beam: a thin lens of radius R focused at 1 / focus_per_m.
SHARED_FN float beam_blur(Light light, float z) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float R = light.lens_radius_m;
    return light.edge + R * abs(1.0f - z * light.focus_per_m) / (R + z * light.tan_field);
}

SHARED_END
#endif
