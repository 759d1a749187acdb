// SPDX-License-Identifier: Apache-2.0
// What a coarser level of the glare adds to 2x2 texels of the next finer one: texels blended 3 : 1 along both axes. (Loads of its own: four
// samples of a sampler take twice as long on lavapipe.)
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray coarse;
layout(binding = 1, rgba16f) readonly uniform image2DArray fine;
layout(push_constant, scalar) uniform Push { GlareUpPush p; };

// Sixteen times.
void load_above(ivec2 at, out vec3 above[4]) {
    ivec2 last = imageSize(coarse).xy - 1;
    ivec2 low = max(at - 1, 0), high = min(at + 1, last);
    vec3 left[3], right[3];
    for (int y = 0; y < 3; ++y) {
        int row = y == 0 ? low.y : (y == 1 ? at.y : high.y);
        vec3 middle = 3.0 * imageLoad(coarse, ivec3(at.x, row, 0)).rgb;
        left[y] = middle + imageLoad(coarse, ivec3(low.x, row, 0)).rgb;
        right[y] = middle + imageLoad(coarse, ivec3(high.x, row, 0)).rgb;
    }
    above[0] = 3.0 * left[1] + left[0];
    above[1] = 3.0 * right[1] + right[0];
    above[2] = 3.0 * left[1] + left[2];
    above[3] = 3.0 * right[1] + right[2];
}

vec3 with_glare(ivec2 at, vec3 above) {
    return light_of_frame(imageLoad(fine, ivec3(at, 0))) * p.fine_weight + above * (p.coarse_weight / 16.0);
}
