#version 460
// SPDX-License-Identifier: Apache-2.0
// What may throw soft shadows, and the farthest distances, of a square of a distance map: render/haze/blockers.cpp and
// render/geometry/beam_reach.cpp, of the same texels the same numbers. A workgroup makes a square: its cells of 4 texels, then
// those of 8 from four of them each, and so on.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/blockers.h"
#include "shared/map_draw.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2DArray texels;
layout(binding = 1, scalar) readonly buffer Squares { MapSquare squares[]; };
layout(binding = 2, scalar) writeonly buffer Farthest { uint farthest[]; };
layout(binding = 3) uniform writeonly image2DArray cells_4;
layout(binding = 4) uniform writeonly image2DArray cells_8;
layout(binding = 5) uniform writeonly image2DArray cells_16;
layout(binding = 6) uniform writeonly image2DArray cells_32;
layout(binding = 7) uniform writeonly image2DArray cells_64;
layout(push_constant, scalar) uniform Push { MapSquaresPush p; };

const uint kAcross = kMapSquare / 4u; // cells of 4 texels
// The bits of half floats above zero are in their order, and about their logarithm: 1024 to the octave.
const int kGap = 140; // groups are a tenth apart at least

// One or two groups of texels: bits of half floats, and how many texels the nearer one has.
struct Cell {
    int near_from, near_to, far_from, far_to;
    uint near_count;
};
shared uvec3 kept[kAcross * kAcross];

uvec3 packed_cell(Cell cell) {
    return uvec3(uint(cell.near_from) | uint(cell.near_to) << 16, uint(cell.far_from) | uint(cell.far_to) << 16, cell.near_count);
}
Cell unpacked_cell(uvec3 bits) {
    return Cell(int(bits.x & 0xffffu), int(bits.x >> 16), int(bits.y & 0xffffu), int(bits.y >> 16), bits.z);
}

Cell cell_of(ivec2 corner, int map) {
    int value[16];
    int least = 0xffff, most = 0;
    for (int k = 0; k < 16; ++k) {
        value[k] = int(packHalf2x16(vec2(texelFetch(texels, ivec3(corner + ivec2(k & 3, k >> 2), map), 0).x, 0.0)) & 0xffffu);
        least = min(least, value[k]);
        most = max(most, value[k]);
    }
    if (most - least < kGap) return Cell(least, most, 0, 0, 16u);
    // The widest gap above any of them, and of equal ones the nearest.
    int widest = kGap - 1, near_to = most, far_from = 0;
    for (int k = 0; k < 16; ++k) {
        int above = 0x10000;
        for (int other = 0; other < 16; ++other)
            if (value[other] > value[k]) above = min(above, value[other]);
        int gap = above - value[k];
        bool wider = above < 0x10000 && (gap > widest || (gap == widest && far_from != 0 && value[k] < near_to));
        widest = wider ? gap : widest;
        near_to = wider ? value[k] : near_to;
        far_from = wider ? above : far_from;
    }
    uint near_count = 0u;
    for (int k = 0; k < 16; ++k) near_count += value[k] <= near_to ? 1u : 0u;
    return Cell(least, near_to, far_from, near_count < 16u ? most : 0, near_count);
}

// texels_of: that a part has.
Cell merged(Cell part[4], uint texels_of) {
    int from[8], to[8];
    uint count[8];
    int least = 0xffff, most = 0;
    for (int k = 0; k < 4; ++k) {
        from[2 * k] = part[k].near_from;
        to[2 * k] = part[k].near_to;
        count[2 * k] = part[k].near_count;
        from[2 * k + 1] = part[k].far_from;
        to[2 * k + 1] = part[k].far_to;
        count[2 * k + 1] = texels_of - part[k].near_count;
    }
    for (int k = 0; k < 8; ++k) {
        if (count[k] == 0u) continue;
        least = min(least, from[k]);
        most = max(most, to[k]);
    }
    int widest = kGap - 1, split = 0x10000;
    for (int k = 0; k < 8; ++k) {
        int before = -1;
        for (int other = 0; other < 8; ++other)
            if (count[other] > 0u && from[other] < from[k]) before = max(before, to[other]);
        if (count[k] == 0u || before < 0) continue;
        int gap = from[k] - before;
        bool wider = gap > widest || (gap == widest && split < 0x10000 && from[k] < split);
        widest = wider ? gap : widest;
        split = wider ? from[k] : split;
    }
    Cell cell = Cell(least, 0, split < 0x10000 ? split : 0, 0, 0u);
    for (int k = 0; k < 8; ++k) {
        if (count[k] == 0u) continue;
        if (from[k] < split) {
            cell.near_to = max(cell.near_to, to[k]);
            cell.near_count += count[k];
        } else {
            cell.far_to = max(cell.far_to, to[k]);
        }
    }
    return cell;
}

float metres(int bits) {
    return max(unpackHalf2x16(uint(bits)).x, 1e-3);
}

void store(Cell cell, uint texels_of, ivec3 at, uint level) {
    bool one = cell.near_count == texels_of;
    int far_to = one ? cell.near_to : cell.far_to;
    float steps = kFromSteps;
    if (!one && cell.far_from < far_to) {
        float start = 1.0 / metres(cell.near_to), end = 1.0 / metres(far_to);
        // Rather too near than too far.
        steps = floor(steps * (start - 1.0 / metres(cell.far_from)) / max(start - end, 1e-9));
    }
    // No group is lost.
    float fraction = float(cell.near_count) / float(texels_of);
    float fraction_steps = one ? kFractionSteps : clamp(floor(kFractionSteps * fraction + 0.5), 1.0, kFractionSteps - 1.0);
    vec4 value = vec4(unpackHalf2x16(uint(cell.near_from)).x, unpackHalf2x16(uint(cell.near_to)).x,
                      pack_parts(fraction_steps, clamp(steps, 0.0, kFromSteps)), unpackHalf2x16(uint(far_to)).x);
    if (level == 0u) imageStore(cells_4, at, value);
    if (level == 1u) imageStore(cells_8, at, value);
    if (level == 2u) imageStore(cells_16, at, value);
    if (level == 3u) imageStore(cells_32, at, value);
    if (level == 4u) imageStore(cells_64, at, value);
}

void main() {
    MapSquare square = squares[p.first + gl_WorkGroupID.x];
    uint own = gl_LocalInvocationIndex;
    uint across = kAcross;
    uint texels_of = 16u;
    for (uint level = 0u; level <= max(p.levels - 1u, p.farthest_level); ++level) {
        uvec2 place = uvec2(own % across, own / across);
        bool has = own < across * across;
        Cell cell = Cell(0, 0, 0, 0, 0u);
        if (level == 0u) {
            cell = cell_of(ivec2(square.x + 4u * place.x, square.y + 4u * place.y), int(square.map));
        } else {
            if (has) {
                uint first = 2u * (place.y * 2u * across + place.x);
                Cell part[4];
                for (uint k = 0u; k < 4u; ++k) part[k] = unpacked_cell(kept[first + (k & 1u) + (k >> 1) * 2u * across]);
                cell = merged(part, texels_of / 4u);
            }
            barrier(); // all have read
        }
        if (has) {
            kept[own] = packed_cell(cell);
            if (level < p.levels)
                store(cell, texels_of, ivec3((uvec2(square.x, square.y) / 4u >> level) + place, square.map), level);
            if (level == p.farthest_level) farthest[square.farthest + own] = uint(max(cell.near_to, cell.far_to));
        }
        barrier();
        across /= 2u;
        texels_of *= 4u;
    }
}
