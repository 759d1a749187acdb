// SPDX-License-Identifier: Apache-2.0
// How a pixel shares in four coarse points (shared/coarse.h).
#include "shared/coarse.h"
#include "shared/g_buffer.h"

// Reflected by a material of even light, about: no more than its fraction of the light has to be right where neighbours differ.
vec3 reflected(vec4 diffuse, vec4 specular) { return diffuse.rgb + specular.rgb + vec3(1e-3); }

uint pack_shared_exponent(vec3 value) {
    vec3 v = clamp(value, vec3(0.0), vec3(65408.0));
    float most = max(max(v.r, max(v.g, v.b)), 1e-6);
    int exponent = clamp(int(floor(log2(most))) + 16, 0, 31);
    float unit = exp2(float(exponent - 24));
    if (floor(most / unit + 0.5) > 511.0) {
        exponent += 1;
        unit *= 2.0;
    }
    uvec3 q = min(uvec3(v / unit + 0.5), uvec3(511u));
    return q.r | q.g << 9u | q.b << 18u | uint(exponent) << 27u;
}

vec3 unpack_shared_exponent(uint value) {
    return vec3(uvec3(value, value >> 9u, value >> 18u) & 511u) * exp2(float(int(value >> 27u) - 24));
}

// Bytes that add up to 255.
uint pack_weights(vec4 weights) {
    vec4 fraction = weights * (255.0 / max(dot(weights, vec4(1.0)), 1e-20));
    uvec4 q = uvec4(fraction + 0.5);
    uint most = 0u;
    for (uint k = 1u; k < 4u; ++k) most = fraction[k] > fraction[most] ? k : most;
    uint others = 0u;
    for (uint k = 0u; k < 4u; ++k) others += k == most ? 0u : q[k];
    uint rest = 255u - min(others, 255u);
    for (uint k = 0u; k < 4u; ++k) q[k] = k == most ? rest : q[k];
    return q.x | q.y << 8u | q.z << 16u | q.w << 24u;
}

// A fragment, or a coarse point.
struct Spot {
    vec3 way_m; // from the eye
    float away_m;
    vec3 facet;
    vec3 normal;
    bool there; // a surface
};

Spot spot_of(vec4 place, vec4 normals, vec3 eye_m, float far_m) {
    vec3 way = place.xyz - eye_m;
    bool there = place.w >= 0.0;
    return Spot(way, there ? max(length(way), 1e-4) : far_m, unpack_normal(normals.zw), unpack_normal(normals.xy), there);
}

// How much of the light of a point is that of the fragment: 1 on the same smooth surface. pixel: width of a pixel at 1 m.
float likeness(Spot fragment, Spot point, float pixel) {
    float off_m = min(abs(dot(fragment.facet, point.way_m - fragment.way_m)), abs(dot(point.facet, point.way_m - fragment.way_m)));
    float off = off_m / (2.0 * pixel * fragment.away_m);
    float turn = max(dot(fragment.normal, point.normal), 0.0);
    float turn2 = turn * turn;
    float near = abs(log2(point.away_m / fragment.away_m));
    float same = exp2(-off * off) * turn2 * turn2 * turn2;
    // Where none of the points lies on the fragment's surface the nearest one stands for it.
    return fragment.there && point.there ? same + 1e-4 * exp2(-16.0 * near) + 1e-9 : 0.0;
}

// The same for the haze in front: 1 at the same distance.
float haze_likeness(float away_m, float point_m) {
    float octaves = 8.0 * abs(log2(point_m / away_m));
    return exp2(-octaves * octaves) + 1e-4 * exp2(-octaves) + 1e-9;
}

// Of a pixel of a cell, its distance from the four points.
vec4 bilinear(uvec2 local) {
    vec2 t = vec2(0.25) + 0.5 * vec2(local);
    return vec4((1.0 - t.x) * (1.0 - t.y), t.x * (1.0 - t.y), (1.0 - t.x) * t.y, t.x * t.y);
}
