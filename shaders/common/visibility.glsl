// SPDX-License-Identifier: Apache-2.0
// Where what a unit sees of a lamp is kept (shared/visibility.h). Who includes this has the push constants p: RelightPush, and defines
// KEEPS, the first of three bindings.
#include "shared/visibility.h"

layout(binding = KEEPS, scalar) uniform Keeps { Keep keeps[kLightsPerChunk]; };
layout(binding = KEEPS + 1, scalar) readonly buffer Entries { uint pages_used; uint unused; uvec2 entries[]; };
layout(binding = KEEPS + 2, rg16) uniform image2DArray pages;

struct Page {
    ivec3 texel; // of this invocation's fragment
    bool there;  // else there is no room for it
    bool make;
    bool has_old;
};

Page page_of(Keep keep, uint unit) {
    uvec2 entry = keep.place == 0u ? uvec2(0u) : entries[(keep.place - 1u) * p.units + unit];
    uint page = max(entry.x, 1u) - 1u;
    uint in_layer = page % kPagesOfLayer;
    uvec2 corner = uvec2(in_layer % kPagesAcross, in_layer / kPagesAcross) * uvec2(kTileWidth, kTileHeight);
    uvec2 local = uvec2(gl_LocalInvocationIndex % kTileWidth, gl_LocalInvocationIndex / kTileWidth);
    return Page(ivec3(corner + local, page / kPagesOfLayer), entry.x != 0u, (entry.y & kMakes) != 0u, (entry.y & kHasOld) != 0u);
}

// What a page holds of a fraction, to the bit, whether it was kept or not: which units are made hangs on what else is drawn.
float as_kept(float fraction) { return floor(fraction * 65535.0 + 0.5) / 65535.0; }

// A fragment's mark, 0..1 in steps of 16 bits.
float mark_of(vec3 place_m, vec3 facet) {
    uvec3 bits = floatBitsToUint(place_m) ^ (floatBitsToUint(facet) >> 5u);
    uint h = bits.x * 0x9e3779b1u ^ bits.y * 0x85ebca6bu ^ bits.z * 0xc2b2ae35u;
    h ^= h >> 15u;
    h *= 0x2c1b3c6du;
    return float((h ^ h >> 12u) >> 16u) / 65535.0;
}
