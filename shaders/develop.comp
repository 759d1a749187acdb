#version 460
// SPDX-License-Identifier: Apache-2.0
// From scene light to the display: exposure, tone curve, sRGB.
#extension GL_GOOGLE_include_directive : require
#include "shared/push.h"
#include "shared/develop.h"

layout(local_size_x = 256) in;
layout(push_constant, scalar) uniform Push { DevelopPush p; };

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at >= p.pixel_count) return;
    vec3 shown = develop(p.frame.at[at].rgb, p.exposure.at[0].x);
    p.pixels.at[at] = packUnorm4x8(vec4(shown, 1.0));
}
