#version 460
// SPDX-License-Identifier: Apache-2.0
// Haze without noise, ray by ray (gate_scatter.glsl): every pixel, or every few of them (shared/wide.h).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#include "shared/develop.h"
#include "shared/fan.h"
#include "shared/haze.h"
#include "shared/optics.h"
#include "shared/wide.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) uniform Fans { Fan fans[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray places; // position, coverage
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 10, r16ui) readonly uniform uimage2DArray lonely; // of wide beams, as the next one
layout(binding = 11, rgba16f) uniform image2DArray rays;
layout(push_constant, scalar) uniform Push { GatePush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light
layout(constant_id = 4) const bool kWide = false;   // every few rays only, and lonely pixels (shared/wide.h)
layout(constant_id = 5) const bool kThin = false;   // some beam may be thinner than a pixel

#define GATE p
#define TABLES 7
#include "common/gate_scatter.glsl"

// A ray through the middle of a pixel may miss a beam that is thinner than the pixel, and the next one hit it: a thin beam shows the
// mean of its rows that the pixel covers, times the fraction of the pixel that it covers.
const uint kThinRows = 8u;

vec3 seen_by_pixel(Light light, Fan fan, vec3 dir, float far) {
    if (!kThin) return scattered(light, fan, dir, far);
    bool thin = fan.thin != 0u;
    vec2 aside = vec2(dot(dir, fan.beam.along), dot(dir, fan.beam.across));
    float cos_end = dot(dir, fan.beam.pole);
    float sin_end = max(length(aside), kLeastSine);
    float row = fan_row(fan.beam, aside.x / sin_end, aside.y / sin_end);
    // So much of the pixel, across the beam, that a line of any slope is equally bright in every row or column of pixels.
    vec3 normal = cross(fan.beam.pole, dir);
    vec2 pixel = abs(vec2(dot(normal, view.right) / float(view.width), dot(normal, view.up) / float(view.height)));
    float half_rad = max(pixel.x, pixel.y) * dot(dir, view.forward) / (dot(view.forward, view.forward) * sin_end);
    float reach = max(half_rad * fan.beam.row_scale / sin_end, 1e-6);
    float low = max(row - reach, -1.0), high = aside.x > 0.0 ? min(row + reach, 1.0) : low;
    uint count = thin ? kThinRows : 1u;
    vec3 sum = vec3(0.0);
    for (uint k = 0u; k < count; ++k) {
        vec2 meridian = fan_meridian(fan.beam, mix(low, high, (float(k) + 0.5) / float(kThinRows)));
        vec3 through = fan.beam.pole * cos_end + (fan.beam.along * meridian.x + fan.beam.across * meridian.y) * sin_end;
        sum += scattered(light, fan, thin ? through : dir, far);
    }
    return thin ? sum * (max(high - low, 0.0) / (2.0 * reach * float(kThinRows))) : sum;
}

#include "common/gate_place.glsl"

// Those of a list that belong together: number * per_group and the next ones.
void draw(uint number, uint per_group, uint count) {
    uvec2 size = uvec2(view.width, view.height);
    uint first = haze_list(p.batch, p.tiles, p.blocks) + number * per_group;
    uint tiles = 1u;
    uint rounds = 1u, tip_round = 1u;
    if (kWide) {
        tiles = min(count - number * per_group, per_group);
        uint alone = 0u, tips = 0u;
        for (uint t = 0u; t < tiles; ++t) {
            alone += lonely_in(list[first + t]);
            tips += has_tip(list[first + t]) ? 1u : 0u;
        }
        tip_round += (alone + kTilePixels - 1u) / kTilePixels;
        rounds = tip_round + tips;
    }
    for (uint round = 0u; round < rounds; ++round) {
        Place place;
        if (kWide) {
            place = wide_place(first, tiles, round, tip_round);
        } else {
            uint tile = list[first];
            place = Place(corner_of(tile) + gl_LocalInvocationID.xy, tile, true, false);
        }
        bool inside = place.used && place.pixel.x < size.x && place.pixel.y < size.y;
        ivec2 at = ivec2(min(place.pixel, size - 1u));
        vec2 ndc = vec2(2.0 * (float(at.x) + 0.5) / float(size.x) - 1.0, 1.0 - 2.0 * (float(at.y) + 0.5) / float(size.y));
        vec3 dir = normalize(view.forward + view.right * ndc.x + view.up * ndc.y);
        vec4 surface = imageLoad(places, ivec3(at, 0));
        float far = surface.w >= 0.0 ? length(surface.xyz - view.eye_m) : view.far_m;
        if (kWide) far = inside ? far : 0.0;

        vec3 sum = vec3(0.0);
        if (kSingle) {
            fan_index = p.batch;
            sum = seen_by_pixel(lights[p.batch], fans[p.batch], dir, far);
            if (kWide) sum *= abs((place.tip ? 0.0 : 1.0) - tip_fraction(lights[p.batch], vec2(at)));
        } else {
            uint words = (p.light_count + 31u) / 32u;
            for (uint word = 0u; word < words; ++word) {
                uint mask = mask_of[(p.tiles + p.blocks + place.tile) * kMaskWords + word];
                while (mask != 0u) {
                    uint index = word * 32u + uint(findLSB(mask));
                    mask &= mask - 1u;
                    float fraction = kWide ? abs((place.tip ? 0.0 : 1.0) - tip_fraction(lights[index], vec2(at))) : 1.0;
                    fan_index = index;
                    sum += fraction * seen_by_pixel(lights[index], fans[index], dir, far);
                }
            }
        }
        if (kWide && round == 0u) {
            ivec3 to = ivec3(at / int(p.step), 0);
            if (inside) imageStore(rays, to, light_to_store(imageLoad(rays, to) + vec4(sum, 0.0)));
        } else {
            ivec3 to = ivec3(at, 1);
            if (inside) imageStore(drawn, to, light_to_store(imageLoad(drawn, to) + vec4(sum, 0.0)));
        }
    }
}

void main() {
    uint per_group = kWide ? p.step * p.step : 1u;
    uint count = list[list_count(p.batch, kHazeList)];
    // Of a single light each has its tile: in a loop lavapipe would load all that is the same for its lanes for each of them.
    if (kSingle) {
        draw(gl_WorkGroupID.x, per_group, count);
        return;
    }
    for (uint number = gl_WorkGroupID.x; number * per_group < count; number += gl_NumWorkGroups.x) draw(number, per_group, count);
}
