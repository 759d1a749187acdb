// SPDX-License-Identifier: Apache-2.0
// What the lights throw at a coarse point, on white, and the haze before it. Who includes this has sums.

struct CoarseLight {
    vec3 white;
    vec3 haze;
};

CoarseLight coarse_light(ivec2 at) {
    uvec4 packed_light = imageLoad(sums, ivec3(at, kCoarseLight));
    vec2 a = unpackHalf2x16(packed_light.x), b = unpackHalf2x16(packed_light.y), c = unpackHalf2x16(packed_light.z);
    return CoarseLight(vec3(a, b.x), vec3(b.y, c));
}
