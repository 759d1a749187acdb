#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds bounced light to the frame: what surfaces reflect of it, and how the haze before them glows. By pixels of the picture, or by its edges,
// whose extra fragments are other surfaces within a pixel; these have the glow of the main one.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/brdf.h"
#include "shared/g_buffer.h"
#include "shared/glare.h"
#include "shared/haze.h"
#include "shared/room_light.h"
#include "common/room_volume.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 2, rgba16f) readonly uniform image2DArray normals;
layout(binding = 3, rgba16f) readonly uniform image2DArray diffuse;
layout(binding = 4, rgba16f) readonly uniform image2DArray specular;
layout(binding = 5) uniform usampler2DArray edges;
layout(binding = 6) uniform sampler2DArray surfaces; // lux
layout(binding = 7) uniform sampler2DArray air;
layout(binding = 8) uniform sampler2DArray slices; // glow.comp
layout(binding = 9, rgba16f) uniform image2DArray frame;
layout(push_constant, scalar) uniform Push { RoomLightPush p; };

// By the sides that a normal faces; alpha: how much of them is known.
vec4 sides_at(sampler2DArray volume, vec3 voxels, vec3 size, vec3 normal) {
    vec4 sum = vec4(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        float weight = normal[axis] * normal[axis];
        if (weight > 0.02) sum += weight * volume_at(volume, voxels, size, float(2 * axis + (normal[axis] < 0.0 ? 1 : 0)));
    }
    return sum;
}

vec3 lux_on(vec3 place_m, vec3 normal) {
    vec4 found = sides_at(surfaces, (place_m - p.low_m) / p.surfel_m, p.surfels, normal);
    // What no surfel stands for, thin things and bodies, gets what falls on a surface in the air there.
    if (found.w < 0.05) found = sides_at(air, (place_m + normal * (0.5 * p.cell_m) - p.low_m) / p.cell_m, p.cells, normal);
    return found.w < 0.05 ? vec3(0.0) : found.rgb / found.w;
}

vec3 reflected(ivec3 texel, vec4 place) {
    vec4 packed_normals = imageLoad(normals, texel);
    vec3 facet = unpack_normal(packed_normals.zw);
    vec3 lux = lux_on(place.xyz, facet);
    float covers = min(place.w, 1.0);
    if (p.as_lux != 0u) return lux * covers;
    vec4 layer = imageLoad(diffuse, texel), mirror = imageLoad(specular, texel);
    vec3 way = place.xyz - view.eye_m;
    float away_m = length(way);
    Brdf brdf = Brdf(layer.rgb, layer.w, mirror.rgb, mirror.w);
    vec3 albedo = brdf_albedo(brdf, abs(dot(unpack_normal(packed_normals.xy), way)) / max(away_m, 1e-6));
    return albedo * lux * (haze_transmittance(view.haze, away_m) * covers / kPi);
}

vec3 glow_before(vec2 pixel, float distance_m) {
    float at = clamp((distance_m - p.near_m) / p.slice_m, 0.0, float(p.slices - 1u));
    float below = floor(at);
    vec2 uv = (pixel / float(kGlowStep) + 0.5) / vec2(p.glow_width, p.glow_height);
    vec3 low = textureLod(slices, vec3(uv, below), 0.0).rgb;
    vec3 high = textureLod(slices, vec3(uv, min(below + 1.0, float(p.slices - 1u))), 0.0).rgb;
    return mix(low, high, at - below);
}

void add(ivec2 pixel, vec3 more) {
    vec3 light = light_of_frame(imageLoad(frame, ivec3(pixel, 0))) + more;
    float over = max(max(light.x, max(light.y, light.z)) / kMostLight, 1.0);
    imageStore(frame, ivec3(pixel, 0), light_to_store(vec4(light / over, over - 1.0)));
}

void main() {
    if (p.edges > 0u) {
        uint i = gl_WorkGroupID.x * 64u + gl_LocalInvocationIndex;
        if (i >= p.edges) return;
        uvec2 edge = texelFetch(edges, ivec3(i % view.width, i / view.width, 0), 0).xy;
        uint first = edge.y >> 2;
        vec3 sum = vec3(0.0);
        for (uint k = first; k < first + (edge.y & 3u); ++k) {
            ivec3 texel = ivec3(k % view.width, view.height + k / view.width, 0);
            vec4 place = imageLoad(places, texel);
            if (place.w > 0.0) sum += reflected(texel, place);
        }
        if (any(greaterThan(sum, vec3(0.0)))) add(ivec2(edge.x % view.width, edge.x / view.width), sum);
        return;
    }
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (pixel.x >= view.width || pixel.y >= view.height) return;
    vec4 place = imageLoad(places, ivec3(pixel, 0));
    vec3 sum = vec3(0.0);
    if (place.w > 0.0) sum = reflected(ivec3(pixel, 0), place);
    if (p.as_lux == 0u) sum += glow_before(vec2(pixel) + 0.5, place.w > 0.0 ? length(place.xyz - view.eye_m) : view.far_m);
    if (any(greaterThan(sum, vec3(0.0)))) add(ivec2(pixel), sum);
}
