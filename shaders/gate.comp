#version 460
// SPDX-License-Identifier: Apache-2.0
// Haze without noise: the part of each camera ray inside a beam is cut into a few segments, even in the angle seen from the lamp,
// and each takes its light from the beam's fan (shared/fan.h) and its phase and transmittance where that light is.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/develop.h"
#include "shared/fan.h"
#include "shared/haze.h"
#include "shared/optics.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform FanBlock { Fan fans[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7) uniform sampler2DArray table;
layout(push_constant, scalar) uniform Push { GatePush p; };
layout(constant_id = 0) const bool kFocus = true;   // some light gets out of focus: the table has levels of blur
layout(constant_id = 1) const bool kSingle = false; // a batch is one light

// Prefix sums at a place 0..1 of a row -1..1.
vec4 prefix(Fan fan, vec2 texel, uint level, float row, float column) {
    vec2 at = vec2(float(fan_left(fan, level)), 0.0) + 0.5 +
              vec2(column, 0.5 * row + 0.5) * (float(fan_side(fan.size, level)) - 1.0);
    return textureLod(table, vec3(at * texel, float(fan.layer)), 0.0);
}

vec4 between(Fan fan, vec2 texel, uint level, float row, float from, float to) {
    return prefix(fan, texel, level, row, to) - prefix(fan, texel, level, row, from);
}

vec3 scattered(Light light, Fan fan, vec3 dir, float far) {
    Haze haze = view.haze;
    vec2 texel = 1.0 / vec2(textureSize(table, 0).xy);
    vec2 aside = vec2(dot(dir, fan.along), dot(dir, fan.across));
    float cos_end = dot(dir, fan.pole);
    // A ray through the lamp itself has no plane: the nearest one that has.
    float sin_end = max(length(aside), 1e-4);
    vec2 meridian = aside / sin_end;
    float row = fan_row(fan, meridian.x, meridian.y);
    vec2 chord = fan_chord(fan, meridian.x);

    // Nothing shines before the lens.
    float eye_z = fan.eye_m * fan.cos_axis;
    float fall = dot(dir, light.axis_w);
    fall = abs(fall) < 1e-6 ? 1e-6 : fall;
    float lens_t = (light.lens_m - eye_z) / fall;
    float t0 = fall > 0.0 ? max(lens_t, 0.0) : 0.0;
    float t1 = fall > 0.0 ? far : min(far, lens_t);
    float begin = max(chord.x, atan(t0 * sin_end, fan.eye_m + t0 * cos_end));
    float end = min(chord.y, atan(max(t1, 0.0) * sin_end, fan.eye_m + t1 * cos_end));
    bool hit = end > begin && t1 > t0 && abs(row) <= 1.0;

    float distance_m = fan.eye_m * sin_end;
    // As many segments as the curvature of the phase function (sharpest where the light comes at the eye) and the haze on the
    // way ask for.
    vec2 first = vec2(cos(begin), sin(begin)), last = vec2(cos(end), sin(end));
    float g = haze.forward_g;
    float ahead = (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 + first.x * cos_end + first.y * sin_end);
    float way0 = (distance_m + fan.eye_m * first.y) / max(sin_end * first.x - cos_end * first.y, 1e-6);
    float way1 = (distance_m + fan.eye_m * last.y) / max(sin_end * last.x - cos_end * last.y, 1e-6);
    float depth = haze.extinction_per_m * (way1 - way0);
    float wanted = sqrt((end - begin) * (end - begin) * (2.0 + 3.0 * g / ahead) + 8.0 * depth * depth) * p.segments_per_rad;
    uint count = hit ? clamp(uint(ceil(wanted)), 1u, p.most_segments) : 0u;

    float step_rad = (end - begin) / float(max(count, 1u));
    float scale = 1.0 / max(chord.y - chord.x, 1e-9);
    // What a segment takes from the table is at least this wide: a texel and a half.
    float narrowest = 1.5 / float(fan.size - 1u);
    vec3 sum = vec3(0.0);
    for (uint k = 0u; k < count; ++k) {
        float from = begin + float(k) * step_rad;
        float middle = from + 0.5 * step_rad;
        float c0 = (from - chord.x) * scale;
        float c1 = c0 + step_rad * scale;
        float grow = max(0.5 * (narrowest - (c1 - c0)), 0.0);
        c0 = clamp(c0 - grow, 0.0, 1.0);
        c1 = clamp(c1 + grow, 0.0, 1.0);
        vec4 light_here;
        if (kFocus) {
            float cos_middle = cos(middle), sin_middle = sin(middle);
            float r = distance_m / max(sin_end * cos_middle - cos_end * sin_middle, 1e-6);
            float z = r * (cos_middle * fan.cos_axis + sin_middle * fan.sin_axis * meridian.x);
            float level = clamp(log2(beam_blur(light, z) / fan.sharpest),
                                0.0, float(fan.levels - 1u));
            uint low = uint(level);
            uint high = min(low + 1u, fan.levels - 1u);
            light_here = mix(between(fan, texel, low, row, c0, c1), between(fan, texel, high, row, c0, c1), level - float(low));
        } else {
            light_here = between(fan, texel, 0u, row, c0, c1);
        }
        // Phase and transmittance where the light of this segment is.
        float weight = luminance_of(light_here.rgb);
        float centre = weight > 1e-6 ? clamp(light_here.a / weight, c0, c1) : 0.5 * (c0 + c1);
        float psi = clamp(chord.x + centre * (chord.y - chord.x), from, from + step_rad);
        float cos_psi = cos(psi), sin_psi = sin(psi);
        float to_end = max(sin_end * cos_psi - cos_end * sin_psi, 1e-6);
        float way_m = distance_m / to_end + fan.eye_m * sin_psi / to_end;
        float seen = haze_transmittance(haze, way_m) * haze_phase(haze, -(cos_psi * cos_end + sin_psi * sin_end));
        sum += light_here.rgb * (seen / max(c1 - c0, 1e-9));
    }
    return sum * light.intensity_cd * (haze.scattering_per_m * step_rad / distance_m * fan_most(light.colour_b));
}

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tile = list[p.batch * (2u * p.tiles + p.blocks) + gl_WorkGroupID.x];
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    bool inside = pixel.x < size.x && pixel.y < size.y;
    ivec2 at = ivec2(min(pixel, size - 1u));
    vec2 ndc = vec2(2.0 * (float(at.x) + 0.5) / float(size.x) - 1.0, 1.0 - 2.0 * (float(at.y) + 0.5) / float(size.y));
    vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
    vec4 surface = imageLoad(places, ivec3(at, 0));
    float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;

    vec3 sum = vec3(0.0);
    if (kSingle) {
        sum = scattered(lights[p.batch], fans[p.batch], dir, far);
    } else {
        uint words = (p.light_count + 31u) / 32u;
        for (uint word = 0u; word < words; ++word) {
            uint mask = mask_of[(p.tiles + p.blocks + tile) * kMaskWords + word];
            while (mask != 0u) {
                uint index = word * 32u + uint(findLSB(mask));
                mask &= mask - 1u;
                sum += scattered(lights[index], fans[index], dir, far);
            }
        }
    }
    if (inside) imageStore(drawn, ivec3(at, 1), light_to_store(imageLoad(drawn, ivec3(at, 1)) + vec4(sum, 0.0)));
}
