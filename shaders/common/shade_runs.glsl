// SPDX-License-Identifier: Apache-2.0
// Where a ray runs through light and where through shadow, from what fan_shade.comp wrote. Who includes this has it bound as
// `sampler2DArray shade`, and shared/fan.h.

// A camera ray in its plane with the place of the light's distance map.
struct ShadeRay {
    vec4 tangent;     // of its points, see fan_tangent
    float cosine;     // of its angle from the pole
    float half_width; // of the row, tangent
    float bend;       // of its columns
    int row;
    int layer;
    int side;
};

ShadeRay shade_ray(Fan fan, vec3 dir) {
    vec2 aside = vec2(dot(dir, fan.shade.along), dot(dir, fan.shade.across));
    float cosine = dot(dir, fan.shade.pole);
    float sine = max(length(aside), kLeastSine);
    vec2 meridian = aside / sine;
    vec4 chord = fan_chord(fan.shade, meridian);
    int side = int(fan_shade_side(fan)), rows = int(fan_shade_rows(fan));
    float row = fan_bent(clamp(fan_row(fan.shade, meridian.x, meridian.y), -1.0, 1.0), fan.row_bend);
    return ShadeRay(fan_tangent(fan.shade, chord, vec2(cosine, sine)), cosine, max(chord.w, 1e-6), fan.column_bend,
                    clamp(int((0.5 * row + 0.5) * float(rows)), 0, rows - 1), int(fan.layer), side);
}

// Column of a tangent.
int shade_column(ShadeRay ray, float u) {
    float place = fan_bent(clamp(u / ray.half_width, -1.0, 1.0), ray.bend);
    return clamp(int((0.5 * place + 0.5) * float(ray.side)), 0, ray.side - 1);
}

// Tangent of where a column begins.
float shade_tangent(ShadeRay ray, int column) {
    return ray.half_width * fan_straight(2.0 * float(column) / float(ray.side) - 1.0, ray.bend);
}

// Least and most of the shade between two columns.
vec2 shade_between(ShadeRay ray, int from, int to) {
    int level = findMSB(max(to - from, 1)) + (to - from > 1 ? 1 : 0);
    level = min(level, findMSB(ray.side));
    int left = 2 * (ray.side - (ray.side >> level));
    vec2 a = texelFetch(shade, ivec3(ray.row, left + (from >> level), ray.layer), 0).xy;
    vec2 b = texelFetch(shade, ivec3(ray.row, left + (to >> level), ray.layer), 0).xy;
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
int find_runs(ShadeRay ray, int at, int end, inout Runs runs) {
    int level = kFirstLevel;
    bool lit = false;
    while (at < end && runs.count < kMostTurns) {
        vec2 edge = texelFetch(shade, ivec3(ray.row, 2 * (ray.side - (ray.side >> level)) + (at >> level), ray.layer), 0).xy;
        bool all_lit = ray.cosine < edge.x;
        bool whole = all_lit || ray.cosine >= edge.y;
        if (whole && all_lit != lit) {
            add_turn(runs, at);
            lit = all_lit;
        }
        at = whole ? ((at >> level) + 1) << level : at;
        level += whole ? 1 - ((at >> level) & 1) : -1;
    }
    return at;
}
