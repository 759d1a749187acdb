// SPDX-License-Identifier: Apache-2.0
#ifndef GHOST_SHARED_FAN_H
#define GHOST_SHARED_FAN_H
#include "shared/types.h"

// The fan of a light: all planes through the lamp and the eye. Every camera ray lies in one of them, and so do all directions
// from the lamp to the points of that ray. In spherical coordinates round the lamp whose pole points at the eye, a ray is a
// meridian (its plane, the fan's row) and an interval of polar angles psi (its column). So all that a light sends into haze
// is known, for every ray of a picture, from one table of rows x columns:
//
//     L = sigma_s / D * integral over psi of I(row, psi) phase transmittance dpsi        (equi-angular: dt / r^2 = dpsi / D)
//
// with D the distance of the ray from the lamp. The table holds prefix sums of I along the columns, so that a segment of any
// length costs two fetches, and their first moment, so that a segment knows where its light is. After Kulla & Fajardo 2012
// (equi-angular variable), Pegoraro 2009 (angular formulation of airlight), Baran et al. 2010 (rectified prefix sums).

SHARED_BEGIN

// Places the fan of one light for one eye. pole, along, across: unit, orthogonal, right-handed, in the world; the axis of
// the beam lies in the plane of pole and along.
struct Fan {
    vec3 pole;       // from the lamp to the eye
    float eye_m;     // distance of the two
    vec3 along;
    float cos_axis;  // of the angle between pole and beam axis
    vec3 across;
    float sin_axis;
    float cos_cone;  // of the angle between the beam's axis and its rim
    float row_scale; // > 0: rows are even in the sine of the meridian, times this; 0: the rim surrounds the pole (or the point
                     // opposite), rows are even in the meridian's angle
    uint layer;      // of the table
    uint size;       // rows and columns of the sharpest level
    float sharpest;  // blur (gate units) of level 0; level n has twice that to the nth
    uint levels;     // of blur: 1 where nothing gets out of focus
    uint halvings;   // levels that are half of the one before
};
SHARED_SIZE(Fan, 76);

SHARED_CONST uint kFanLevels = 8u;
SHARED_CONST uint kLeastFan = 64u;  // rows and columns of any level
SHARED_CONST uint kFinestFan = 256u;
SHARED_CONST uint kShadeRows = 256u; // how far the light gets: rows, and columns of the finest level
SHARED_CONST uint kShadeColumns = 256u;
SHARED_CONST uint kFanWidth = 2u * kFinestFan + 6u * kLeastFan; // of a layer: all levels

// Row coordinate -1..1 of a meridian given by its cosine and sine; beyond: the plane misses the beam.
SHARED_FN float fan_row(Fan fan, float cosine, float sine) {
#ifdef __cplusplus
    using namespace glm;
    float angle = std::atan2(sine, cosine);
#else
    float angle = atan(sine, cosine);
#endif
    float line = cosine > 0.0f ? sine * fan.row_scale : 2.0f;
    return fan.row_scale > 0.0f ? line : angle * (1.0f / kPi);
}

// Cosine and sine of the meridian of a row coordinate.
SHARED_FN vec2 fan_meridian(Fan fan, float row) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float sine = row / max(fan.row_scale, 1e-9f);
    vec2 line = vec2(sqrt(max(1.0f - sine * sine, 0.0f)), sine);
    vec2 turn = vec2(cos(row * kPi), sin(row * kPi));
    return fan.row_scale > 0.0f ? line : turn;
}

// Polar angles between which a meridian lies in the beam; x >= y where it misses.
SHARED_FN vec2 fan_chord(Fan fan, float meridian_cosine) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float side = fan.sin_axis * meridian_cosine;
    float reach = sqrt(fan.cos_axis * fan.cos_axis + side * side);
    float half_width = acos(clamp(fan.cos_cone / max(reach, 1e-9f), -1.0f, 1.0f));
#ifdef __cplusplus
    float centre = std::atan2(side, fan.cos_axis);
#else
    float centre = atan(side, fan.cos_axis);
#endif
    centre = centre + half_width <= 0.0f ? centre + 2.0f * kPi : centre;
    return vec2(max(centre - half_width, 0.0f), min(centre + half_width, kPi));
}

// The table holds shares of the brightest colour of a split gate.
SHARED_FN float fan_most(vec3 colour_b) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return max(max(max(colour_b.x, colour_b.y), colour_b.z), 1.0f);
}

// Rows and columns of a level: half of the level before, but never fewer than kLeastFan.
SHARED_FN uint fan_side(uint size, uint level) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return max(size >> level, kLeastFan);
}

// The levels stand side by side in their layer: columns (and rows) of all levels before this one.
SHARED_FN uint fan_left(Fan fan, uint level) {
    uint halved = 2u * fan.size - 2u * (fan.size >> level);
    uint even = 2u * fan.size - 2u * kLeastFan + kLeastFan * (level - fan.halvings);
    return level <= fan.halvings ? halved : even;
}

SHARED_END
#endif
