// SPDX-License-Identifier: Apache-2.0
// Octahedral map of directions (Cigolle et al., JCGT 2014): the sphere unfolded onto the square [0, 1]^2. The middle is straight
// down (-Z), the diamond round it the lower half; the four corners are one point, straight up, because lights hang and the folds
// belong where beams rarely go. Texel (i, j) of a map of size s is centred at ((i, j) + 0.5) / s.
#ifndef GHOST_SHARED_OCTAHEDRAL_H
#define GHOST_SHARED_OCTAHEDRAL_H
#include "shared/types.h"

SHARED_BEGIN

// The direction need not be a unit vector; zero gives the middle.
SHARED_FN vec2 octahedral_from(vec3 direction) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real size = max(abs(direction.x) + abs(direction.y) + abs(direction.z), 1e-30f);
    real x = direction.x / size;
    real y = direction.y / size;
    // Folding the upper half out is a shift: 1 - |y| = |x| + |z| on the octahedron.
    real up = max(direction.z / size, 0.0f);
    x += select(x < 0.0f, -up, up);
    y += select(y < 0.0f, -up, up);
    return vec2(0.5f + 0.5f * x, 0.5f + 0.5f * y);
}

// A unit vector.
SHARED_FN vec3 direction_from_octahedral(vec2 place) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real x = 2.0f * place.x - 1.0f;
    real y = 2.0f * place.y - 1.0f;
    real z = abs(x) + abs(y) - 1.0f;
    real up = max(z, 0.0f);
    x -= select(x < 0.0f, -up, up);
    y -= select(y < 0.0f, -up, up);
    return normalize(vec3(x, y, z));
}

SHARED_END
#endif
