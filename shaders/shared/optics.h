// SPDX-License-Identifier: Apache-2.0
// Focus: how far the planes of the gate are blurred along the beam. Apart from beam.h because haze needs it without the gobos.
//
// A thin lens of radius R, with t = R / (R + z tan_field) at a distance z before it (1 at the lens, 0 far away), blurs a plane over
// a disc whose signed radius in gate units is linear in t:  t - (1 - t) (c - depth),  c = R focus_per_m / tan_field.
#ifndef GHOST_SHARED_OPTICS_H
#define GHOST_SHARED_OPTICS_H
#include "shared/types.h"

SHARED_BEGIN

// Classes of beams: 0, 1 or 2 wheels and nothing else in the gate; planes at several depths; those and blades or a disc; a moving
// picture alone, and one among anything; the figure that a laser sweeps; a piece of a LED wall, with nothing in its gate.
SHARED_CONST uint kPlanesClass = 3u;
SHARED_CONST uint kCutClass = 4u;
SHARED_CONST uint kSlideClass = 5u;
SHARED_CONST uint kCutSlideClass = 6u;
SHARED_CONST uint kFigureClass = 7u;
SHARED_CONST uint kPanelClass = 8u;
SHARED_CONST uint kBeamClasses = 9u;

SHARED_FN uint beam_class(Light light) {
    if (light.figure.kind != 0u) return kFigureClass;
    if (light.panel_m > 0.0f) return kPanelClass;
    uint without = light.shaped == 0u ? light.wheel_count : (light.shaped == 1u ? kPlanesClass : kCutClass);
    return light.slide.layer == 0u ? without : (without == 0u ? kSlideClass : kCutSlideClass);
}

// A head with wheels, blades or an iris comes to it without anything new in the show.
SHARED_FN bool may_be_of_wheels(uint kind) { return kind <= kCutClass; }

// Its planes are not blurred alike.
SHARED_FN bool is_shaped(uint kind) {
    return kind == kPlanesClass || kind == kCutClass || kind == kCutSlideClass;
}

struct Focus {
    real plane;  // signed blur of the plane of depth 0, gate units
    real away;   // 1 - t
    real least;  // blur in any case, in quadrature: of the picture's pixels
};

// At a place t of the way, blurred by `least` in any case.
SHARED_FN Focus focus_at(Light light, real t, real least) {
#ifdef __cplusplus
    using namespace glm;
#endif
    Focus focus;
    focus.plane = light.lens_radius_m > 0.0f
                      ? t - (1.0f - t) * light.lens_radius_m * light.focus_per_m / light.tan_field
                      : 0.0f;
    focus.away = 1.0f - t;
    focus.least = least;
    return focus;
}

// At distance z from the apex along the beam, which is z tan_field wide there.
SHARED_FN Focus beam_focus(Light light, real z) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return focus_at(light, min(light.lens_radius_m / max(z * light.tan_field, 1e-9f), 1.0f), 0.0f);
}

// The same where all planes are blurred alike, over a disc of this radius.
SHARED_FN Focus even_focus(Light light, real blur) {
    Focus focus;
    focus.plane = blur - light.edge;
    focus.away = 0.0f;
    focus.least = 0.0f;
    return focus;
}

// Radius of the blur disc of a plane of the gate, in gate units.
SHARED_FN real blur_of(Light light, Focus focus, float depth) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real blur = light.edge + abs(focus.plane + depth * focus.away);
    return select(focus.least > 0.0f, length(vec2(blur, focus.least)), blur);
}

// Of the plane of depth 0, at distance z.
SHARED_FN real beam_blur(Light light, real z) { return blur_of(light, beam_focus(light, z), 0.0f); }

SHARED_END
#endif
