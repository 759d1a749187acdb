// SPDX-License-Identifier: Apache-2.0
// Distance maps (docs/design/distance-maps.md): how far light gets from each hanging position, as a texture array. Light::map is the
// layer plus one; 0: no map, nothing is in the way. Who includes this defines DISTANCE_MAPS, their binding.
#include "shared/octahedral.h"

layout(binding = DISTANCE_MAPS) uniform sampler2DArray distance_maps;

const float kNothing_m = 6e4;

// How wide a texel is, on average over its two sides, in the direction of a unit vector.
float texel_rad(vec3 direction, int size) {
    float length1 = abs(direction.x) + abs(direction.y) + abs(direction.z);
    return 2.0 / float(size) * length1 * sqrt(length1);
}

// A texel, or beyond an edge: the octahedron goes on at the same edge, mirrored.
ivec2 octahedral_wrapped(ivec2 at, int size) {
    bool beyond_x = at.x < 0 || at.x >= size;
    bool beyond_y = at.y < 0 || at.y >= size;
    int x = at.x < 0 ? -1 - at.x : (at.x >= size ? 2 * size - 1 - at.x : at.x);
    int y = at.y < 0 ? -1 - at.y : (at.y >= size ? 2 * size - 1 - at.y : at.y);
    return ivec2(beyond_y ? size - 1 - x : x, beyond_x ? size - 1 - y : y);
}
