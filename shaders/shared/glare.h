// SPDX-License-Identifier: Apache-2.0
// Light at the lens: lenses seen from within their beams, and glare, the light that a camera's own lens or an eye scatters
// (docs/design/glare.md). What C++ and the shaders share. Pixels are as in shared::View, y down.
#ifndef GHOST_SHARED_GLARE_H
#define GHOST_SHARED_GLARE_H
#include "shared/types.h"

SHARED_BEGIN

// A lens in the picture. A place on it is (u, v) along axis_u and axis_v of its light, 1 at the rim.
struct Lens {
    Light light;
    vec2 centre_px;
    vec3 spread;         // symmetric matrix (xx, xy, yy): o . spread o = 1 on the rim, o: pixels from the centre
    vec4 to_lens;        // matrix, rows xy and zw: pixels from the centre -> place on the lens
    vec2 gate;           // gate coordinates of the eye
    float gate_per_lens; // what the eye sees through a place of the lens is that much aside in the gate
    float blur;          // gate coordinates within one pixel
    float light_per_cd;  // cd/m^2 per cd
    vec3 stray;          // cd/m^2 that a dirty lens sends everywhere
    float nearest_m;     // what is nearer to the eye hides the lens
};
SHARED_SIZE(Lens, 556);
SHARED_CONST uint kLensesPerChunk = 117u; // within 64 KiB

// A workgroup draws a block of pixels.
SHARED_CONST uint kLensBlockWidth = 8u;
SHARED_CONST uint kLensBlockHeight = 4u;
struct LensPush {
    vec3 eye_m;
    uint blocks_x;
    uint width;
    uint height;
    uint first_block; // in the list: for each block its number, where its lenses begin, how many there are
};
SHARED_SIZE(LensPush, 28);

// coarse = fine * scale, half the size.
struct GlareDownPush {
    uint width; // of the fine one
    uint height;
    float scale;
};
SHARED_SIZE(GlareDownPush, 12);

// fine = fine * fine_weight + coarse * coarse_weight.
struct GlareUpPush {
    uint width; // of the fine one
    uint height;
    float fine_weight;
    float coarse_weight;
};
SHARED_SIZE(GlareUpPush, 16);

struct GlareTailPush {
    float texel_deg;
    float weight; // 1 / sum of glare_tail over all texels
};
SHARED_SIZE(GlareTailPush, 8);

// The CIE's general disability glare function holds up to here; our glare ends here, gently.
SHARED_CONST float kGlareReach_deg = 30.0f;

// Nearer than this the camera's picture is sharp, whatever its pixels: an angle of the lens, so that a finer picture has the
// same halo.
SHARED_CONST float kGlareInner_deg = 0.1f;

// Shape of the far glare: 10 / a^3 + 5 / a^2, this many texels from its source; blunt within 0.6 texels, where the step from the
// level before is least seen.
SHARED_FN float glare_tail(vec2 texels, float texel_deg) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float inverse = inversesqrt(dot(texels, texels) + 0.4f) / texel_deg;
    float way = min(1.0f / (inverse * kGlareReach_deg), 1.0f);
    float fade = 1.0f - way * way;
    return (10.0f * inverse + 5.0f) * inverse * inverse * fade * fade;
}

#ifndef __cplusplus
// The frame's alpha says how many times brighter a pixel is than a half float holds: light = rgb (1 + alpha).
vec3 light_of_frame(vec4 stored) { return stored.rgb * (1.0 + stored.a); }
#endif

// A lens has a soft rim, this many pixels to both sides, and is never drawn smaller than this radius: so that its light stays
// the same wherever it lies between the pixels.
SHARED_CONST float kLensRim_px = 1.0f;

// How much of a lens is at this many pixels from its centre: 0..1.
SHARED_FN float lens_cover(vec2 offset_px, vec3 spread) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec2 way = vec2(spread.x * offset_px.x + spread.y * offset_px.y, spread.y * offset_px.x + spread.z * offset_px.y);
    float radius = sqrt(max(dot(offset_px, way), 1e-12f));
    float slope = length(way) / radius; // of the radius, per pixel
    float t = clamp(0.5f + (1.0f - radius) / (2.0f * kLensRim_px * max(slope, 1e-6f)), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

SHARED_END
#endif
