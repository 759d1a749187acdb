#version 460
// SPDX-License-Identifier: Apache-2.0
// Lists the tiles that a group of lights can reach, and per tile which of them. Conservative. Surfaces: the sphere round
// the tile's (or block's) fragments meets the cone. Haze: a stretch of the tile's bundle of camera rays meets the cone, widened by the
// bundle's radius at the stretch's far end (a cone moved back by r / sin holds all points within r of it), tested with the middle ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/beam.h"
#include "shared/visibility.h"

layout(local_size_x = 64, local_size_y_id = 2) in; // tiles; lanes that share the lights of a tile
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform Lights { Light lights[kLightsPerChunk]; };
layout(binding = 2, scalar) readonly buffer TileBounds { vec4 tile_bounds[]; }; // 2 a tile: centre, radius; farthest, -, -, -
layout(binding = 3, scalar) buffer Masks { uint mask_of[]; }; // of each tile, a bit a light; marks: of each light, a bit a tile
layout(binding = 4, scalar) buffer Groups { TileGroups groups[]; };
layout(binding = 5, scalar) buffer Lists { uint list[]; };
layout(binding = 6, scalar) buffer Work { FrameWork work; };
layout(binding = 7, scalar) uniform Keeps { Keep keeps[kLightsPerChunk]; };
layout(binding = 8, scalar) buffer Entries { uint pages_used; uint unused; uvec2 entries[]; };
layout(binding = 9, scalar) readonly buffer Changed { uint changed_at[]; };
layout(push_constant, scalar) uniform Push { CullPush p; };
layout(constant_id = 1) const bool kKept = false; // visibility is kept

vec3 gobo_sample(uint layer, vec2 gate, float blur) { return vec3(1.0); }

const float kThinTangent = 0.02;
const float kPixelMore = 1.25; // of the radius of a tile's surfaces
const uint kStretches = 3u; // of a bundle of rays, each four times as far as the one before

// The panel of a projector fills half of its cone: is all of a line of the gate, and what lies within room_m of it, beside it?
bool beside_panel(Light light, vec3 a, vec3 b, float room_m) {
    float z = max(a.z, b.z);
    // What is out of focus spreads as wide as the lens, at its own distance from the focus.
    room_m += light.lens_radius_m * (1.0 + max(z, 0.0) * light.focus_per_m) + 2.0 * light.edge * light.tan_field * max(z, 0.0);
    vec3 per = vec3(vec2(1.0 / light.tan_field), 1.0);
    bool beside = false;
    for (uint k = 0u; k < 4u; ++k) {
        vec3 side = (k < 2u ? light.slide.panel[0] : light.slide.panel[1]) * ((k & 1u) == 0u ? 1.0 : -1.0);
        vec3 outwards = (side - light.slide.panel[2]) * per;
        beside = beside || min(dot(outwards, a), dot(outwards, b)) > room_m * length(outwards);
    }
    return light.slide.layer != 0u && beside;
}

const uint kIsKept = 0u, kIsMade = 1u, kIsDirect = 2u;

// What a unit sees of a lamp: kept, or made by this draw, or not. Another light at the same place may ask, too.
uint way_of(Keep light, uint unit) {
    bool single = p.batch_size == 1u;
    if (light.place == 0u) return single ? kIsDirect : kIsMade;
    uint at = (light.place - 1u) * p.units + unit;
    uvec2 entry = entries[at];
    uint time = entry.y >> kTimeShift;
    bool asked = (entry.y & kAsked) != 0u;
    bool fresh = time >= max(light.since, changed_at[unit]);
    if (entry.x != 0u && fresh && !asked) {
        if (time != p.now) entries[at].y = time << kTimeShift;
        return time != p.now ? kIsKept : kIsMade;
    }
    uint old = entry.x != 0u && time >= light.since && (!asked || (entry.y & kHasOld) != 0u) ? kHasOld : 0u;
    if (single && !(asked && fresh)) {
        entries[at].y = p.now << kTimeShift | old | kAsked;
        return kIsDirect;
    }
    if (single && atomicAdd(work.units_to_make, 1u) >= p.most_made) return kIsDirect;
    if (entry.x == 0u && pages_used < p.pages) {
        uint page = atomicAdd(pages_used, 1u) + 1u;
        if (page <= p.pages) atomicCompSwap(entries[at].x, 0u, page);
    }
    bool has_page = entries[at].x != 0u;
    if (!has_page) atomicAdd(work.units_without_page, 1u);
    if (single && !has_page) return kIsDirect;
    entries[at].y = p.now << kTimeShift | old | kMakes;
    return kIsMade;
}

shared uint surface_masks[64][kMaskWords], haze_masks[64][kMaskWords];
shared uint made_counts[64], direct_counts[64];

void main() {
    uint lanes = gl_WorkGroupSize.y, lane = gl_LocalInvocationID.y, place = gl_LocalInvocationID.x;
    uint tile = gl_GlobalInvocationID.x;
    bool inside = tile < p.tiles + p.blocks;
    uint batch = gl_WorkGroupID.y;
    uint first = batch * p.batch_size;
    uint count = min(p.light_count - first, p.batch_size);
    vec2 size = vec2(view.width, view.height);
    vec2 middle = (vec2(tile % p.tiles_x, tile / p.tiles_x) + 0.5) * vec2(kTileWidth, kTileHeight);
    vec2 ndc = vec2(2.0 * middle.x / size.x - 1.0, 1.0 - 2.0 * middle.y / size.y);
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    float ray_length = length(ray);
    vec3 dir = ray / ray_length;
    uint bounds = inside ? tile : 0u;
    vec4 sphere = tile_bounds[bounds * 2u];
    float far = tile_bounds[bounds * 2u + 1u].x;
    // Half the tile's diagonal as seen along the ray.
    float spread = length(view.right * (float(kTileWidth) / size.x) + view.up * (float(kTileHeight) / size.y)) / ray_length;

    for (uint word = lane; word < kMaskWords; word += lanes) surface_masks[place][word] = haze_masks[place][word] = 0u;
    if (lane == 0u) made_counts[place] = direct_counts[place] = 0u;
    if (lanes > 1u) barrier();
    // Lights of a lane: every one beside those of the others, so that all of them take as long.
    uint made_count = 0u;
    uint direct_count = 0u;
    for (uint word = 0u; inside && word < (count + 31u) / 32u; ++word) {
        uint surface_mask = 0u;
        uint haze_mask = 0u;
        uint end = min(count, (word + 1u) * 32u);
        for (uint i = word * 32u + lane; i < end; i += lanes) {
            Light light = lights[first + i];
            float k = light.tan_field * light.cut_radius;
            float back_per_m = sqrt(1.0 + k * k) / k;
            uint bit = 1u << (i & 31u);
            bool lit = max(light.intensity_cd.x, max(light.intensity_cd.y, light.intensity_cd.z)) > 0.0;

            vec3 q = to_gate(light, sphere.xyz - light.position_m);
            bool beside = beside_panel(light, q, q, sphere.w);
            // The dot of a thin beam reaches a pixel further.
            q.z += sphere.w * (k < kThinTangent ? kPixelMore : 1.0) * back_per_m;
            bool meets_surface = lit && !beside && sphere.w >= 0.0 && q.z > 0.0 && dot(q.xy, q.xy) < k * k * q.z * q.z;
            surface_mask |= meets_surface ? bit : 0u;
            if (kKept && meets_surface && p.surfaces != 0u && light.map != 0u && p.now != 0u) {
                uint way = way_of(keeps[first + i], tile);
                made_count += way == kIsMade ? 1u : 0u;
                direct_count += way == kIsDirect ? 1u : 0u;
            }

            // The bundle is narrow near the eye: each stretch of it is as wide as at its own far end.
            vec3 eye = to_gate(light, view.eye_m - light.position_m);
            vec3 along = to_gate(light, dir);
            bool meets = false;
            for (uint stretch = 0u; stretch < kStretches; ++stretch) {
                float to = far * exp2(2.0 * (float(stretch) + 1.0 - float(kStretches)));
                float from = stretch == 0u ? 0.0 : 0.25 * to;
                float radius = to * spread * 1.05 + 1e-3;
                vec2 part = clip_to_cone(eye + vec3(0.0, 0.0, radius * back_per_m), along, k, to + radius);
                meets = meets || (part.y > max(part.x, from - radius) &&
                                  !beside_panel(light, eye + part.x * along, eye + part.y * along, radius));
            }
            haze_mask |= lit && light.haze_samples > 0u && tile < p.tiles && meets ? bit : 0u;
        }
        if (surface_mask != 0u) atomicOr(surface_masks[place][word], surface_mask);
        if (haze_mask != 0u) atomicOr(haze_masks[place][word], haze_mask);
    }
    if (made_count > 0u) atomicAdd(made_counts[place], made_count);
    if (direct_count > 0u) atomicAdd(direct_counts[place], direct_count);
    if (lanes > 1u) barrier();
    if (!inside || lane > 0u) return;

    bool any_surface = false;
    bool any_haze = false;
    uint haze_count = 0u;
    uint surface_count = 0u;
    made_count = made_counts[place];
    direct_count = direct_counts[place];
    for (uint word = 0u; word < (count + 31u) / 32u; ++word) {
        uint surface_mask = surface_masks[place][word];
        uint haze_mask = haze_masks[place][word];
        if (p.batch_size > 1u) {
            mask_of[tile * kMaskWords + word] = surface_mask;
            mask_of[(p.tiles + p.blocks + tile) * kMaskWords + word] = haze_mask;
        }
        any_surface = any_surface || surface_mask != 0u;
        any_haze = any_haze || haze_mask != 0u;
        surface_count += uint(bitCount(surface_mask));
        haze_count += uint(bitCount(haze_mask));
    }
    if (any_haze && p.air != 0u) {
        uint at = atomicAdd(list[list_count(batch, kHazeList)], 1u);
        list[haze_list(batch, p.tiles, p.blocks) + at] = tile;
        if (at % p.haze_group == 0u && at / p.haze_group < p.most_groups) atomicAdd(groups[batch].haze[0], 1u);
        atomicAdd(work.haze_tiles, haze_count);
    }
    if (any_surface && p.surfaces != 0u) {
        bool direct = direct_count > 0u;
        bool marked = p.marks != 0u && !direct;
        uint words = (p.tiles + p.blocks + 31u) / 32u;
        if (marked) atomicOr(mask_of[(p.marks - 1u + batch) * words + tile / 32u], 1u << (tile & 31u));
        uint at = marked ? 0u : atomicAdd(list[list_count(batch, direct ? kDirectList : kSurfaceList)], 1u);
        if (!marked) list[(direct ? direct_list(batch, p.tiles, p.blocks) : surface_list(batch, p.tiles, p.blocks)) + at] = tile;
        if (at < p.most_groups && direct) atomicAdd(groups[batch].direct[0], 1u);
        if (at < p.most_groups && !direct && !marked) atomicAdd(groups[batch].surface[0], 1u);
        atomicAdd(work.surface_tiles, surface_count);
        if (direct) atomicAdd(work.direct_units, direct_count);
        if (made_count > 0u) {
            uint place_in_list = atomicAdd(list[list_count(batch, kMadeList)], 1u);
            list[made_list(batch, p.tiles, p.blocks) + place_in_list] = tile;
            if (place_in_list < p.most_groups) atomicAdd(groups[batch].made[0], 1u);
            atomicAdd(work.made_units, made_count);
        }
    }
}
