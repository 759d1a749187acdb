// SPDX-License-Identifier: Apache-2.0
// What the G-buffer's shaders and their callers share: how a mesh is drawn, how samples become fragments.
#ifndef GHOST_SHARED_G_BUFFER_H
#define GHOST_SHARED_G_BUFFER_H
#include "shared/octahedral.h"
#include "shared/types.h"

SHARED_BEGIN

// Depth is reversed: kNear_m / distance along the camera's axis, 0 = nothing was hit.
SHARED_CONST float kNear_m = 0.05f;
SHARED_CONST uint kSamples = 4u; // of a pixel

// Which extra fragments share a block hangs on which tile was gathered first. So that the light on one does not, it ends
// this far beyond a beam's rim, and the bounds of blocks reach a bit further.
SHARED_CONST float kExtraReach_px = 2.0f;
SHARED_CONST float kBlockReach_px = 2.1f;

// How a mesh covers its samples, as scene::AlphaMode.
SHARED_CONST uint kOpaque = 0u;
SHARED_CONST uint kMask = 1u;
SHARED_CONST uint kBlend = 2u;

// Bits of a material's textures.
SHARED_CONST uint kBaseTexture = 1u;
SHARED_CONST uint kNormalTexture = 2u;
SHARED_CONST uint kSurfaceTexture = 4u;
SHARED_CONST uint kEmissionTexture = 8u;

// One instance, a draw each. As vertex inputs per instance lavapipe fetches the matrices anew for every vertex (measured on the
// demo: a quarter of the time).
struct MeshPush {
    vec4 to_clip[4]; // columns of the matrix from the mesh to clip space
    vec3 axis[3];    // columns of the matrix that turns and scales directions into the world
    float glow;      // cd/m^2, beside what the material sends out
};
SHARED_SIZE(MeshPush, 104);

struct MeshMaterial {
    vec3 base_colour;
    float alpha;
    vec3 emission;
    float alpha_cutoff;
    float roughness;
    float metalness;
    float specular;
    float normal_scale;
    uint seed; // of the samples of blended surfaces
};
SHARED_SIZE(MeshMaterial, 52);

// Samples of a pixel are one fragment where they lie on one smooth surface: their normals agree, the plane of one passes
// the other within kPlanePixels pixel widths, and they are not farther apart in depth than kDepthPixels.
SHARED_CONST float kNormalCosine = 0.87f;
SHARED_CONST float kPlanePixels = 1.0f;
SHARED_CONST float kDepthPixels = 12.0f;
// Beyond this nothing is a surface.
SHARED_CONST float kFarthest_m = 1e5f;

struct GatherPush {
    vec3 ambient;     // even light, colour times lux
    uint capacity;    // extra fragments that there is room for
    uint tiles;       // of the picture
    uint tiles_x;
    float pixel_m;    // width of a pixel at 1 m along the axis
    uint listed;      // 1: only the tiles of the list, the others stay as they are
    float work_lux;   // of the work light: some from everywhere, most from over the viewer's shoulder
};
SHARED_SIZE(GatherPush, 36);

// Where the extra fragments and the edges of a tile lie. There may be more room than is used: extras without coverage, edges
// without extras.
struct TileRoom {
    uint first_extra;
    uint extras;
    uint first_edge;
    uint edges;
};
SHARED_SIZE(TileRoom, 16);
// The blocks of extra fragments that a list of tiles writes to. groups: as Vulkan wants them; one number of a block after the
// other follows.
struct BlockListHead {
    uint groups[3];
    uint unused;
};
SHARED_SIZE(BlockListHead, 16);

// Bounds in which everything but some tiles is empty, see changed_bounds.comp.
struct ChangedBoundsPush {
    uint tiles;
    uint blocks;
    uint add_blocks; // 0: tiles, all blocks empty; 1: blocks
};
SHARED_SIZE(ChangedBoundsPush, 12);

// A tile that is gathered again and needs more room gets this much more than it needs, for heads turn on.
SHARED_CONST uint kSpareRoom = 16u;

// What gather counts. groups: workgroups over the blocks of extra fragments, as Vulkan wants them.
struct GatherCounts {
    uint groups[3];
    uint extras;   // asked for; those of dropped pixels too
    uint edges;    // pixels with extra fragments, and room for such
    uint used;     // places below this are taken
    uint dropped;  // pixels that lost their extra fragments: no room
    uint unused;
};
SHARED_SIZE(GatherCounts, 32);

// Shading normal and the facet's, for four half floats: each within 0.03 degrees, which light that skims a surface tells.
SHARED_FN vec4 pack_normals(vec3 shading, vec3 facet) {
    return vec4(octahedral_from(shading), octahedral_from(facet)) * 2.0f - vec4(1.0f);
}

SHARED_FN vec3 unpack_normal(vec2 packed_normal) {
    return direction_from_octahedral(packed_normal * 0.5f + vec2(0.5f));
}

SHARED_END
#endif
