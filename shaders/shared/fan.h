// SPDX-License-Identifier: Apache-2.0
#ifndef GHOST_SHARED_FAN_H
#define GHOST_SHARED_FAN_H
#include "shared/types.h"

// The fan of a light: all planes through the lamp and the eye. Every camera ray lies in one of them, and so do all directions
// from the lamp to the points of that ray: one meridian of the sphere round the lamp whose pole points at the eye. That
// meridian cuts the gate in a straight line. So all that a light sends into haze is known, for every ray of a picture, from
// one table: a row is a meridian, a column a place along its line in the gate. With psi the angle from the pole
//
//     L = sigma_s / D * integral of I(row, psi) phase transmittance dpsi        (equi-angular: dt / r^2 = dpsi / D)
//
// where D is the distance of the ray from the lamp (the apex of its beam). The table holds prefix sums of I dpsi along the columns,
// so that a segment of any length costs two fetches, and their first moment, so that a segment knows where its light is. After
// Kulla & Fajardo 2012 (equi-angular variable), Pegoraro 2009 (angular airlight), Baran et al. 2010 (prefix sums in rectified
// coordinates). What is in the way is seen from the middle of the lens, not from the apex behind it: it has a fan of its own.

SHARED_BEGIN

// All planes through a place and the eye, and of each the directions within a cone about the beam's axis. pole, along, across:
// unit, orthogonal, right-handed, in the world; the axis lies in the plane of pole and along.
struct Planes {
    vec3 pole;       // from the place to the eye
    float eye_m;     // distance of the two
    vec3 along;
    float cos_axis;  // of the angle between pole and axis
    vec3 across;
    float sin_axis;
    float cos_cone;  // of the angle between the axis and the cone's rim
    float sin_cone;
    float row_scale; // > 0: rows are even in the sine of the meridian, times this; < 0: the rim is near the pole or surrounds it (or
                     // the point opposite), rows are even in the meridian's angle, times minus this, in the half where the axis is
};
SHARED_SIZE(Planes, 60);

// Places the fan of one light for one eye.
struct Fan {
    Planes beam;     // through the beam's apex; the cone is the beam
    Planes shade;    // through the place of the light's distance map; the cone is wide enough for the beam's beginning at the lens
    float row_bend;  // of the shade, see fan_bent
    float column_bend;
    uint layer;      // of the table
    uint size;       // rows and columns of the sharpest level
    float sharpest;  // blur (gate units) of level 0; level n has twice that to the nth
    uint levels;     // of blur: 1 where nothing gets out of focus
    uint halvings;   // levels that are half of the one before
    vec2 node[14];   // of a shaped beam, whose planes are not blurred alike: falling t (shared/optics.h) of each level, and
                     // 1 / what it falls to the next
    uint place[14];  // and where in its layer it lies, see fan_placed
    float most;      // fraction that the table holds as 1
    uint thin;       // 1: may be thinner than a pixel, and rows are even in the sine
    uint plain;      // 1: of a shaped beam: levels have half as many columns as rows, and gobos whole levels of blur
    uint coarse_shade; // the shade has so many times half as many rows and columns
};
SHARED_SIZE(Fan, 332);

SHARED_CONST float kLeastSine = 1e-4f; // between a ray and the pole
SHARED_CONST uint kFanLevels = 8u;
SHARED_CONST uint kFanNodes = 14u;    // levels of a shaped beam
SHARED_CONST uint kFinestNode = 128u; // rows and columns of these, at most
SHARED_CONST uint kNodeStep = 16u;    // they are multiples of it
SHARED_CONST uint kLeastFan = 32u;    // rows and columns of any level
SHARED_CONST uint kLeastSharp = 64u;  // and of the sharpest one
SHARED_CONST uint kEvenLevels = 2u;   // that are as large as the smallest sharp one
SHARED_CONST uint kMiddleFan = 160u;  // its texels are as wide as the blur of a gobo's second level
SHARED_CONST uint kFinestFan = 256u;
SHARED_CONST uint kFinestShade = 256u; // columns of what is in the way; twice as many rows
SHARED_CONST uint kFanWidth = 7u * kFinestNode; // of a layer: all levels, those of a shaped beam in two lines

// An angle -1..1 for the half turns from -pi to pi, evenly along a square instead of a circle, which needs no arc tangent.
SHARED_FN float fan_turn(float cosine, float sine) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float turn = 0.5f - 0.5f * cosine / max(abs(cosine) + abs(sine), 1e-9f);
    return sine < 0.0f ? -turn : turn;
}

// Row coordinate -1..1 of a meridian given by its cosine and sine; beyond: the plane misses the cone.
SHARED_FN float fan_row(Planes planes, float cosine, float sine) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float line = cosine > 0.0f ? sine * planes.row_scale : 2.0f;
    float turn = fan_turn(cosine, sine);
    float behind = max(abs(turn) - 0.5f, 0.0f) * (2.0f + 2.0f * planes.row_scale);
    float round = -planes.row_scale * abs(turn) + behind;
    return planes.row_scale > 0.0f ? line : (turn < 0.0f ? -round : round);
}

// Cosine and sine of the meridian of a row coordinate.
SHARED_FN vec2 fan_meridian(Planes planes, float row) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float line_sine = row / max(planes.row_scale, 1.0f);
    vec2 line = vec2(sqrt(max(1.0f - line_sine * line_sine, 0.0f)), line_sine);
    float slope = max(-planes.row_scale, 1.0f);
    float behind = max(abs(row) - 0.5f * slope, 0.0f) / max(2.0f - slope, 1e-3f);
    float x = 1.0f - 2.0f * (min(abs(row) / slope, 0.5f) + behind);
    vec2 square = vec2(x, (1.0f - abs(x)) * (row < 0.0f ? -1.0f : 1.0f));
    vec2 turn = square / length(square);
    return planes.row_scale > 0.0f ? line : turn;
}

// Where a meridian (its cosine and sine) runs through the cone, in its plane with the pole along x. xy: unit, where it is nearest
// to the axis; z: how near (cosine of that angle); w: tangent of half the chord, seen from xy; 0 where it misses. A direction is
// given by the tangent u of its angle from xy: its place in the row is 0.5 + 0.5 u / w.
SHARED_FN vec4 fan_chord(Planes planes, vec2 meridian) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float side = planes.sin_axis * meridian.x;
    float reach = max(sqrt(planes.cos_axis * planes.cos_axis + side * side), 1e-6f);
    // By sines: the cosines of a beam of half a degree differ by little more than their rounding.
    float aside = planes.sin_axis * abs(meridian.y);
    float half_chord = sqrt(max((planes.sin_cone - aside) * (planes.sin_cone + aside), 0.0f)) / planes.cos_cone;
    return vec4(planes.cos_axis / reach, side / reach, reach, half_chord);
}

// Rows and columns of a level: half of the level before, kLeastSharp until its blur is four times as wide as these, then kLeastFan.
SHARED_FN uint fan_side(Fan fan, uint level) {
    return level <= fan.halvings ? fan.size >> level : (level <= fan.halvings + kEvenLevels ? kLeastSharp : kLeastFan);
}

// The levels stand side by side in their layer: columns (and rows) of all levels before this one.
SHARED_FN uint fan_left(Fan fan, uint level) {
    uint halved = 2u * fan.size - 2u * (fan.size >> level);
    uint even = 2u * fan.size - (fan.size >> fan.halvings);
    uint beyond = level <= fan.halvings ? 0u : level - fan.halvings - 1u;
    uint sharp = beyond < kEvenLevels ? beyond : kEvenLevels;
    return level <= fan.halvings ? halved : even + sharp * kLeastSharp + (beyond - sharp) * kLeastFan;
}

// Where a level of a shaped beam lies: its corner, and its rows and columns.
SHARED_FN uint fan_placed(uint x, uint y, uint side) { return x | y << 10u | side << 20u; }
SHARED_FN uvec2 fan_node_corner(uint place) { return uvec2(place & 1023u, place >> 10u & 1023u); }
SHARED_FN uint fan_node_side(uint place) { return place >> 20u; }

// Most of the shade's rows and columns lie where the beam is far from its lens: -1..1 to -1..1, 1 + bend times as steep in the middle.
SHARED_FN float fan_bent(float even, float bend) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return even * (1.0f + bend) / (1.0f + bend * abs(even));
}

SHARED_FN float fan_straight(float bent, float bend) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return bent / (1.0f + bend - bend * abs(bent));
}

// Columns of the finest level of what is in the light's way: about a texel of a distance map of 1024 in the middle. Its
// levels stand side by side, too, each half as many columns.
SHARED_FN uint fan_shade_side(Fan fan) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float width = 2.0f * fan.shade.sin_cone / max(fan.shade.cos_cone, 1e-3f);
    uint texels = uint(clamp(width / ((1.0f + fan.column_bend) * 0.0035f), float(kLeastSharp / 2u), float(kFinestShade / 2u)));
    // An eye within the cone sees rows from end to end.
    return (fan.shade.row_scale < 0.0f ? kFinestShade : 2u << uint(findMSB(texels))) >> fan.coarse_shade;
}

// Twice as many rows: along one the end of a shadow is told to a column, from one to the next nothing is.
SHARED_FN uint fan_shade_rows(Fan fan) { return 2u * fan_shade_side(fan); }

// Where a ray of a plane of the map is, seen from the eye: the cosine of its angle from the pole. The light of a direction whose
// first surface is at distance_m reaches the rays below this. direction: unit, pole along x.
SHARED_FN float fan_shade(Fan fan, vec2 direction, float distance_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec2 from_eye = vec2(direction.x * distance_m - fan.shade.eye_m, direction.y * distance_m);
    return from_eye.x / sqrt(max(dot(from_eye, from_eye), 1e-18f));
}

// A camera ray in its plane with a place, the pole along x: a point t_m from the eye is in the direction whose tangent is
// (of.x + t_m of.y) / (of.z + t_m of.w), see fan_chord; ahead of the place where the divisor is above 0. ray: unit, in the plane.
SHARED_FN vec4 fan_tangent(Planes planes, vec4 chord, vec2 ray) {
    return vec4(-planes.eye_m * chord.y, ray.y * chord.x - ray.x * chord.y, planes.eye_m * chord.x,
                ray.x * chord.x + ray.y * chord.y);
}

// Tangent of the direction t_m from the eye; beyond a right angle, on either side, of one so near to it that nothing is there.
SHARED_FN float fan_tangent_at(vec4 of, float t_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float aside = of.x + t_m * of.y;
    float ahead = of.z + t_m * of.w;
    return ahead > 1e-6f ? aside / ahead : (aside < 0.0f ? -1e9f : 1e9f);
}

// The same point's tangent in the plane `to`, from its tangent in the plane `from`, of one ray.
SHARED_FN float fan_tangent_of(vec4 to, vec4 from, float u) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec2 way = vec2(u * from.z - from.x, from.y - u * from.w); // t_m is the quotient
    return (to.x * way.y + to.y * way.x) / max(to.z * way.y + to.w * way.x, 1e-6f);
}

SHARED_END
#endif
