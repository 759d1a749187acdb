#version 460
// SPDX-License-Identifier: Apache-2.0
// Bounced light (bake --bounces): the picture of each light's bounces as a point source, scaled to the lumens that its beam
// sends out now. No cone cuts it; it is an estimate of the mood in the room.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, rgba32f) readonly uniform image2DArray fragments;
layout(binding = 3, rgba16f) readonly uniform image2DArray bounces;
layout(binding = 4, rgba16f) uniform image2DArray drawn;
layout(push_constant, scalar) uniform Push { BouncePush p; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(view.width, view.height)))) return;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < p.light_count; ++i)
        sum += imageLoad(bounces, ivec3(at, lights[i].pass)).rgb * lights[i].bounce_cd;
    float seen = haze_transmittance(view.haze, length(imageLoad(fragments, ivec3(at, 0)).xyz - view.eye_m)) / kPassScale;
    imageStore(drawn, ivec3(at, 0), light_to_store(imageLoad(drawn, ivec3(at, 0)) + vec4(sum * seen, 0.0)));
}
