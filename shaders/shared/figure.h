// SPDX-License-Identifier: Apache-2.0
// The figure that a laser sweeps through the gate of a light: what the eye sees of it, the mean over the scanner's round. A curve
// of Gaussian cross-section; its light is that of the beam which draws it, whatever its blur: docs/design/lasers.md has the formulas.
#ifndef GHOST_SHARED_FIGURE_H
#define GHOST_SHARED_FIGURE_H
#include "shared/types.h"

SHARED_BEGIN

SHARED_CONST uint kNoFigure = 0u;
SHARED_CONST uint kLineFigure = 1u;
SHARED_CONST uint kCircleFigure = 2u;
SHARED_CONST uint kWaveFigure = 3u;

// Light::intensity_cd is that of a figure so wide (gate units), so that haze's table, which never sees a finer one, holds no more than 1.
SHARED_CONST float kFigureWidth = 1.0f / 128.0f;

SHARED_FN real figure_slant(float tan_field, real radius2) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real slant = sqrt(1.0f + tan_field * tan_field * radius2);
    return slant * slant * slant;
}

// Length that the light is spread over where it is brightest, gate units.
SHARED_FN float figure_length(LaserCurve figure) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return figure.kind == kCircleFigure ? 2.0f * kPi * min(figure.half_size.x, figure.half_size.y) : 2.0f * figure.half_size.x;
}

// Even from one end to the other, blurred there.
SHARED_FN real figure_ends(real x, real half_length, real deviation) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real t = clamp((half_length - abs(x)) / (4.0f * deviation) + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// Fraction of Light::intensity_cd; blur: radius of a disc.
SHARED_FN real figure_transmittance(Light light, vec2 gate, real blur) {
#ifdef __cplusplus
    using namespace glm;
#endif
    LaserCurve figure = light.figure;
    real deviation = sqrt(figure.deviation * figure.deviation + 0.25f * blur * blur);
    vec2 at = vec2(figure.cosine * gate.x + figure.sine * gate.y, figure.cosine * gate.y - figure.sine * gate.x);
    vec2 size = figure.half_size;
    // How far across the curve, how wide it is there, and how much of its light stands at this place along it.
    real across = at.y;
    real width = deviation;
    real along = 1.0f;
    if (figure.kind == kCircleFigure) {
        vec2 unit = at / size;
        real radius = max(length(unit), 1e-6f);
        real finest = max(length(unit / size) / radius, 1.0f / max(size.x, size.y)); // in the middle it has no direction
        // Mirrors that swing as sine and cosine: even in the angle of the unit circle. Its distance, as fine as there.
        across = radius - 1.0f;
        width = deviation * finest;
        along = min(size.x, size.y) / (size.x * size.y * radius);
    } else {
        along = figure_ends(at.x, size.x, deviation);
    }
    if (figure.kind == kWaveFigure) {
        real turns = kPi * figure.waves / size.x;
        real angle = turns * at.x + figure.phase;
        real slope = size.y * turns * cos(angle);
        across = at.y - size.y * sin(angle);
        width = deviation * sqrt(1.0f + slope * slope);
    }
    real from = across / width;
    real gauss = exp2(-0.72134752f * from * from) * 0.39894228f / width;
    return gauss * along * kFigureWidth * figure_slant(light.tan_field, dot(gate, gate)) /
           figure_slant(light.tan_field, light.cut_radius * light.cut_radius);
}

SHARED_END
#endif
