#version 460
// SPDX-License-Identifier: Apache-2.0
// From scene light to a display that shows more than white: develop.comp, but linear and with its highlights.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/present.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray frame;
layout(binding = 1, scalar) uniform Exposure { vec4 exposure; };
layout(binding = 2, rgba16f) writeonly uniform image2DArray picture;
layout(push_constant, scalar) uniform Push { ShownLightPush p; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture).xy))) return;
    imageStore(picture, ivec3(at, 0), vec4(shown_light(imageLoad(frame, ivec3(at, 0)).rgb, exposure.x, p.tone, p.peak), 1.0));
}
