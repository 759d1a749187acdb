// SPDX-License-Identifier: Apache-2.0
// The structs that C++ and the shaders share: one definition, compiled by both. Scalar layout; every size is pinned by a
// static_assert. Units: metres, radians, candela, cd/m^2 per cd, 1/m; colour is linear Rec.2020. World: right-handed, Z up.
#ifndef GHOST_SHARED_TYPES_H
#define GHOST_SHARED_TYPES_H

#ifdef __cplusplus
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#define SHARED_BEGIN namespace ghost::shared {
#define SHARED_END }
#define SHARED_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), "layout differs from the shaders")
#define SHARED_FN inline
#define SHARED_CONST inline constexpr
#define SHARED_INOUT(type) type&
namespace ghost::shared {
using glm::vec2;
using glm::vec3;
using glm::vec4;
using glm::uvec2;
using uint = std::uint32_t;
// What differs from pixel to pixel, and what is asked of it. Functions that have their numbers of it are compiled a third time, with
// eight pixels at once in it (render/pixels/private/beam_lanes.h): there select() has both its sides worked out.
using real = float;
using truth = bool;
template <class Value>
constexpr Value select(bool condition, const Value& yes, const Value& no) {
    return condition ? yes : no;
}
} // namespace ghost::shared
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_SIZE(type, bytes)
#define SHARED_FN
#define SHARED_CONST const
#define SHARED_INOUT(type) inout type
#define real float
#define truth bool
#define select(condition, yes, no) ((condition) ? (yes) : (no))
#endif

SHARED_BEGIN

// One gobo wheel as it stands in the beam. Between two slots, the gate shows a part of both.
struct Wheel {
    uint layer_a; // gobo layer of the slot at the optical axis, 0 = open
    uint layer_b; // the next slot
    float shift;  // 0 = slot a centred .. 1 = slot b centred
    float cosine; // rotation of the gobo in its slot, seen along the beam
    float sine;
    float depth;  // see Light::focus_per_m
};
SHARED_SIZE(Wheel, 24);

// An animation wheel: a picture beside the beam's axis that turns about its own middle. The gate sees
// R(turn) (centre + scale gate) of the picture's -1..1; beyond the picture nothing is in the way.
struct Disc {
    uint layer; // of the gobos; 0: none
    float cosine;
    float sine;
    vec2 centre;
    float scale;
    float depth;
};
SHARED_SIZE(Disc, 28);

// A framing blade: a half plane of the gate. Light passes where dot(gate, normal) < offset.
struct Blade {
    vec2 normal; // unit, towards the blade
    float offset;
    float depth;
};
SHARED_SIZE(Blade, 16);

// A picture in the gate of a video projector. Rows of two maps from the gate (x, y, 1): to its panel, which is all lit a little, and to the
// picture on it; both are -1..1 across. The panel's are scaled by the cube root of what its brightest corner gets beyond the
// axis, so that no fraction is above 1.
struct Slide {
    uint layer;       // of the pictures, + 1; 0: there is no slide
    uint moment;      // number of the picture: another one makes another light
    vec3 panel[3];
    vec3 picture[3];
    vec4 blend;       // 1 / (2 widths) of the fades at its left, right, bottom and top; 0: none
    vec2 extent;      // of the picture in its square layer, fractions of the layer
    float black;      // fraction of full white that passes where the picture is black
    float texel;      // of the layer, in gate units
};
SHARED_SIZE(Slide, 112);

// A curve that a laser's scanner sweeps, about the gate's middle (shared/figure.h).
struct LaserCurve {
    uint kind;       // 0: the light is no swept laser
    vec2 half_size;  // gate units; of a wave: half its length, its height
    float cosine;    // its turn, seen along the beam
    float sine;
    float deviation; // standard deviation across the curve, gate units: the laser's own divergence
    float phase;     // of a wave, radians
    float waves;     // that it has
};
SHARED_SIZE(LaserCurve, 32);

// What one fixture emits now. Gate coordinates: q = (along axis_u, along axis_v, along axis_w) from the apex;
// (q.x, q.y) / (q.z tan_field) is 1 at the field angle.
struct Light {
    vec3 position_m;       // apex of the beam: so far behind the lens that the beam leaves it as wide as it is
    float lens_m;          // from the apex to the lens, along the axis: there is no light before it
    vec3 axis_u;           // unit, right in the gate seen along the beam
    float tan_field;       // tangent of half the field angle
    vec3 axis_v;           // unit, up in the gate
    float cut_radius;      // gate radius beyond which nothing is emitted
    vec3 axis_w;           // unit, direction of the beam
    float profile_power;   // shape = exp2(-profile_scale (r^2)^profile_power)
    vec3 intensity_cd;     // on the axis, open gate, through the first colour; dimmer and shutter included
    float profile_scale;
    vec3 colour_b;         // second colour of a split, relative to the first
    float split;           // gate coordinate of the split; at or above kNoSplit there is none
    float split_soft;      // by how much frost makes half its width larger than kSplitHalf
    float iris_radius;     // gate radius of the aperture
    float edge;            // half width of the aperture's soft edge where the beam is in focus, gate units
    // 1 / distance from the lens at which the plane of depth 0 is sharp. Depth: radius (gate units) to which another plane is blurred far away
    // while that one is sharp; above 0 nearer to the lens. See optics.h.
    float focus_per_m;
    float lens_radius_m;   // blur of a point out of focus grows with it
    float iris_depth;
    uint shaped;           // 1: planes of several depths, or a third wheel; 2: also blades or a disc; 0: these are as if not there
    Disc disc;
    Blade blade[4];        // opposite ones are two apart
    Wheel wheel[3];
    uint wheel_count;      // how many of wheel[] shape the beam
    uint pass;             // its picture as a point source
    uint haze_samples;     // samples of the cone integrator; 0: surfaces only
    vec3 bounce_cd;        // of a point source that sends out as many lumens: scales the bounced light
    uint map;              // its distance map: layer + 1; 0: nothing is in the way
    vec3 off_map_m;        // from where that map was made to position_m
    float disc_radius_m;   // of the luminous disc at the lens: how soft shadows are, how large the lens looks
    float rim_fraction;       // of beam_opening: 1 where the field is even up to the aperture, 0 where it falls steeply there; below 0: the aperture
                           // is the end of a frosted field, which no focus makes softer
    float panel_m;         // radius of a piece of a LED wall, which throws light as near_fraction has it; 0: it does as its apex does
    Slide slide;           // in the plane of depth 0
    LaserCurve figure;         // in place of profile, wheels and slide
};
SHARED_SIZE(Light, 484);

// Homogeneous haze: extinction, scattering and the two-term Henyey-Greenstein phase function.
struct Haze {
    float extinction_per_m;
    float scattering_per_m;
    float forward_g;
    float back_g;
    float back_weight; // fraction of the backward lobe
};
SHARED_SIZE(Haze, 20);

// Light grows weaker with 1 / (constant + linear d + quadratic d^2), as OpenGL and the thesis have it. Physics is (0, 0, 1);
// everything else is taste.
struct Attenuation {
    float constant;
    float linear;
    float quadratic;
};
SHARED_SIZE(Attenuation, 12);

// A pinhole camera: the ray through image point (x, y) in pixels, y down, is forward + right (2x/w - 1) + up (1 - 2y/h).
struct View {
    vec3 eye_m;
    uint width;
    vec3 forward; // unit
    uint height;
    vec3 right;   // scaled by the tangent of half the horizontal field of view
    float far_m;  // length of a ray that meets no surface
    vec3 up;      // scaled by the tangent of half the vertical field of view
    float unused;
    Haze haze;
};
SHARED_SIZE(View, 84);

SHARED_CONST float kNoSplit = 1e6f;
SHARED_CONST float kSplitHalf = 0.125f; // half the width of a split in the gate
SHARED_CONST float kPi = 3.14159265358979f;

SHARED_END
#endif
