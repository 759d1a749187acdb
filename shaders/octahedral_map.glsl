// SPDX-License-Identifier: Apache-2.0
// Distance maps (docs/distance-maps.md): how far light gets from each hanging position, as a texture array. Light::map is the
// layer plus one; 0: no map, nothing is in the way. Who includes this defines DISTANCE_MAPS, their binding.
#include "shared/octahedral.h"

layout(binding = DISTANCE_MAPS) uniform sampler2DArray distance_maps;

const float kNothing_m = 6e4;

// How wide a texel is, on average over its two sides, in the direction of a unit vector.
float texel_rad(vec3 direction, int size) {
    float length1 = abs(direction.x) + abs(direction.y) + abs(direction.z);
    return 2.0 / float(size) * length1 * sqrt(length1);
}

// Texel of a map; beyond an edge the octahedron goes on at the same edge, mirrored.
float map_texel(uint map, ivec2 at, int size) {
    bool beyond_x = at.x < 0 || at.x >= size;
    bool beyond_y = at.y < 0 || at.y >= size;
    int x = at.x < 0 ? -1 - at.x : (at.x >= size ? 2 * size - 1 - at.x : at.x);
    int y = at.y < 0 ? -1 - at.y : (at.y >= size ? 2 * size - 1 - at.y : at.y);
    x = beyond_y ? size - 1 - x : x;
    y = beyond_x ? size - 1 - y : y;
    return texelFetch(distance_maps, ivec3(x, y, int(map) - 1), 0).x;
}
