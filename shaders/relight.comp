#version 460
// SPDX-License-Identifier: Apache-2.0
// Screen Space Re-Rendering: surfaces = pass x beam (2.1), haze = samples of the beam along the camera ray (2.2), for a list
// of lights, added to cached images of other lights. One workgroup is one tile.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform LightBlock { Light lights[kLightsPerDispatch]; };
layout(binding = 3, scalar) readonly buffer TileMask { uint tile_mask[]; };
layout(binding = 4) uniform sampler2DArray passes;    // radiance of every fragment, one layer a pass
layout(binding = 5) uniform sampler2DArray fragments; // position, coverage; extra fragments in the rows below the picture
layout(binding = 6) uniform usampler2DArray extras;   // of a pixel: index of its first extra fragment * 4 + their number
layout(binding = 7) uniform sampler2DArray base;      // the picture without lights
layout(binding = 8, rgba16f) uniform image2DArray images;
layout(binding = 9, rgba32f) uniform image2DArray frame;
layout(push_constant, scalar) uniform Push { RelightPush p; };

// The same in every frame, so that a light that did not change costs nothing; different for neighbours.
float jitter(uvec2 pixel, uint light) {
    vec2 at = vec2(pixel) + 5.588238 * float(light & 63u);
    return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))));
}

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uvec2 pixel = gl_GlobalInvocationID.xy;
    bool inside = pixel.x < size.x && pixel.y < size.y;
    pixel = min(pixel, size - 1u);
    ivec2 at = ivec2(pixel);

    vec2 ndc = vec2(2.0 * (float(pixel.x) + 0.5) / float(size.x) - 1.0, 1.0 - 2.0 * (float(pixel.y) + 0.5) / float(size.y));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec3 eye = view.eye_m;
    Haze haze = view.haze;

    vec4 surface = texelFetch(fragments, ivec3(at, 0), 0);
    bool has_surface = surface.w >= 0.0;
    vec3 surface_m = surface.xyz;
    float surface_distance = length(surface_m - eye);
    float surface_seen = haze_transmittance(haze, surface_distance) / kPassScale;
    float far = has_surface ? surface_distance : view.far_m;
    bool surfaces = (p.flags & kDrawSurfaces) != 0u;
    bool draw_haze = (p.flags & kDrawHaze) != 0u;
    bool march = (p.flags & kMarch) != 0u;
    uint main_count = surfaces && has_surface ? 1u : 0u;
    uint extra = texelFetch(extras, ivec3(at, 0), 0).x;
    uint extra_begin = extra >> 2;
    uint extra_end = extra_begin + (surfaces ? extra & 3u : 0u);

    vec3 sum = vec3(0.0);
    uint tile = (gl_WorkGroupID.y * p.tiles_x + gl_WorkGroupID.x) * kMaskWords;
    uint words = (p.light_count + 31u) / 32u;
    for (uint word = 0u; word < words; ++word) {
        uint mask = tile_mask[tile + word];
        while (mask != 0u) {
            Light light = lights[word * 32u + uint(findLSB(mask))];
            mask &= mask - 1u;
            float cut2 = light.cut_radius * light.tan_field;
            cut2 *= cut2;
            uint blend = light.pass_a == light.pass_b ? 0u : 1u;

            // Loop bounds, not branches, skip work on lavapipe.
            vec3 q = to_gate(light, surface_m - light.position_m);
            uint lit = q.z > 0.0 && dot(q.xy, q.xy) < cut2 * q.z * q.z ? main_count : 0u;
            for (uint f = 0u; f < lit; ++f) {
                vec3 radiance = texelFetch(passes, ivec3(at, light.pass_a), 0).rgb;
                for (uint b = 0u; b < blend; ++b)
                    radiance = mix(radiance, texelFetch(passes, ivec3(at, light.pass_b), 0).rgb, light.pass_mix);
                sum += beam_candela(light, q) * radiance * (surface_seen * haze_transmittance(haze, length(q)));
            }
            for (uint f = extra_begin; f < extra_end; ++f) {
                ivec2 row = ivec2(f % size.x, size.y + f / size.x);
                vec3 extra_m = texelFetch(fragments, ivec3(row, 0), 0).xyz;
                q = to_gate(light, extra_m - light.position_m);
                vec3 radiance = texelFetch(passes, ivec3(row, light.pass_a), 0).rgb;
                for (uint b = 0u; b < blend; ++b)
                    radiance = mix(radiance, texelFetch(passes, ivec3(row, light.pass_b), 0).rgb, light.pass_mix);
                sum += beam_candela(light, q) * radiance *
                       (haze_transmittance(haze, length(extra_m - eye) + length(q)) / kPassScale);
            }

            vec3 q0 = to_gate(light, eye - light.position_m);
            vec3 dq = to_gate(light, dir);
            vec2 part = clip_to_cone(q0, dq, light.tan_field * light.cut_radius, far);
            bool hit = part.y > part.x && draw_haze;
            part = march ? vec2(0.0, far) : part;
            uint samples = hit ? (march ? p.march_steps : light.haze_samples) : 0u;
            float step_m = (part.y - part.x) / float(max(samples, 1u));
            float first = part.x + step_m * (march ? 0.5 : jitter(pixel, light.pass_a));
            vec3 air = vec3(0.0);
            for (uint s = 0u; s < samples; ++s) {
                float t = first + step_m * float(s);
                vec3 g = q0 + t * dq;
                float distance2 = max(dot(g, g), 1e-6);
                float distance_m = sqrt(distance2);
                float weight =
                    haze_transmittance(haze, t + distance_m) * haze_phase(haze, -dot(g, dq) / distance_m) / distance2;
                weight = g.z > light.lens_m ? weight : 0.0;
                air += beam_candela(light, g) * weight;
            }
            sum += air * (haze.scattering_per_m * step_m);
        }
    }

    for (uint k = 0u; k < p.addend_count; ++k) sum += imageLoad(images, ivec3(at, p.addend[k])).rgb / kImageScale;
    for (uint k = (p.flags & kAddBase) != 0u ? 0u : 1u; k < 1u; ++k) sum += texelFetch(base, ivec3(at, 0), 0).rgb / kImageScale;

    bool accumulate = (p.flags & kAccumulate) != 0u;
    if (!inside) return;
    if ((p.flags & kOutputFrame) != 0u) {
        for (uint k = accumulate ? 0u : 1u; k < 1u; ++k) sum += imageLoad(frame, ivec3(at, 0)).rgb;
        imageStore(frame, ivec3(at, 0), vec4(sum, 1.0));
    } else {
        for (uint k = accumulate ? 0u : 1u; k < 1u; ++k) sum += imageLoad(images, ivec3(at, p.target)).rgb / kImageScale;
        imageStore(images, ivec3(at, p.target), vec4(min(sum * kImageScale, vec3(65000.0)), 0.0));
    }
}
