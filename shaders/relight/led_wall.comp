#version 460
// SPDX-License-Identifier: Apache-2.0
// Adds what the pixels of a LED wall send to the camera, through the haze, to the frame: by pixels of the picture, or by its edges, whose
// extra fragments are other surfaces within a pixel.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#define SLIDES 5
#include "common/gobo_texture.glsl"
#include "shared/led_wall.h"
#include "shared/haze.h"
#include "shared/glare.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 3, rgba16f) uniform image2DArray frame;           // layer 0
layout(binding = 4) uniform usampler2DArray edges;
layout(push_constant, scalar) uniform Push { LedWallPush p; };

vec3 seen_of(vec4 place) {
    vec3 way = place.xyz - view.eye_m;
    float away_m = length(way);
    vec3 at = place_on_wall(p.wall, place.xyz, view.eye_m);
    if (place.w <= 0.0 || at.z == 0.0 || any(greaterThan(abs(at.xy), p.wall.shown))) return vec3(0.0);
    float cosine = max(abs(dot(way, p.wall.normal)) / max(away_m, 1e-6), 0.05);
    // As wide as a pixel there; a disc of the same area, as the levels are.
    float pixel_m = dot(way, view.forward) * 2.0 * length(view.right) / float(view.width) * inversesqrt(cosine);
    vec2 led = led_place(p.wall, at.xy, pixel_m);
    float radius = 0.5642 * max(pixel_m, p.wall.pitch_m) / p.wall.texel_m;
    vec3 picture = slide_sample(p.wall.layer, led * p.wall.scale, radius);
    return p.wall.radiance * max(picture, vec3(0.0)) * (haze_transmittance(view.haze, away_m) * min(place.w, 1.0));
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
        for (uint k = first; k < first + (edge.y & 3u); ++k)
            sum += seen_of(imageLoad(places, ivec3(k % view.width, view.height + k / view.width, 0)));
        if (any(greaterThan(sum, vec3(0.0)))) add(ivec2(edge.x % view.width, edge.x / view.width), sum);
        return;
    }
    uvec2 pixel = uvec2(p.low_x, p.low_y) + gl_GlobalInvocationID.xy;
    if (pixel.x > p.high_x || pixel.y > p.high_y) return;
    vec3 seen = seen_of(imageLoad(places, ivec3(pixel, 0)));
    if (any(greaterThan(seen, vec3(0.0)))) add(ivec2(pixel), seen);
}
