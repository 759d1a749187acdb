#version 460
// SPDX-License-Identifier: Apache-2.0
// Exposure: manual by EV100, or automatic by the log-average luminance of the lit pixels. One workgroup.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"

layout(local_size_x = 256) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray frame;
layout(binding = 1, scalar) writeonly buffer Exposure { vec4 exposure; }; // x: display value per cd/m^2, y: EV100
layout(push_constant, scalar) uniform Push { MeterPush p; };

shared float sums[256];
shared float counts[256];

void main() {
    uint me = gl_LocalInvocationID.x;
    float sum = 0.0;
    float count = 0.0;
    uint end = p.automatic != 0u ? p.width * p.height : 0u;
    for (uint i = me * 5u; i < end; i += 1280u) {
        float luminance = luminance_of(imageLoad(frame, ivec3(i % p.width, i / p.width, 0)).rgb);
        float lit = luminance > kMeterFloor ? 1.0 : 0.0;
        sum += lit * log2(max(luminance, kMeterFloor));
        count += lit;
    }
    sums[me] = sum;
    counts[me] = count;
    barrier();
    for (uint half_size = 128u; half_size > 0u; half_size >>= 1) {
        if (me < half_size) {
            sums[me] += sums[me + half_size];
            counts[me] += counts[me + half_size];
        }
        barrier();
    }
    if (me == 0u) {
        float average = counts[0] > 0.0 ? exp2(sums[0] / counts[0]) : 1.0;
        float ev = p.automatic != 0u ? log2(average * 100.0 / 12.5) + kAutoBias : p.ev100;
        exposure = vec4(exposure_of(ev), ev, 0.0, 0.0);
    }
}
