#version 460
// SPDX-License-Identifier: Apache-2.0
// Haze by samples of the beam along the camera ray. cone: inside the part of the ray that lies in the cone, jittered (Screen
// Space Re-Rendering, section 2.2); march: equal steps over the whole ray (the volumetric stage light thesis).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#define SLIDES 8
#include "common/gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray fragments; // position, coverage; extra fragments in the rows below the picture
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, scalar) uniform AirBlock { Air air; };
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light
layout(constant_id = 2) const bool kUneven = false; // haze is not the same everywhere

// Where in its step a pixel takes its sample: one of four places, all four in every 2x2 block (see sum.comp). The same in
// every frame, so that a light that did not change costs nothing.
float jitter(uvec2 pixel) { return 0.125 + 0.25 * float((pixel.x & 1u) * 2u + ((pixel.x ^ pixel.y) & 1u)); }

// Light that one beam scatters towards the camera on the ray from the eye, up to `far` metres.
vec3 scattered(Light light, vec3 dir, float far, float offset) {
    Haze haze = view.haze;
    bool march = p.march_steps > 0u;
    vec3 q = to_gate(light, view.eye_m - light.position_m);
    vec3 dq = to_gate(light, dir);
    vec2 part = clip_to_cone(q, dq, light.tan_field * light.cut_radius, far);
    bool hit = part.y > part.x;
    part = march ? vec2(0.0, far) : part;
    uint samples = hit ? (march ? p.march_steps : light.haze_samples) : 0u;
    float step_m = (part.y - part.x) / float(max(samples, 1u));
    float t = part.x + step_m * offset;
    vec3 sum = vec3(0.0);
    for (uint s = 0u; s < samples; ++s) {
        vec3 g = q + t * dq;
        float distance2 = max(dot(g, g), 1e-6);
        float distance_m = sqrt(distance2);
        float weight = haze_transmittance(haze, t + way_from_lens_m(light, g)) * haze_phase(haze, -dot(g, dq) / distance_m, near_narrow(light, distance2)) / distance2;
        weight *= attenuation_factor(air.attenuation, distance_m);
        if (kUneven) weight *= air_density(air, view.eye_m + dir * t);
        weight = g.z > light.lens_m ? weight : 0.0;
        sum += beam_candela(light, g) * weight;
        t += step_m;
    }
    return sum * (haze.scattering_per_m * step_m);
}

void draw(uint tile) {
    uvec2 size = uvec2(view.width, view.height);
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    bool inside = pixel.x < size.x && pixel.y < size.y;
    pixel = min(pixel, size - 1u);
    ivec2 at = ivec2(pixel);
    // Through the corner of the pixel: sum.comp takes the mean of its four corners.
    vec2 ndc = vec2(2.0 * float(pixel.x) / float(size.x) - 1.0, 1.0 - 2.0 * float(pixel.y) / float(size.y));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec4 surface = imageLoad(fragments, ivec3(at, 0));
    float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;

    float offset = jitter(pixel);
    gobo_dither = offset;
    vec3 sum = vec3(0.0);
    if (kSingle) {
        sum = scattered(lights[p.batch], dir, far, offset);
    } else {
        uint words = (p.light_count + 31u) / 32u;
        for (uint word = 0u; word < words; ++word) {
            uint mask = mask_of[(p.tiles + p.blocks + tile) * kMaskWords + word];
            while (mask != 0u) {
                uint index = word * 32u + uint(findLSB(mask));
                mask &= mask - 1u;
                sum += scattered(lights[index], dir, far, offset);
            }
        }
    }
    if (inside) imageStore(drawn, ivec3(at, 1), light_to_store(imageLoad(drawn, ivec3(at, 1)) + vec4(sum, 0.0)));
}

void main() {
    // Of a single light each has its tile: in a loop lavapipe would load all that is the same for its lanes for each of them.
    if (kSingle) {
        draw(list[haze_list(p.batch, p.tiles, p.blocks) + gl_WorkGroupID.x]);
        return;
    }
    uint count = list[list_count(p.batch, kHazeList)];
    for (uint number = gl_WorkGroupID.x; number < count; number += gl_NumWorkGroups.x) draw(list[haze_list(p.batch, p.tiles, p.blocks) + number]);
}
