// SPDX-License-Identifier: Apache-2.0
// Development: exposure in EV100 and a tone curve, linear Rec.2020 cd/m^2 in, sRGB-encoded display values out. One definition
// for screen, PNG, film and the metrics. The curves leave the middle grey 0.18 where it is; agx
// makes it 0.21.
#ifndef GHOST_SHARED_DEVELOP_H
#define GHOST_SHARED_DEVELOP_H
#include "shared/types.h"

#ifdef __cplusplus
namespace ghost::shared {
using glm::mat3;
}
#endif

SHARED_BEGIN

SHARED_CONST float kMeterFloor = 0.01f; // cd/m^2; darker pixels are the hall, not the show
SHARED_CONST float kAutoBias = 0.7f;    // a lit stage in a dark hall is exposed for its highlights
// As image::Tone counts them.
SHARED_CONST uint kToneAgx = 0u;
SHARED_CONST uint kToneAces = 1u;
SHARED_CONST uint kToneLinear = 2u;
SHARED_CONST uint kToneCount = 3u;
SHARED_CONST float kAcesScale = 0.7232f; // with it 0.18 stays 0.18
SHARED_CONST float kAgxMinEv = -12.47393f;
SHARED_CONST float kAcesMost = 1e4f;
SHARED_CONST float kAcesA = 2.51f, kAcesB = 0.03f, kAcesC = 2.43f, kAcesD = 0.59f, kAcesE = 0.14f;
SHARED_CONST float kAgxMaxEv = 4.026069f;
SHARED_CONST float kAgxCurve6 = 15.5f, kAgxCurve5 = -40.14f, kAgxCurve4 = 31.96f, kAgxCurve3 = -6.868f, kAgxCurve2 = 0.4298f, kAgxCurve1 = 0.1191f,
                   kAgxCurve0 = -0.00232f;
// A little of the saturation that the curve takes away: stage light is coloured on purpose.
SHARED_CONST float kAgxSaturation = 1.25f;
SHARED_CONST float kAgxGamma = 2.2f;
SHARED_CONST float kSrgbLinearBelow = 0.0031308f, kSrgbSlope = 12.92f, kSrgbScale = 1.055f, kSrgbOffset = -0.055f, kSrgbPower = 1.0f / 2.4f;

// Matrices by their columns.
SHARED_FN mat3 agx_inset() {
    return mat3(vec3(0.856627153315983f, 0.137318972929847f, 0.11189821299995f),
                vec3(0.0951212405381588f, 0.761241990602591f, 0.0767994186031903f),
                vec3(0.0482516061458583f, 0.101439036467562f, 0.811302368396859f));
}
SHARED_FN mat3 agx_outset() {
    return mat3(vec3(1.1271005818144368f, -0.1413297634984383f, -0.14132976349843826f),
                vec3(-0.11060664309660323f, 1.157823702216272f, -0.11060664309660294f),
                vec3(-0.016493938717834573f, -0.016493938717834257f, 1.2519364065950405f));
}
SHARED_FN vec3 agx_grey() { return vec3(0.2126f, 0.7152f, 0.0722f); }
SHARED_FN mat3 rec709_of_rec2020() {
    return mat3(vec3(1.660491f, -0.124550f, -0.018151f), vec3(-0.587641f, 1.132900f, -0.100579f),
                vec3(-0.072850f, -0.008349f, 1.118730f));
}

// Display factor: saturation-based speed, L_max = 1.2 2^EV100.
SHARED_FN float exposure_of(float ev100) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return 1.0f / (1.2f * exp2(ev100));
}

SHARED_FN float luminance_of(vec3 rec2020) { return rec2020.x * 0.2627f + rec2020.y * 0.6780f + rec2020.z * 0.0593f; }

SHARED_FN vec3 srgb_encode(vec3 linear) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 c = clamp(linear, vec3(0.0f), vec3(1.0f));
    vec3 low = c * kSrgbSlope;
    vec3 high = kSrgbScale * pow(c, vec3(kSrgbPower)) + kSrgbOffset;
    return vec3(c.x < kSrgbLinearBelow ? low.x : high.x, c.y < kSrgbLinearBelow ? low.y : high.y, c.z < kSrgbLinearBelow ? low.z : high.z);
}

// In the manner of AgX (Troy Sobotka; sigmoid as the polynomial fit by Benjamin Wrensch): colours that are too bright go to
// white as film does. Exposed Rec.2020 in, linear of the display out, likewise below.
SHARED_FN vec3 tone_agx(vec3 exposed) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 c = agx_inset() * exposed;
    c = clamp((log2(max(c, vec3(1e-10f))) - kAgxMinEv) / (kAgxMaxEv - kAgxMinEv), vec3(0.0f), vec3(1.0f));
    vec3 c2 = c * c;
    vec3 c4 = c2 * c2;
    c = kAgxCurve6 * c4 * c2 + kAgxCurve5 * c4 * c + kAgxCurve4 * c4 + kAgxCurve3 * c2 * c + kAgxCurve2 * c2 + kAgxCurve1 * c + kAgxCurve0;
    float grey = dot(c, agx_grey());
    c = vec3(grey) + kAgxSaturation * (c - vec3(grey));
    return pow(max(agx_outset() * c, vec3(0.0f)), vec3(kAgxGamma));
}

// The look of the Academy's output transforms: more contrast, colours stay saturated for longer. The fit
// (x (A x + B)) / (x (C x + D) + E) by Krzysztof Narkowicz (2015), on each primary of Rec.2020.
SHARED_FN vec3 tone_aces(vec3 exposed) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 c = min(exposed * kAcesScale, vec3(kAcesMost));
    return clamp((c * (kAcesA * c + kAcesB)) / (c * (kAcesC * c + kAcesD) + kAcesE), vec3(0.0f), vec3(1.0f));
}

SHARED_FN vec3 develop(vec3 rec2020, float exposure, uint tone) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 exposed = max(rec2020 * exposure, vec3(0.0f));
    vec3 shown = tone == kToneLinear ? exposed : tone == kToneAces ? tone_aces(exposed) : tone_agx(exposed);
    return srgb_encode(rec709_of_rec2020() * shown); // which clips
}

SHARED_END
#endif
