// SPDX-License-Identifier: Apache-2.0
// Where a ray runs through light and where through shadow, from what fan_shade.comp wrote. Who includes this has it bound as
// `sampler2DArray shade`.

// Least and most of the shade between two columns, of a row of so many.
vec2 shade_between(int row, int layer, int side, int from, int to) {
    int level = findMSB(max(to - from, 1)) + (to - from > 1 ? 1 : 0);
    level = min(level, findMSB(side));
    int left = 2 * (side - (side >> level));
    vec2 a = texelFetch(shade, ivec3(row, left + (from >> level), layer), 0).xy;
    vec2 b = texelFetch(shade, ivec3(row, left + (to >> level), layer), 0).xy;
    return vec2(min(a.x, b.x), max(a.y, b.y));
}

// Columns where the ray goes from dark to lit, to dark, to lit .., eight bits each.
struct Runs {
    uvec4 turns;
    uint count;
};
const uint kMostTurns = 16u;
const int kFirstLevel = 3; // of the groups of columns looked at

void add_turn(inout Runs runs, int column) {
    uint bits = uint(column) << (8u * (runs.count & 3u));
    uint word = runs.count >> 2;
    runs.turns |= uvec4(word == 0u ? bits : 0u, word == 1u ? bits : 0u, word == 2u ? bits : 0u, word == 3u ? bits : 0u);
    ++runs.count;
}

int turn_at(Runs runs, uint index) {
    uint word = index >> 2;
    uvec2 half_turns = word < 2u ? runs.turns.xy : runs.turns.zw;
    return int((((word & 1u) == 0u ? half_turns.x : half_turns.y) >> (8u * (index & 3u))) & 255u);
}

// Finds the turns from `at` on, whole groups of columns at a time. Returns where it stopped: at `end`, or in the dark because there
// is no room for more.
int find_runs(int row, int layer, int side, float ray, int at, int end, inout Runs runs) {
    int level = kFirstLevel;
    bool lit = false;
    while (at < end && runs.count < kMostTurns) {
        vec2 edge = texelFetch(shade, ivec3(row, 2 * (side - (side >> level)) + (at >> level), layer), 0).xy;
        bool all_lit = ray < edge.x;
        bool whole = all_lit || ray >= edge.y;
        if (whole && all_lit != lit) {
            add_turn(runs, at);
            lit = all_lit;
        }
        at = whole ? ((at >> level) + 1) << level : at;
        level += whole ? 1 - ((at >> level) & 1) : -1;
    }
    return at;
}
