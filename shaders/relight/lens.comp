#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds the lenses that shine at the camera to the frame. What is too bright for it is scaled to fit, in its own colour, and
// alpha keeps by how much, for the glare (light_of_frame in shared/glare.h).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define SLIDES 5
#include "common/gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/glare.h"

layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 1, scalar) uniform Lenses { Lens lenses[kLensesPerChunk]; };
layout(binding = 2, scalar) readonly buffer List { uint list[]; };
layout(binding = 3, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 4, rgba16f) uniform image2DArray frame;           // layer 0
layout(push_constant, scalar) uniform Push { LensPush p; };

void main() {
    uint entry = p.first_block + 3u * gl_WorkGroupID.x;
    uint block = list[entry];
    uint first = list[entry + 1u];
    uint end = first + list[entry + 2u];
    uvec2 pixel = uvec2(block % p.blocks_x, block / p.blocks_x) * uvec2(kLensBlockWidth, kLensBlockHeight) + gl_LocalInvocationID.xy;
    if (pixel.x >= p.width || pixel.y >= p.height) return;
    ivec3 at = ivec3(pixel, 0);
    vec4 place = imageLoad(places, at);
    float place_m = place.w < 0.0 ? 1e30 : length(place.xyz - p.eye_m);
    vec3 light = light_of_frame(imageLoad(frame, at));
    for (uint i = first; i < end; ++i) {
        Lens lens = lenses[list[i]];
        vec2 offset = vec2(pixel) + 0.5 - lens.centre_px;
        float cover = lens_cover(offset, lens.spread);
        cover *= place_m < lens.nearest_m ? 1.0 - clamp(place.w, 0.0, 1.0) : 1.0;
        vec2 on_lens = vec2(dot(lens.to_lens.xy, offset), dot(lens.to_lens.zw, offset));
        vec3 gate = beam_gate(lens.light, lens.gate + lens.gate_per_lens * on_lens, even_focus(lens.light, lens.blur));
        light += (lens.light.intensity_cd * gate * lens.light_per_cd + lens.stray) * cover;
    }
    float over = max(max(light.x, max(light.y, light.z)) / kMostLight, 1.0);
    imageStore(frame, at, light_to_store(vec4(light / over, over - 1.0)));
}
