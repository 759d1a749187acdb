// SPDX-License-Identifier: Apache-2.0
// Which pixels a workgroup of gate.comp draws, in which round: its tile, or rays of several tiles of wide beams (shared/wide.h).
// Part of gate.comp, which has all that is bound.

struct Place {
    uvec2 pixel;
    uint tile;
    bool used;
    bool tip;
};

uvec2 corner_of(uint tile) { return uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight); }

uint lonely_in(uint tile) { return imageLoad(lonely, ivec3(corner_of(tile), 0)).x >> kLonelyCount; }

// Pixel of the lens, and how near to it the beam is too narrow to be seen by every few rays; 0: behind the eye.
vec3 tip_of(Light light) {
    vec3 way = light.position_m + light.axis_w * light.lens_m - view.eye_m;
    float depth = dot(way, view.forward);
    vec2 ndc = vec2(dot(way, view.right) / dot(view.right, view.right), dot(way, view.up) / dot(view.up, view.up)) / max(depth, 1e-3);
    vec2 pixel = (vec2(0.5) + vec2(0.5, -0.5) * ndc) * vec2(view.width, view.height) - 0.5;
    return vec3(pixel, depth > 0.0 ? kWideTip * float(p.step) : 0.0);
}

// Fraction of a beam's haze that is drawn pixel by pixel; the rest, which the rays see, has no peak.
float tip_fraction(Light light, vec2 pixel) {
    vec3 tip = tip_of(light);
    return tip.z > 0.0 ? 1.0 - smoothstep(0.5, 1.0, distance(pixel, tip.xy) / tip.z) : 0.0;
}

bool reaches(vec3 tip, uint tile) {
    vec2 low = vec2(corner_of(tile));
    return distance(clamp(tip.xy, low, low + vec2(kTileWidth, kTileHeight) - 1.0), tip.xy) < tip.z;
}

bool has_tip(uint tile) {
    if (kSingle) return reaches(tip_of(lights[p.batch]), tile);
    bool any_tip = false;
    for (uint word = 0u; word < (p.light_count + 31u) / 32u; ++word)
        for (uint mask = mask_of[(p.tiles + p.blocks + tile) * kMaskWords + word]; mask != 0u; mask &= mask - 1u)
            any_tip = any_tip || reaches(tip_of(lights[word * 32u + uint(findLSB(mask))]), tile);
    return any_tip;
}

// A workgroup of wide beams draws so many tiles that every lane has a ray, then, round after round, their lonely pixels, then
// whole tiles where a tip is.
Place wide_place(uint first, uint tiles, uint round, uint tip_round) {
    uint per_tile = kTilePixels / (p.step * p.step);
    uint columns = kTileWidth / p.step;
    uint nth = gl_LocalInvocationIndex / per_tile;
    uint ray = gl_LocalInvocationIndex % per_tile;
    uint tile = list[first + min(nth, tiles - 1u)];
    uvec2 local = uvec2(ray % columns, ray / columns) * p.step;
    bool used = nth < tiles;
    if (round > 0u) {
        uint slot = (round - 1u) * kTilePixels + gl_LocalInvocationIndex;
        used = false;
        for (uint t = 0u; t < tiles; ++t) {
            uint next = list[first + t];
            uint count = lonely_in(next);
            bool here = !used && slot < count;
            tile = here ? next : tile;
            used = used || here;
            slot -= used ? 0u : count;
        }
        slot = used ? slot : 0u;
        uvec2 texel = corner_of(tile) + uvec2(slot % kTileWidth, slot / kTileWidth);
        uint place = imageLoad(lonely, ivec3(texel, 0)).x & kLonelyPlace;
        local = uvec2(place % kTileWidth, place / kTileWidth);
    }
    if (round >= tip_round) {
        uint before = round - tip_round;
        used = false;
        for (uint t = 0u; t < tiles; ++t) {
            uint next = list[first + t];
            bool here = has_tip(next);
            tile = here && !used && before == 0u ? next : tile;
            used = used || (here && before == 0u);
            before -= here && before > 0u ? 1u : 0u;
        }
        local = gl_LocalInvocationID.xy;
    }
    return Place(corner_of(tile) + local, tile, used, round >= tip_round);
}
