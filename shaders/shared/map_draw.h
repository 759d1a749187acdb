// SPDX-License-Identifier: Apache-2.0
// Distance maps that the device draws (render/haze/map_drawer.h). Within one octant of directions the octahedral map (shared/octahedral.h)
// is a perspective picture: the octahedron's face lies in a plane, and a texel's ray meets it at its centre. So a map is eight such
// pictures in one image, each kept to its own texels by three clip planes, and nothing is resampled.
#ifndef GHOST_SHARED_MAP_DRAW_H
#define GHOST_SHARED_MAP_DRAW_H
#include "shared/types.h"

SHARED_BEGIN

// Depth is this / (|x| + |y| + |z|): 0 = nothing was met. What is nearer is not seen.
SHARED_CONST float kMapNear_m = 1e-5f;
// By so many texels an octant reaches over its edges: less than to the next centre, and the texels whose centres lie on the diagonals
// between lower and upper half, where a ray is level, belong to both.
SHARED_CONST float kMapEdge_texels = 0.25f;
// Texels a side of what is made at once: a block of directions, and a square that holds a whole cell of every size.
SHARED_CONST uint kMapBlock = 32u;
SHARED_CONST uint kMapSquare = 64u;
// Directions of an octant are numbered by their signs.
SHARED_CONST uint kOctants = 8u;

SHARED_FN vec3 octant_signs(uint octant) {
    return vec3((octant & 1u) != 0u ? 1.0f : -1.0f, (octant & 2u) != 0u ? 1.0f : -1.0f, (octant & 4u) != 0u ? 1.0f : -1.0f);
}

// Clip space of a place as seen from the map's: x and y over w are the map's, -1 to 1.
SHARED_FN vec4 map_clip(vec3 from_map_m, vec3 signs) {
    float up = signs.z > 0.0f ? from_map_m.z : 0.0f;
    float around_m = signs.x * from_map_m.x + signs.y * from_map_m.y + signs.z * from_map_m.z;
    return vec4(from_map_m.x + signs.x * up, from_map_m.y + signs.y * up, kMapNear_m, around_m);
}

// What of it belongs to the octant has none below 0. w: of map_clip.
SHARED_FN vec3 map_inside(vec3 from_map_m, vec3 signs, float w, float side) {
    return signs * from_map_m + vec3(2.0f * kMapEdge_texels / side * w);
}

// One mesh in one octant of one map.
struct MapDraw {
    vec3 axis[3]; // columns of the matrix that turns and scales the mesh into the world
    vec3 place_m; // of its origin, from the map's
    vec3 signs;
    uint layer;   // that is drawn to
};
SHARED_SIZE(MapDraw, 64);

struct MapDrawPush {
    float side; // texels
};
SHARED_SIZE(MapDrawPush, 4);

// What goes from the drawn layer to a map.
struct MapBlock {
    uint layer;
    uint map;
    uint x; // texels
    uint y;
};
SHARED_SIZE(MapBlock, 16);

struct MapBlocksPush {
    uint first; // of the list
    uint side;
};
SHARED_SIZE(MapBlocksPush, 8);

// Whose cells are made anew.
struct MapSquare {
    uint map;
    uint x; // texels
    uint y;
    uint farthest; // where the first of its farthest distances goes
};
SHARED_SIZE(MapSquare, 16);

struct MapSquaresPush {
    uint first;
    uint levels;       // of cells
    uint farthest_level; // the farthest distances are of cells of this one
};
SHARED_SIZE(MapSquaresPush, 12);

SHARED_END
#endif
