#version 460
// SPDX-License-Identifier: Apache-2.0
// The next coarser level of the glare: weights 1 3 3 1 along both axes, so that a light between two texels is shared by both
// and its glare moves with it, not in steps. An invocation makes 2x2 texels of 6x6. At the border the picture is mirrored; a
// level may be larger than half the picture, and is dark there.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/glare.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray fine;
layout(binding = 1, rgba16f) writeonly uniform image2DArray coarse;
layout(push_constant, scalar) uniform Push { GlareDownPush p; };
layout(constant_id = 0) const bool kFrame = false; // the fine level is the frame

void main() {
    ivec2 at = 2 * ivec2(gl_GlobalInvocationID.xy);
    ivec2 to = imageSize(coarse).xy;
    if (any(greaterThanEqual(at, to))) return;
    ivec2 size = ivec2(p.width, p.height);
    bvec2 exact = equal(2 * to, size);
    float wx[6];
    for (int x = 0; x < 6; ++x) wx[x] = exact.x || 2 * at.x - 1 + x < size.x ? 1.0 : 0.0;
    vec3 a = vec3(0.0), b = vec3(0.0), c = vec3(0.0), d = vec3(0.0);
    const float upper[6] = float[](1.0, 3.0, 3.0, 1.0, 0.0, 0.0);
    const float lower[6] = float[](0.0, 0.0, 1.0, 3.0, 3.0, 1.0);
    for (int y = 0; y < 6; ++y) {
        int row = 2 * at.y - 1 + y;
        float wy = exact.y || row < size.y ? 1.0 : 0.0;
        row = clamp(row, 0, size.y - 1);
        vec3 t[6];
        for (int x = 0; x < 6; ++x) {
            vec4 stored = imageLoad(fine, ivec3(clamp(2 * at.x - 1 + x, 0, size.x - 1), row, 0));
            t[x] = (kFrame ? light_of_frame(stored) * wx[x] : stored.rgb);
        }
        vec3 left = t[0] + 3.0 * (t[1] + t[2]) + t[3];
        vec3 right = t[2] + 3.0 * (t[3] + t[4]) + t[5];
        float first = kFrame ? upper[y] * wy : upper[y];
        float second = kFrame ? lower[y] * wy : lower[y];
        a += first * left;
        b += first * right;
        c += second * left;
        d += second * right;
    }
    float scale = p.scale / 64.0;
    bvec2 more = lessThan(at + 1, to);
    imageStore(coarse, ivec3(at, 0), light_to_store(vec4(a * scale, 0.0)));
    if (more.x) imageStore(coarse, ivec3(at.x + 1, at.y, 0), light_to_store(vec4(b * scale, 0.0)));
    if (more.y) imageStore(coarse, ivec3(at.x, at.y + 1, 0), light_to_store(vec4(c * scale, 0.0)));
    if (more.x && more.y) imageStore(coarse, ivec3(at + 1, 0), light_to_store(vec4(d * scale, 0.0)));
}
