// SPDX-License-Identifier: Apache-2.0
// Bounced light at a place: volumes as layers of an array, one for each z of each side (bounce/bounce_volumes.h).

// voxels: place in the volume, in voxels.
vec4 volume_at(sampler2DArray volume, vec3 voxels, vec3 size, float side) {
    float z = clamp(voxels.z - 0.5, 0.0, size.z - 1.0);
    float below = floor(z);
    vec2 at = voxels.xy / size.xy;
    float layer = side * size.z + below;
    vec4 low = textureLod(volume, vec3(at, layer), 0.0);
    vec4 high = textureLod(volume, vec3(at, min(layer + 1.0, side * size.z + size.z - 1.0)), 0.0);
    return mix(low, high, z - below);
}
