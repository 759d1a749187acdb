#version 460
// SPDX-License-Identifier: Apache-2.0
// The frame with the finest level of its glare, developed: glare_up.comp and develop.comp in one, where exposure is not measured.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"
#include "shared/glare.h"
#include "common/glare_up.glsl"

layout(binding = 2, scalar) uniform Exposure { vec4 exposure; };
layout(binding = 3, rgba8) writeonly uniform image2DArray picture;
layout(constant_id = 0) const uint kTone = 0u;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = ivec2(p.width, p.height);
    if (any(greaterThanEqual(2 * at, size))) return;
    vec3 above[4];
    load_above(at, above);
    for (int k = 0; k < 4; ++k) {
        ivec2 to = 2 * at + ivec2(k & 1, k >> 1);
        if (any(greaterThanEqual(to, size))) continue;
        vec3 light = with_glare(to, above[k]);
        light /= max(max(light.x, max(light.y, light.z)) / kMostLight, 1.0);
        imageStore(picture, ivec3(to, 0), vec4(develop(light, exposure.x, kTone), 1.0));
    }
}
