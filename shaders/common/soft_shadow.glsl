// SPDX-License-Identifier: Apache-2.0
// How much of its lens a light shows to a place on a surface, by its distance map: every texel in the way is projected back onto
// the disc of the lens (Guennebaud et al., Real-time Soft Shadow Mapping by Backprojection, 2006), which it hides in proportion to its
// area. So things at several distances each throw the penumbra that they should. What throws a penumbra many texels wide is looked up in
// cells of 2 to 64 texels a side, which know what fraction of them is in the way (render/haze/private/blockers.h): nothing thin falls between.
//
// Each texel is compared with the plane of the facet, so that a slanted surface does not shadow itself; what is nearer than kBias in
// front of that plane does not count. Who includes this defines BLOCKERS, their binding, and includes octahedral_map.glsl.
#include "shared/blockers.h"

layout(binding = BLOCKERS) uniform sampler2DArray blockers;

const float kBias_m = 0.02;
const float kBias = 0.004;    // of the distance, more
// In cells of a band, half of a penumbra.
const float kWidest = 2.0;    // 5 x 5 cells hold it
const float kFinest = 0.95;   // what is finer belongs to the next band
const float kClose = 0.3;     // what is this fine may still close a gap between what the band sees
const float kNarrowest = 0.5; // drawn as wide as this at least
const float kCellBlur = 0.2;  // squares of radii: as much wider it gets by cells and soft edges
const float kDark = 0.003; // what is less lit is dark
// The most that may be lit, of the fraction of the lens that nothing is before.
const float kLeak = 1.15;

// A place on a surface, seen from a light.
struct Receiver {
    uint map;
    vec3 ray;         // unit, from the map's place
    float distance_m;
    float texel_rad;
    vec2 place;       // in texels
    vec3 facet;
    float per_plane_m; // facet . ray times this is 1 / (distance to the facet's plane)
    float lens_m;     // radius
};

// Half of the penumbra that something at this distance throws here, as the light sees it.
float penumbra_texels(Receiver r, float blocker_m) {
    return r.lens_m * max(1.0 / max(blocker_m, 1e-3) - 1.0 / r.distance_m, 0.0) / r.texel_rad;
}

vec4 blocker_cell(Receiver r, ivec2 at, int level) {
    // Not the size of the level: where neighbours differ in it, lavapipe gives all of them that of the first.
    return texelFetch(blockers, ivec3(octahedral_wrapped(at, textureSize(blockers, 0).x >> level), int(r.map) - 1), level);
}

// What is nearest in 2 x 2 cells around.
float nearest_around_m(Receiver r, int level) {
    ivec2 corner = ivec2(floor(r.place / float(4 << level) - 0.5));
    float near_m = min(blocker_cell(r, corner, level).x, blocker_cell(r, corner + ivec2(1, 0), level).x);
    return min(near_m, min(blocker_cell(r, corner + ivec2(0, 1), level).x, blocker_cell(r, corner + ivec2(1, 1), level).x));
}

// Area of the disc with this radius, in cells, when its edge is as soft as a cell.
float disc_cells(float radius) {
    return radius >= 0.5 ? kPi * (radius * radius + 1.0 / 12.0) : kPi * (radius + 0.5) * (radius + 0.5) * (radius + 0.5) / 3.0;
}

// Cells of 1 << band texels. Each band is for penumbrae about 1 to 2 cells wide on either side, what is finer for the next.
int band_of(float penumbra, int coarsest) {
    return clamp(int(ceil(log2(max(penumbra / kWidest, 1.0)))), 0, coarsest);
}

// Where a band looks: what is nearer than from_m the band before has seen, what is behind to_m is for the next one.
struct Slab {
    float from_m;
    float to_m;
    float close_m; // what is nearer may belong to what the band sees: no light comes through between
    float plane_m; // of the receiver
};

// What a cell has there: distances and fractions of up to two groups.
struct Things {
    vec2 distance_m;
    vec2 fraction;
    float taken;  // fraction of the cell that is nearer
    float close;  // nearer than Slab::close_m
    float rest_m; // the nearest before the plane that is for the next band
};

// Of a group, even from its nearest to its farthest.
void add_group(inout Things things, int index, Slab slab, float from_m, float to_m, float fraction) {
    float per_m = 1.0 / max(to_m - from_m, 1e-3);
    float taken = clamp((slab.from_m - from_m) * per_m, 0.0, 1.0);
    float here = clamp((slab.to_m - from_m) * per_m, 0.0, 1.0) - taken;
    things.distance_m[index] = 0.5 * (clamp(slab.from_m, from_m, to_m) + clamp(slab.to_m, from_m, to_m));
    things.fraction[index] = fraction * max(here, 0.0);
    things.taken += fraction * taken;
    things.close += fraction * clamp((slab.close_m - from_m) * per_m, 0.0, 1.0);
    float rest_m = max(from_m, slab.to_m);
    things.rest_m = min(things.rest_m, fraction > 0.0 && to_m >= slab.to_m && rest_m < slab.plane_m ? rest_m : kNothing_m);
}

Things things_in(Receiver r, ivec2 at, int band, Slab slab) {
    int layer = int(r.map) - 1;
    Things things = Things(vec2(kNothing_m), vec2(0.0), 0.0, 0.0, kNothing_m);
    if (band == 0) {
        float texel_m = texelFetch(distance_maps, ivec3(at, layer), 0).x;
        things.distance_m.x = texel_m;
        things.taken = texel_m < slab.from_m ? 1.0 : 0.0;
        things.fraction.x = texel_m < slab.to_m ? 1.0 - things.taken : 0.0;
        things.close = texel_m < slab.close_m ? 1.0 : 0.0;
    } else if (band == 1) {
        vec4 texels_m = textureGather(distance_maps, vec3((2.0 * vec2(at) + 1.0) / float(textureSize(distance_maps, 0).x), float(layer)));
        vec4 taken = vec4(lessThan(texels_m, vec4(slab.from_m)));
        vec4 here = vec4(lessThan(texels_m, vec4(slab.to_m))) * (1.0 - taken);
        float count = dot(here, vec4(1.0));
        things.distance_m.x = dot(here, texels_m) / max(count, 1.0);
        things.fraction.x = 0.25 * count;
        things.taken = 0.25 * dot(taken, vec4(1.0));
        things.close = 0.25 * dot(vec4(lessThan(texels_m, vec4(slab.close_m))), vec4(1.0));
        vec4 rest_m = mix(vec4(kNothing_m), texels_m, lessThan(abs(2.0 * texels_m - slab.to_m - slab.plane_m), vec4(slab.plane_m - slab.to_m)));
        things.rest_m = min(min(rest_m.x, rest_m.y), min(rest_m.z, rest_m.w));
    } else {
        vec4 cell = texelFetch(blockers, ivec3(at, layer), band - 2);
        vec2 parts = unpack_parts(cell.z);
        add_group(things, 0, slab, cell.x, cell.y, parts.x);
        vec2 per_m = 1.0 / max(cell.yw, vec2(1e-3));
        add_group(things, 1, slab, 1.0 / mix(per_m.x, per_m.y, parts.y), cell.w, 1.0 - parts.x);
    }
    return things;
}

float soft_shadow(Receiver r, bool wanted) {
    int size = textureSize(distance_maps, 0).x;
    int coarsest = textureQueryLevels(blockers) + 1;
    float per_distance = 1.0 / r.distance_m;
    // How wide penumbrae can be is a matter of what is nearest, and how far around to look of how wide they can be.
    int level = coarsest - 2;
    float widest = 0.0; // texels
    for (int look = 0; look < (wanted ? 3 : 0); ++look) {
        widest = penumbra_texels(r, nearest_around_m(r, level));
        level = min(band_of(widest, coarsest), level);
    }
    float bias_m = kBias_m + kBias * r.distance_m;
    float lit = 1.0, most_lit = 1.0;
    Slab slab = Slab(0.0, 0.0, 0.0, 0.0);
    int band = wanted ? band_of(widest, coarsest) : -1;
    while (band >= 0 && lit > kDark) {
        int cells = size >> band;
        float cell_rad = r.texel_rad * float(1 << band);
        float lens_cells = r.lens_m / cell_rad;
        float finest_m = 1.0 / (per_distance + kFinest / max(lens_cells, 1e-6));
        float close_m = 1.0 / (per_distance + kClose / max(lens_cells, 1e-6));
        vec2 place = r.place / float(1 << band);
        float most = clamp(widest / float(1 << band), kNarrowest, kWidest);
        float disc_radius = sqrt(max(most * most - kCellBlur, kNarrowest * kNarrowest));
        // Two by two for what is no wider than a texel.
        int side = most <= kNarrowest ? 2 : 5;
        ivec2 corner = ivec2(floor(place - (side == 2 ? 0.5 : 2.0)));
        float hidden = 0.0, area = 0.0, open = 0.0, clear = 0.0, rest_m = kNothing_m;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                ivec2 at = octahedral_wrapped(corner + ivec2(column, row), cells);
                vec3 ray = direction_from_octahedral((vec2(at) + 0.5) / float(cells));
                float aside = length(ray - r.ray) / cell_rad;
                // Where the cell's ray meets the facet's plane, and where the cell's nearest ray does.
                float per_m = dot(r.facet, ray) * r.per_plane_m + (band > 0 ? abs(r.per_plane_m) * cell_rad * 0.71 : 0.0);
                slab.plane_m = (per_m * r.distance_m > 0.5 ? 1.0 / per_m : r.distance_m) - bias_m;
                slab.to_m = band > 0 ? min(finest_m, slab.plane_m) : slab.plane_m;
                slab.close_m = band > 0 ? min(close_m, slab.plane_m) : slab.plane_m;
                Things things = things_in(r, at, band, slab);
                rest_m = min(rest_m, things.rest_m);
                vec2 radius = lens_cells * max(1.0 / max(things.distance_m, vec2(1e-3)) - per_distance, 0.0);
                radius = sqrt(clamp(radius * radius - kCellBlur, vec2(kNarrowest * kNarrowest), vec2(kWidest * kWidest)));
                vec2 weight = clamp(radius + 0.5 - aside, 0.0, 1.0) / vec2(disc_cells(radius.x), disc_cells(radius.y));
                hidden += dot(things.fraction, weight);
                float disc = clamp(disc_radius + 0.5 - aside, 0.0, 1.0);
                area += disc;
                open += disc * (1.0 - things.taken);
                clear += disc * (1.0 - max(things.close, things.taken));
            }
        // What lies behind things of the band before is as what is seen beside them.
        float dark = min(hidden * disc_cells(disc_radius) / max(open, 0.3 * area + 1e-6), 1.0);
        // However unlike their distances, things without a gap let no light through.
        float gaps = open < 0.005 * area ? 1.0 : kLeak * clear / open;
        most_lit = min(most_lit, lit * mix(1.0, gaps, clamp(16.0 * dark, 0.0, 1.0)));
        lit *= 1.0 - dark;
        slab.from_m = finest_m;
        widest = penumbra_texels(r, rest_m);
        band = band == 0 ? -1 : min(band_of(widest, coarsest), band - 1);
    }
    return clamp(min(lit, most_lit), 0.0, 1.0);
}
