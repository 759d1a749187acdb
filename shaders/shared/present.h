// SPDX-License-Identifier: Apache-2.0
// From the developed picture to a surface of the display: sRGB as it is, HDR10 (BT.2020 primaries, PQ of SMPTE ST 2084) and scRGB (linear,
// Rec.709 primaries, 1 = 80 cd/m^2). White of the picture is shown at kWhite_cd_m2 (ITU-R BT.2408).
#ifndef GHOST_SHARED_PRESENT_H
#define GHOST_SHARED_PRESENT_H
#include "shared/develop.h"

SHARED_BEGIN

SHARED_CONST float kWhite_cd_m2 = 203.0f;
SHARED_CONST float kPeak_cd_m2 = 1000.0f; // where highlights end
SHARED_CONST float kScrgbOne_cd_m2 = 80.0f;
SHARED_CONST float kPqMost_cd_m2 = 10000.0f;
SHARED_CONST float kPqM1 = 0.1593017578125f, kPqM2 = 78.84375f, kPqC1 = 0.8359375f, kPqC2 = 18.8515625f, kPqC3 = 18.6875f;
SHARED_CONST float kSrgbEncodedBelow = 0.04045f;

// As render::Encoding counts them.
SHARED_CONST uint kEncodeSrgb = 0u;
SHARED_CONST uint kEncodePq = 1u;
SHARED_CONST uint kEncodeScrgb = 2u;

struct PresentPush {
    vec2 place; // of the picture's top left corner, pixels of the surface
    vec2 size;  // of the picture there; 0: there is none
    uint encoding;
    uint swaps;  // 1: blue stands first
    uint light;  // 1: the picture is linear Rec.2020 whose white is 1, else sRGB
    uint exact;  // 1: a pixel of the picture is one of the surface
    uint taps;   // a side, where the picture is finer than the surface
    uint covers; // 1: there is an overlay
};
SHARED_SIZE(PresentPush, 40);

struct ShownLightPush {
    uint tone;
    float peak; // over white
};
SHARED_SIZE(ShownLightPush, 8);

SHARED_FN mat3 rec2020_of_rec709() {
    return mat3(vec3(0.627404f, 0.069097f, 0.016391f), vec3(0.329283f, 0.919540f, 0.088013f), vec3(0.043313f, 0.011362f, 0.895595f));
}

SHARED_FN float srgb_decode_one(float c) {
#ifdef __cplusplus
    using namespace std;
#endif
    return c < kSrgbEncodedBelow ? c / kSrgbSlope : pow((c - kSrgbOffset) / kSrgbScale, 1.0f / kSrgbPower);
}
SHARED_FN vec3 srgb_decode(vec3 c) { return vec3(srgb_decode_one(c.x), srgb_decode_one(c.y), srgb_decode_one(c.z)); }

SHARED_FN float pq_encode_one(float cd_m2) {
#ifdef __cplusplus
    using namespace std;
    float y = fmin(fmax(cd_m2 / kPqMost_cd_m2, 0.0f), 1.0f);
#else
    float y = clamp(cd_m2 / kPqMost_cd_m2, 0.0f, 1.0f);
#endif
    float p = pow(y, kPqM1);
    return pow((kPqC1 + kPqC2 * p) / (1.0f + kPqC3 * p), kPqM2);
}

// The picture as the tone curve has it, linear Rec.2020 of the display, whose highlights go on above white where the
// curve ends: what is exposed brighter than white is as much brighter, up to the peak.
SHARED_FN vec3 shown_light(vec3 rec2020, float exposure, uint tone, float peak) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 exposed = max(rec2020 * exposure, vec3(0.0f));
    if (tone == kToneLinear) return min(exposed, vec3(peak));
    vec3 shown = tone == kToneAces ? tone_aces(exposed) : tone_agx(exposed);
    float over = luminance_of(exposed) - 1.0f, more = peak - 1.0f;
    float gain = over <= 0.0f || more <= 0.0f ? 1.0f : 1.0f + more * (1.0f - exp(-over / more));
    return min(shown * gain, vec3(peak));
}

// Linear Rec.2020 whose white is 1, as the surface has it.
SHARED_FN vec3 encode_light(vec3 light, uint encoding) {
    if (encoding == kEncodePq)
        return vec3(pq_encode_one(light.x * kWhite_cd_m2), pq_encode_one(light.y * kWhite_cd_m2), pq_encode_one(light.z * kWhite_cd_m2));
    if (encoding == kEncodeScrgb) return rec709_of_rec2020() * light * (kWhite_cd_m2 / kScrgbOne_cd_m2);
    return srgb_encode(rec709_of_rec2020() * light);
}

SHARED_END
#endif
