#version 460
// SPDX-License-Identifier: Apache-2.0
// Screen Space Re-Rendering: surfaces = pass x beam (2.1), haze = samples of the beam along the camera ray (2.2), for a list
// of lights, added to cached images of other lights. One workgroup is one tile.
#extension GL_GOOGLE_include_directive : require
#include "shared/push.h"
#include "gobo_texture.glsl"
#include "shared/beam.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { RelightPush p; };

vec3 unpack_half(uvec2 packed) { return vec3(unpackHalf2x16(packed.x), unpackHalf2x16(packed.y).x); }

// The same in every frame, so that a light that did not change costs nothing; different for neighbours.
float jitter(uvec2 pixel, uint light) {
    vec2 at = vec2(pixel) + 5.588238 * float(light & 63u);
    return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))));
}

void main() {
    View view = p.view.view;
    uvec2 pixel = gl_GlobalInvocationID.xy;
    bool inside = pixel.x < view.width && pixel.y < view.height;
    pixel = min(pixel, uvec2(view.width - 1u, view.height - 1u));
    uint at = pixel.y * view.width + pixel.x;
    uint pixel_count = view.width * view.height;

    vec2 ndc = vec2(2.0 * (float(pixel.x) + 0.5) / float(view.width) - 1.0,
                    1.0 - 2.0 * (float(pixel.y) + 0.5) / float(view.height));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec3 eye = view.eye_m;
    Haze haze = view.haze;

    vec4 surface = p.fragments.at[at];
    bool has_surface = surface.w >= 0.0;
    vec3 surface_m = surface.xyz;
    float surface_distance = length(surface_m - eye);
    float surface_seen = haze_transmittance(haze, surface_distance);
    float far = has_surface ? surface_distance : view.far_m;
    uint extra_begin = pixel_count + p.extra_first.at[at];
    uint extra_end = pixel_count + p.extra_first.at[at + 1u];
    bool surfaces = (p.flags & kDrawSurfaces) != 0u;
    bool draw_haze = (p.flags & kDrawHaze) != 0u;
    bool march = (p.flags & kMarch) != 0u;
    uint main_count = surfaces && has_surface ? 1u : 0u;
    extra_end = surfaces ? extra_end : extra_begin;
    float scattering = haze.scattering_per_m;

    vec3 sum = vec3(0.0);
    uint tile = gl_WorkGroupID.y * p.tiles_x + gl_WorkGroupID.x;
    uint count = p.tile_count.at[tile];
    for (uint k = 0u; k < count; ++k) {
        uint index = p.tile_light.at[tile * p.list_count + k];
        Light light = p.lights.light[index];
        HalfBuffer pass_a = p.passes.at[light.pass_a];
        HalfBuffer pass_b = p.passes.at[light.pass_b];
        float cut2 = light.cut_radius * light.tan_field;
        cut2 *= cut2;

        // Loop bounds, not branches, skip work on lavapipe.
        vec3 q = to_gate(light, surface_m - light.position_m);
        uint lit = q.z > 0.0 && dot(q.xy, q.xy) < cut2 * q.z * q.z ? main_count : 0u;
        for (uint f = 0u; f < lit; ++f) {
            vec3 radiance = unpack_half(pass_a.at[at]);
            for (uint b = light.pass_a == light.pass_b ? 1u : 0u; b < 1u; ++b)
                radiance = mix(radiance, unpack_half(pass_b.at[at]), light.pass_mix);
            sum += beam_candela(light, q) * radiance * (surface_seen * haze_transmittance(haze, length(q)) / kPassScale);
        }
        for (uint f = extra_begin; f < extra_end; ++f) {
            vec3 extra_m = p.fragments.at[f].xyz;
            q = to_gate(light, extra_m - light.position_m);
            vec3 radiance = mix(unpack_half(pass_a.at[f]), unpack_half(pass_b.at[f]), light.pass_mix);
            float seen = haze_transmittance(haze, length(extra_m - eye) + length(q));
            sum += beam_candela(light, q) * radiance * (seen / kPassScale);
        }

        vec3 q0 = to_gate(light, eye - light.position_m);
        vec3 dq = to_gate(light, dir);
        vec2 part = clip_to_cone(q0, dq, light.tan_field * light.cut_radius, far);
        bool hit = part.y > part.x && draw_haze;
        part = march ? vec2(0.0, far) : part;
        uint samples = hit ? (march ? p.march_steps : light.haze_samples) : 0u;
        float step_m = (part.y - part.x) / float(max(samples, 1u));
        float first = part.x + step_m * (march ? 0.5 : jitter(pixel, index));
        vec3 air = vec3(0.0);
        for (uint s = 0u; s < samples; ++s) {
            float t = first + step_m * float(s);
            vec3 g = q0 + t * dq;
            float distance2 = max(dot(g, g), 1e-6);
            float distance_m = sqrt(distance2);
            float weight = haze_transmittance(haze, t + distance_m) * haze_phase(haze, -dot(g, dq) / distance_m) / distance2;
            weight = g.z > light.lens_m ? weight : 0.0;
            air += beam_candela(light, g) * weight;
        }
        sum += air * (scattering * step_m);
    }

    for (uint k = 0u; k < p.addend_count; ++k) sum += unpack_half(p.addends.at[k].at[at]) / kImageScale;

    if (!inside) return;
    if ((p.flags & kOutputFloat) != 0u) {
        p.frame.at[at] = vec4(sum, 1.0);
    } else {
        vec3 scaled = min(sum * kImageScale, vec3(65000.0));
        p.image.at[at] = uvec2(packHalf2x16(scaled.xy), packHalf2x16(vec2(scaled.z, 0.0)));
    }
}
