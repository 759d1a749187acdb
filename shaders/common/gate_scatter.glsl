// SPDX-License-Identifier: Apache-2.0
// What one light scatters along one camera ray, by segments of its fan (shared/fan.h): the part of the ray inside the beam is cut into
// a few segments, even in the angle seen from the lamp, and each takes its light from the fan's table and its phase and transmittance
// where that light is. Who includes this defines GATE, the GatePush, and has view, lights and fans.

layout(binding = TABLES) uniform sampler2DArray table;
layout(binding = TABLES + 1) uniform sampler2DArray shade; // which rays the light reaches, see fan_shade.comp
layout(binding = TABLES + 2, scalar) uniform AirBlock { Air air; };
// Levels of the table: one, of blur (some light gets out of focus), of places along the beam (shaped ones).
layout(constant_id = 0) const uint kFocus = 1u;
layout(constant_id = 2) const bool kShadows = false;
layout(constant_id = 3) const bool kUneven = false; // haze is not the same everywhere
layout(constant_id = 6) const bool kPanels = false; // pieces of LED walls

#include "common/shade_runs.glsl"

// Of the light that is drawn: its levels are read where they lie, for a copy of a fan in each lane costs as much as a ray.
uint fan_index = 0u;

// Level of a shaped beam at a place t of its way, between two nodes in proportion.
float node_level(float t) {
    float level = 0.0;
    for (uint k = 0u; k + 1u < fans[fan_index].levels; ++k) {
        vec2 node = fans[fan_index].node[k];
        level += clamp((node.x - t) * node.y, 0.0, 1.0);
    }
    return level;
}

// Prefix sums at a place 0..1 of a row -1..1.
vec4 prefix(Fan fan, vec2 texel, uint level, float row, float column) {
    uint place = kFocus == 2u ? fans[fan_index].place[level] : 0u;
    vec2 corner = kFocus == 2u ? vec2(fan_node_corner(place)) : vec2(float(fan_left(fan, level)), 0.0);
    uint side = kFocus == 2u ? fan_node_side(place) : fan_side(fan, level);
    uint columns = kFocus == 2u ? side >> fan.plain : side;
    vec2 at = corner + 0.5 + vec2(column, 0.5 * row + 0.5) * (vec2(float(columns), float(side)) - 1.0);
    return textureLod(table, vec3(at * texel, float(fan.layer)), 0.0);
}

vec4 between(Fan fan, vec2 texel, float level, float row, float from, float to) {
    uint low = uint(level);
    vec4 sharp = prefix(fan, texel, low, row, to) - prefix(fan, texel, low, row, from);
    if (kFocus == 0u) return sharp;
    uint high = min(low + 1u, fan.levels - 1u);
    // A rim out of focus loses light in proportion to its blur at first, and to the octaves of its blur where it is wide: between
    // the two a beam is off by 0.2 % at most, either alone by up to 0.35 %.
    float octaves = level - float(low);
    float fraction = kFocus == 2u ? octaves : mix(octaves, exp2(octaves) - 1.0, 0.6);
    return mix(sharp, prefix(fan, texel, high, row, to) - prefix(fan, texel, high, row, from), fraction);
}

// A camera ray in the plane of its row: what its ways and angles are made of, rational in u.
struct Ray {
    float eye_m;      // from lamp to eye
    float distance_m; // from lamp to ray
    vec2 across;      // part of the direction of u across the ray: x + u y
    vec2 along;       // and along it
    vec2 up;          // and across the pole
    float lens_m;     // from lamp to lens, where there is no haze, in directions of u that are not made unit
    float panel_m;    // Light::panel_m
};

const float kGauss = 0.57735; // between the two points of Gauss, in segments
const float kHalfOfGauss = 0.5 / kGauss;

// From the eye to where the ray meets direction u.
float ray_way_m(Ray ray, float u) {
    return ray.eye_m * (ray.up.x + u * ray.up.y) / max(ray.across.x + u * ray.across.y, 1e-6);
}

// Phase and transmittance of light that leaves the lamp in direction u.
float ray_weight(Haze haze, Ray ray, float u) {
    float unit = inversesqrt(1.0 + u * u);
    float per_across = 1.0 / max(ray.across.x + u * ray.across.y, 1e-6);
    float to_lamp_m = ray.distance_m * per_across / unit;
    float to_lens_m = max(ray.distance_m * per_across - ray.lens_m, 0.0) / unit;
    float to_eye_m = ray.eye_m * (ray.up.x + u * ray.up.y) * per_across;
    float narrow = kPanels ? to_lamp_m / length(vec2(to_lamp_m, ray.panel_m)) : 1.0;
    return haze_transmittance(haze, to_lens_m + to_eye_m) * haze_phase(haze, -(ray.along.x + u * ray.along.y) * unit, narrow) *
           attenuation_factor(air.attenuation, to_lamp_m);
}

// Pieces of LED walls (near_fraction): what is even for the inverse square law along a ray, its angle, is for them the angle of a ray that
// passes farther away, as far as the ray and the piece's radius make in quadrature. nearer: the quotient of the two ways.
float panel_angle(Ray ray, float nearer, float u) {
    return atan(nearer * (ray.along.x + u * ray.along.y), ray.across.x + u * ray.across.y);
}

vec2 direction_of(float angle) { return vec2(cos(angle), sin(angle)); }

vec2 turned_by(vec2 direction, vec2 by) { return vec2(direction.x * by.x - direction.y * by.y, direction.y * by.x + direction.x * by.y); }

// Of the direction of an angle.
float panel_tangent(Ray ray, float nearer, vec2 direction) {
    vec2 part = vec2(direction.y, nearer * direction.x);
    return (part.x * ray.across.x - part.y * ray.along.x) / max(part.y * ray.along.y - part.x * ray.across.y, 1e-9);
}

// Mean of near_fraction over the ray's own angle, in a segment. As an arc tangent of a difference: segments may be very short.
float near_mean(Ray ray, float nearer, float angle, float u, float step_u) {
    vec2 ends = vec2(u, u + step_u);
    vec2 across = ray.across.x + ends * ray.across.y, along = ray.along.x + ends * ray.along.y;
    float turn = step_u * (ray.along.y * ray.across.x - ray.along.x * ray.across.y);
    return nearer * angle / max(atan(turn, across.x * across.y + along.x * along.y), 1e-9);
}

// What all segments of a ray that ends at `far` see, but for what ray_scale knows.
vec3 gathered(Light light, Fan fan, vec3 dir, float far) {
    Haze haze = view.haze;
    vec2 texel = 1.0 / vec2(textureSize(table, 0).xy);
    // The plane of the ray: the pole is along x, the ray's own direction is (cos_end, sin_end).
    vec2 aside = vec2(dot(dir, fan.beam.along), dot(dir, fan.beam.across));
    float cos_end = dot(dir, fan.beam.pole);
    // A ray through the lamp itself has no plane: the nearest one that has.
    float sin_end = max(length(aside), kLeastSine);
    vec2 meridian = aside / sin_end;
    float row = fan_row(fan.beam, meridian.x, meridian.y);
    vec4 chord = fan_chord(fan.beam, meridian);
    vec4 tangent = fan_tangent(fan.beam, chord, vec2(cos_end, sin_end));
    float distance_m = fan.beam.eye_m * sin_end;

    // Nothing shines before the lens.
    float eye_z = fan.beam.eye_m * fan.beam.cos_axis;
    float fall = dot(dir, light.axis_w);
    fall = abs(fall) < 1e-6 ? 1e-6 : fall;
    float lens_t = (light.lens_m - eye_z) / fall;
    float t0 = fall > 0.0 ? max(lens_t, 0.0) : 0.0;
    float t1 = fall > 0.0 ? far : min(far, lens_t);
    float u0 = max(fan_tangent_at(tangent, t0), -chord.w);
    float u1 = min((tangent.x + t1 * tangent.y) / max(tangent.z + t1 * tangent.w, 1e-6), chord.w);
    bool hit = u1 > u0 && t1 > t0 && abs(row) <= 1.0;

    // Along the row the way to the eye and the distance from the lamp are rational in u. The direction of u is
    // (chord.x - u chord.y, chord.y + u chord.x), sqrt(1 + u^2) long; this is its part across the ray.
    float across = tangent.y, across_u = -tangent.w;
    float along = tangent.w, along_u = tangent.y;

    Ray ray = Ray(fan.beam.eye_m, distance_m, vec2(across, across_u), vec2(along, along_u), chord.yx, light.lens_m / max(chord.z, 1e-6), light.panel_m);

    // As many segments as the curvature of the phase function (sharpest where the light comes at the eye) and the haze on the
    // way ask for.
    float length0 = sqrt(1.0 + u0 * u0), length1 = sqrt(1.0 + u1 * u1);
    float way0 = (distance_m * length0 + fan.beam.eye_m * (chord.y + u0 * chord.x)) / max(across + u0 * across_u, 1e-6);
    float way1 = (distance_m * length1 + fan.beam.eye_m * (chord.y + u1 * chord.x)) / max(across + u1 * across_u, 1e-6);
    float g = haze.forward_g;
    float ahead = (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 + (along + u0 * along_u) / length0);
    float depth = haze.extinction_per_m * (way1 - way0);
    float angle = (u1 - u0) / (length0 * length1);
    float wanted = sqrt(angle * angle * (2.0 + 3.0 * g / ahead) + 8.0 * depth * depth) * GATE.segments_per_rad;
    // Swirls are resolved, too: their waves are shorter than the swirls are wide.
    if (kUneven) wanted = max(wanted, abs(way1 - way0 - distance_m * (length1 / max(across + u1 * across_u, 1e-6) - length0 / max(across + u0 * across_u, 1e-6))) * air.per_m * 1.6);
    // What a panel throws along itself is not even in a segment: from the wings it is 8 % too bright with so many, 1.5 % with twice.
    if (kPanels) wanted *= 2.0;
    uint count = hit ? clamp(uint(ceil(wanted)), 1u, GATE.most_segments) : 0u;

    float nearer = kPanels ? distance_m / length(vec2(distance_m, light.panel_m)) : 1.0;
    float scale = 0.5 / max(chord.w, 1e-9);
    float segments_per_u = float(count) / max(u1 - u0, 1e-9);
    // What a segment takes from the table is at least this wide: a texel and a half.
    float narrowest = 1.5 / float((kFocus == 2u ? fan.size >> fan.plain : fan.size) - 1u);

    // The ray is cut into runs that are lit, and each run into segments.
    ShadeRay shaded;
    int first = 0, last = 0;
    bool open = true;
    if (kShadows) {
        shaded = shade_ray(fan, dir);
        first = shade_column(shaded, fan_tangent_at(shaded.tangent, ray_way_m(ray, u0)));
        // At the surface that ends the ray the map is too coarse to tell before from behind.
        last = max(shade_column(shaded, fan_tangent_at(shaded.tangent, ray_way_m(ray, u1)) - GATE.shade_rad), first);
        vec2 edge = shade_between(shaded, first, last);
        open = shaded.cosine < edge.x;
        last = shaded.cosine >= edge.y ? first - 1 : last;
    }
    last = hit ? last + 1 : first;
    int column = first;
    vec3 sum = vec3(0.0);
    while (column < last) {
        Runs runs = Runs(uvec4(0u), 0u);
        if (open) add_turn(runs, column);
        column = kShadows ? find_runs(shaded, open ? last : column, last, runs) : last;
        uint turn = 0u, segments = 0u;
        float from = 0.0, step_u = 0.0;
        float step_angle = 0.0; // of panels, and directions: where a segment begins, by how much its end and its two points are turned
        vec2 begin = vec2(1.0, 0.0), to_end = begin, to_u = begin, to_v = begin;
        while (segments > 0u || turn < runs.count) {
            if (segments == 0u) {
                bool ends = turn + 1u < runs.count;
                int start = turn_at(runs, turn);
                from = start > first ? clamp(fan_tangent_of(tangent, shaded.tangent, shade_tangent(shaded, start)), u0, u1) : u0;
                float to = ends ? clamp(fan_tangent_of(tangent, shaded.tangent, shade_tangent(shaded, turn_at(runs, turn + 1u))), u0, u1) : u1;
                segments = max(uint(ceil((to - from) * segments_per_u - 1e-3)), 1u);
                step_u = max(to - from, 0.0) / float(segments);
                turn += 2u;
                if (kPanels) {
                    float angle = panel_angle(ray, nearer, from);
                    step_angle = max(panel_angle(ray, nearer, to) - angle, 0.0) / float(segments);
                    begin = direction_of(angle);
                    to_end = direction_of(step_angle);
                    to_u = direction_of((0.5 - 0.5 * kGauss) * step_angle);
                    to_v = direction_of((0.5 + 0.5 * kGauss) * step_angle);
                }
            }
            if (kPanels) step_u = max(clamp(panel_tangent(ray, nearer, turned_by(begin, to_end)), u0, u1) - from, 0.0);
            float middle = from + 0.5 * step_u;
            float level = 0.0;
            if (kFocus > 0u) {
                float z = distance_m * chord.z / max(across + middle * across_u, 1e-6);
                if (kFocus == 2u)
                    level = node_level(1.0 - beam_focus(light, z).away);
                else
                    level = clamp(log2(beam_blur(light, z) / fan.sharpest), 0.0, float(fan.levels - 1u));
            }
            float fraction = step_u * scale;
            float grow = max(0.5 * (narrowest - fraction), 0.0);
            float c0 = clamp(0.5 + from * scale - grow, 0.0, 1.0);
            float c1 = clamp(0.5 + from * scale + fraction + grow, 0.0, 1.0);
            vec4 light_here = between(fan, texel, level, row, c0, c1) * (fraction / max(c1 - c0, 1e-9));
            // Phase and transmittance where the light of this segment is.
            float brightness = luminance_of(light_here.rgb);
            float centre = brightness > 1e-7 ? (light_here.a / brightness - 0.5) / scale : middle;
            // Two points, as Gauss has them for even light: exact for weights up to the third power of u.
            float u = clamp(centre - 0.5 * kGauss * step_u, from, from + step_u);
            float v = clamp(centre + 0.5 * kGauss * step_u, from, from + step_u);
            if (kPanels) {
                u = clamp(panel_tangent(ray, nearer, turned_by(begin, to_u)), from, from + step_u);
                v = clamp(panel_tangent(ray, nearer, turned_by(begin, to_v)), from, from + step_u);
                light_here *= near_mean(ray, nearer, step_angle, from, step_u);
                begin = turned_by(begin, to_end);
            }
            float weight_u = ray_weight(haze, ray, u), weight_v = ray_weight(haze, ray, v);
            if (kUneven) {
                // Each stands for half of the segment's way, over which the haze is averaged.
                float way_u = ray_way_m(ray, u), way_v = ray_way_m(ray, v);
                float span_m = kHalfOfGauss * abs(way_v - way_u);
                weight_u *= air_density_along(air, view.eye_m + dir * way_u, dir, span_m);
                weight_v *= air_density_along(air, view.eye_m + dir * way_v, dir, span_m);
            }
            float seen = 0.5 * (weight_u + weight_v);
            sum += light_here.rgb * seen;
            from += step_u;
            --segments;
        }
    }
    return sum;
}

// half_chord: tangent, of the ray's plane; sine: of the angle between ray and pole.
vec3 ray_scale(Light light, Fan fan, float half_chord, float sine) {
    return light.intensity_cd * (view.haze.scattering_per_m * 2.0 * half_chord * fan.most / (fan.beam.eye_m * sine));
}

vec3 scattered(Light light, Fan fan, vec3 dir, float far) {
    vec2 aside = vec2(dot(dir, fan.beam.along), dot(dir, fan.beam.across));
    float sine = max(length(aside), kLeastSine);
    return gathered(light, fan, dir, far) * ray_scale(light, fan, fan_chord(fan.beam, aside / sine).w, sine);
}
