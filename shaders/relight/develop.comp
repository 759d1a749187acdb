#version 460
// SPDX-License-Identifier: Apache-2.0
// From scene light to the display: exposure, tone curve, sRGB.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/develop.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(constant_id = 0) const uint kTone = 0u;
layout(binding = 0, rgba16f) readonly uniform image2DArray frame;
layout(binding = 1, scalar) uniform Exposure { vec4 exposure; };
layout(binding = 2, rgba8) writeonly uniform image2DArray picture;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(picture).xy))) return;
    imageStore(picture, ivec3(at, 0), vec4(develop(imageLoad(frame, ivec3(at, 0)).rgb, exposure.x, kTone), 1.0));
}
