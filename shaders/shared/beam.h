// SPDX-License-Identifier: Apache-2.0
// The beam: candela that a light sends towards a point. The only definition; surfaces, haze, baker and the photometry in
// C++ all call it. Follows Screen Space Re-Rendering 2.1 (mask by axis, angle and two orthogonal gate axes) with the
// photometric profile of IES/CIE: beam angle at 50 %, field angle at 10 % of the peak.
//
// Both sides supply gobo_sample: transmission of a gobo layer at gate coordinates (-1..1), blurred over a disc of the
// given radius; and slide_sample: colour (linear Rec.2020) of a layer of the moving pictures. In C++ it needs the images, so there the functions take them as a last argument.
#ifndef GHOST_SHARED_BEAM_H
#define GHOST_SHARED_BEAM_H
#include "shared/figure.h"
#include "shared/optics.h"
#include "shared/types.h"

#ifdef __cplusplus
#include "shared/gobos.h"
#define WITH_GOBOS , const Gobos& gobos
#define PASS_GOBOS , gobos
#define WHEEL_COUNT(light) (light).wheel_count
#define IS_SHAPED(light) ((light).shaped != 0u)
#define IS_CUT(light) ((light).shaped > 1u)
#define HAS_SLIDE(light) ((light).slide.layer != 0u)
#define HAS_FIGURE(light) ((light).figure.kind != 0u)
#define IS_PANEL(light) ((light).panel_m > 0.0f)
#else
#define WITH_GOBOS
#define PASS_GOBOS
// A shader is compiled once per class of beams (shared/optics.h). What is not in use costs nothing: lavapipe runs a loop body at
// least once, masked.
layout(constant_id = 0) const uint kClass = 0u;
#define WHEEL_COUNT(light) (is_shaped(kClass) ? (light).wheel_count : (kClass >= kSlideClass ? 0u : kClass))
#define IS_SHAPED(light) (is_shaped(kClass))
#define IS_CUT(light) (kClass == kCutClass || kClass == kCutSlideClass)
#define HAS_SLIDE(light) (kClass == kSlideClass || kClass == kCutSlideClass)
#define HAS_FIGURE(light) (kClass == kFigureClass)
#define IS_PANEL(light) (kClass == kPanelClass)
vec3 gobo_sample(uint layer, vec2 gate, float blur);
vec3 slide_sample(uint layer, vec2 place, float radius_texels);
#endif

SHARED_BEGIN

// Slots of a wheel stand this far apart, in gate radii.
SHARED_CONST float kSlotSpacing = 2.4f;

SHARED_FN real beam_profile(real radius2, float power, float scale) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return exp2(-scale * exp2(power * log2(max(radius2, 1e-12f))));
}

// Light that the aperture (field stop or iris) lets through at a gate radius, blurred by a disc of the given radius.
SHARED_FN real beam_aperture(real radius, real aperture, real blur) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real t = clamp((aperture - radius) / (2.0f * blur) + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// The same for a round opening in an even field, which lets as much light through blurred as it does sharp: a soft edge as wide to both
// sides has more of its area outside. What is blurred more than it is wide has no bright middle left. rim_fraction: see Light.
SHARED_FN real beam_opening(real radius, float opening, real blur, float rim_fraction) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float opening2 = opening * opening;
    real blur2 = rim_fraction * blur * blur;
    real middle = min(opening2 / max(1.2f * blur2, 1e-12f), 1.0f);
    return middle * beam_aperture(radius, sqrt(max(opening2 - 0.2f * blur2, blur2)), blur);
}

SHARED_FN vec3 wheel_sample(Wheel wheel, vec2 gate, real blur WITH_GOBOS) {
#ifdef __cplusplus
    using namespace glm;
#else // The other classes have no wheel between two slots (light/gate.cpp): a loop in the loop over the wheels costs them a tenth.
    if (kClass != kCutClass && kClass != kCutSlideClass) return gobo_sample(wheel.layer_a, vec2(wheel.cosine * gate.x + wheel.sine * gate.y, wheel.cosine * gate.y - wheel.sine * gate.x), blur);
#endif
    uint slots = wheel.shift == 0.0f ? 1u : 2u; // a centred one is limited by the aperture alone, two have rims and add up
    vec3 sum = vec3(0.0f);
    for (uint k = 0u; k < slots; ++k) {
        vec2 g = gate - vec2((float(k) - wheel.shift) * kSlotSpacing, 0.0f);
        real rim = wheel.shift == 0.0f ? 1.0f : beam_aperture(length(g), 1.0f, max(blur, 0.01f));
        vec2 turned = vec2(wheel.cosine * g.x + wheel.sine * g.y, wheel.cosine * g.y - wheel.sine * g.x);
        sum += gobo_sample(k == 0u ? wheel.layer_a : wheel.layer_b, turned, blur PASS_GOBOS) * rim;
    }
    return sum;
}

// What the animation wheel leaves of the light.
SHARED_FN vec3 disc_sample(Light light, vec2 gate, Focus focus WITH_GOBOS) {
#ifdef __cplusplus
    using namespace glm;
#endif
    Disc disc = light.disc;
    real blur = blur_of(light, focus, disc.depth) * disc.scale;
    vec2 place = disc.centre + disc.scale * gate;
    vec2 turned = vec2(disc.cosine * place.x + disc.sine * place.y, disc.cosine * place.y - disc.sine * place.x);
    real covered = beam_aperture(length(place), 1.0f, max(blur, 0.01f));
    return vec3(1.0f) + (gobo_sample(disc.layer, turned, blur PASS_GOBOS) - vec3(1.0f)) * covered;
}

// What one framing blade leaves of the light.
SHARED_FN real blade_transmittance(Light light, Blade blade, vec2 gate, Focus focus) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return beam_aperture(dot(gate, blade.normal), blade.offset, blur_of(light, focus, blade.depth));
}

// What all four leave. Blades that face each other do not cover each other: what they take adds up, so that a blurred slit is right.
SHARED_FN real blades_transmittance(Light light, vec2 gate, Focus focus) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real first = blade_transmittance(light, light.blade[0], gate, focus) + blade_transmittance(light, light.blade[2], gate, focus);
    real second = blade_transmittance(light, light.blade[1], gate, focus) + blade_transmittance(light, light.blade[3], gate, focus);
    return max(first - 1.0f, 0.0f) * max(second - 1.0f, 0.0f);
}

SHARED_FN vec3 slide_map(vec3 row_x, vec3 row_y, vec3 row_z, vec2 gate) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 way = vec3(gate, 1.0f);
    vec3 at = vec3(dot(row_x, way), dot(row_y, way), max(dot(row_z, way), 1e-3f));
    return vec3(at.x / at.z, at.y / at.z, at.z);
}

// Fraction of a rectangle of -1..1, blurred. scale: of the rectangle's units to the gate's, from the middle rows of its map.
SHARED_FN real slide_frame(vec3 row_x, vec3 row_y, vec3 row_z, vec3 at, real blur) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real blur_z = blur / max(row_z.z, 1e-3f);
    return beam_aperture(abs(at.x), 1.0f, blur_z * length(vec2(row_x.x, row_x.y))) *
           beam_aperture(abs(at.y), 1.0f, blur_z * length(vec2(row_y.x, row_y.y)));
}

// What the panel of a video projector sends, as a fraction of its brightest corner's white.
SHARED_FN vec3 slide_transmittance(Light light, vec2 gate, real blur WITH_GOBOS) {
#ifdef __cplusplus
    using namespace glm;
#endif
    Slide slide = light.slide;
    vec3 panel = slide_map(slide.panel[0], slide.panel[1], slide.panel[2], gate);
    vec3 at = slide_map(slide.picture[0], slide.picture[1], slide.picture[2], gate);
    // The panel lights a wall across its optical axis evenly.
    real slant = sqrt(1.0f + light.tan_field * light.tan_field * dot(gate, gate)) / panel.z;
    real black = slide.black * slide_frame(slide.panel[0], slide.panel[1], slide.panel[2], panel, blur);
    // Two fades over each other add up to 1. Where none is wanted it is 1, also in the blur beyond the edge.
    vec4 none = vec4(1.0f) - min(slide.blend, vec4(0.5f)) * 2.0f;
    vec4 fade = clamp((vec4(at.x, -at.x, at.y, -at.y) + vec4(1.0f)) * slide.blend + none, vec4(0.0f), vec4(1.0f));
    fade = fade * fade * (vec4(3.0f) - 2.0f * fade);
    real fraction = slide_frame(slide.picture[0], slide.picture[1], slide.picture[2], at, blur) * fade.x * fade.y * fade.z * fade.w;
    vec3 picture = slide_sample(slide.layer, vec2(at.x, at.y) * slide.extent, blur / slide.texel PASS_GOBOS);
    return (vec3(black) + picture * (fraction * (1.0f - slide.black))) * (slant * slant * slant);
}

// What the gate lets through, relative to the open gate on the axis: profile, aperture, split colour, gobos, animation wheel and
// blades at a gate position, each as blurred as its plane is.
SHARED_FN vec3 beam_gate(Light light, vec2 gate, Focus focus WITH_GOBOS) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real radius2 = dot(gate, gate);
    real rim_blur = blur_of(light, focus, IS_SHAPED(light) ? light.iris_depth : 0.0f);
    real value = beam_profile(radius2, light.profile_power, light.profile_scale) *
                  beam_opening(sqrt(radius2), light.iris_radius, light.rim_fraction < 0.0f ? light.edge : rim_blur,
                               max(light.rim_fraction, 0.0f));
    if (IS_CUT(light)) value *= blades_transmittance(light, gate, focus);
    value = select(radius2 < light.cut_radius * light.cut_radius, value, 0.0f);
    real side = clamp((gate.x - light.split) / (2.0f * (kSplitHalf + light.split_soft)) + 0.5f, 0.0f, 1.0f);
    vec3 colour = (vec3(1.0f) + (light.colour_b - vec3(1.0f)) * side) * value;
    for (uint k = 0u; k < WHEEL_COUNT(light); ++k)
        colour *= wheel_sample(light.wheel[k], gate,
                               blur_of(light, focus, IS_SHAPED(light) ? light.wheel[k].depth : 0.0f) PASS_GOBOS);
    if (HAS_FIGURE(light)) colour *= figure_transmittance(light, gate, blur_of(light, focus, 0.0f));
    if (HAS_SLIDE(light)) colour *= slide_transmittance(light, gate, blur_of(light, focus, 0.0f) PASS_GOBOS);
    if (IS_CUT(light) && light.disc.layer != 0u) colour *= disc_sample(light, gate, focus PASS_GOBOS);
    return colour;
}

// What a disc that is evenly bright throws, relative to all its light at its middle, where the inverse square law has no end: on its axis
// 1 / (d^2 + radius^2) in place of 1 / d^2. distance2: from its middle, m^2.
SHARED_FN real near_fraction(Light light, real distance2) {
    if (!IS_PANEL(light)) return 1.0f;
    return distance2 / (distance2 + light.panel_m * light.panel_m);
}

// See haze_phase.
SHARED_FN real near_narrow(Light light, real distance2) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return IS_PANEL(light) ? sqrt(near_fraction(light, distance2)) : 1.0f;
}

// Candela (RGB) towards gate position q, metres from the apex, for the inverse square law.
SHARED_FN vec3 beam_candela(Light light, vec3 q WITH_GOBOS) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real z = max(q.z, 1e-4f);
    vec2 gate = vec2(q.x, q.y) / (z * light.tan_field);
    // Nothing leaves backwards, or is lit behind the lens.
    vec3 intensity = select(q.z > max(light.lens_m, 1e-4f), light.intensity_cd, vec3(0.0f));
    return intensity * beam_gate(light, gate, beam_focus(light, z) PASS_GOBOS) * near_fraction(light, dot(q, q));
}

// Of the way from the apex, what lies before the lens: where there is haze. q: in gate coordinates.
SHARED_FN real way_from_lens_m(Light light, vec3 q) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return length(q) * max(1.0f - light.lens_m / max(q.z, 1e-4f), 0.0f);
}

// A pass is the picture of a point source at the place of the light's map; what it has of 1/r^2 becomes that of the apex.
// way_m: from the apex to the surface.
SHARED_FN real pass_fraction(Light light, vec3 way_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 from_map = way_m + light.off_map_m;
    return dot(from_map, from_map) / max(dot(way_m, way_m), 1e-4f);
}

// Gate coordinates of a world offset from the apex (or of a direction).
SHARED_FN vec3 to_gate(Light light, vec3 offset) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return vec3(dot(offset, light.axis_u), dot(offset, light.axis_v), dot(offset, light.axis_w));
}

// Part [x, y] of the ray q + t dq, t in [0, far], inside the cone (q.x^2 + q.y^2 <= (k q.z)^2, q.z > 0); x >= y where
// it misses. Screen Space Re-Rendering 2.2: samples are moved into the illuminated part.
SHARED_FN vec2 clip_to_cone(vec3 q, vec3 dq, float k, real far) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float k2 = k * k;
    real a = dq.x * dq.x + dq.y * dq.y - k2 * dq.z * dq.z;
    real b = q.x * dq.x + q.y * dq.y - k2 * q.z * dq.z;
    real c = q.x * q.x + q.y * q.y - k2 * q.z * q.z;
    a = select(abs(a) < 1e-9f, 1e-9f, a);
    real discriminant = b * b - a * c;
    real root = sqrt(max(discriminant, 0.0f));
    real t0 = (-b - root) / a;
    real t1 = (-b + root) / a;
    real low = min(t0, t1);
    real high = max(t0, t1);
    // a > 0: the ray crosses one nappe, between the roots. a < 0: inside before the lower and after the upper root, one
    // of them on the nappe that is lit.
    truth forward = dq.z > 0.0f;
    real begin = select(a > 0.0f, low, select(forward, high, -1e30f));
    real end = select(a > 0.0f, high, select(forward, 1e30f, low));
    truth hit = a < 0.0f || (discriminant > 0.0f && q.z + 0.5f * (low + high) * dq.z > 0.0f);
    begin = max(begin, 0.0f);
    end = min(end, far);
    return select(hit, vec2(begin, end), vec2(1.0f, 0.0f));
}

SHARED_END
#endif
