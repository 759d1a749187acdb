// SPDX-License-Identifier: Apache-2.0
// The shader side of gobo_sample and slide_sample (shared/beam.h): the stack of shared/gobos.h as a texture array, the moving pictures
// as another at binding SLIDES.
layout(binding = 0) uniform sampler2DArray gobo_stack;

const float kGoboBlurUnit = 2.0 / 256.0;
const float kGoboTopLevel = 6.0;
const mat3 kRec2020FromRec709 = mat3(0.627404, 0.069097, 0.016391, 0.329283, 0.919540, 0.088013, 0.043313, 0.011362, 0.895595);

// Where neighbouring samples are averaged anyway (haze), a level is rounded up or down at random instead of blended: 0..1.
// Below zero the levels are blended.
float gobo_dither = -1.0;

// The mip level of a blur, for shaders that know it outside their loops: they define GOBO_LEVEL and set it, to kLevelOfBlur where
// they do not.
#ifdef GOBO_LEVEL
const float kLevelOfBlur = -1.0;
const float kWholeLevelOfBlur = -2.0; // the nearest: half the work
float gobo_level = 0.0;
#endif

float gobo_level_of(float blur) { return clamp(log2(max(blur / kGoboBlurUnit, 1.0)), 0.0, kGoboTopLevel); }

vec3 gobo_sample(uint layer, vec2 gate, float blur) {
    vec2 uv = gate * vec2(0.5, -0.5) + 0.5;
#ifdef GOBO_LEVEL
    float level = gobo_level_of(blur);
    float known = gobo_level >= 0.0 ? gobo_level : gobo_level == kLevelOfBlur ? level : floor(level + 0.5);
    return textureLod(gobo_stack, vec3(uv, float(layer)), known).rgb;
#else
    float level = gobo_level_of(blur);
    level = gobo_dither < 0.0 ? level : floor(level + gobo_dither);
    return textureLod(gobo_stack, vec3(uv, float(layer)), level).rgb;
#endif
}

layout(binding = SLIDES) uniform sampler2DArray slides; // sRGB, decoded where it is sampled; square, level n averages 2^n texels

#ifdef GOBO_LEVEL
float slide_level = kLevelOfBlur;
#endif

float slide_level_of(float radius_texels) { return log2(max(radius_texels, 1.0)); }

vec3 slide_sample(uint layer, vec2 place, float radius_texels) {
    vec3 uv = vec3(place * vec2(0.5, -0.5) + 0.5, float(layer - 1u));
#ifdef GOBO_LEVEL
    float known = slide_level == kLevelOfBlur ? slide_level_of(radius_texels) : slide_level;
    return kRec2020FromRec709 * textureLod(slides, uv, known).rgb;
#else
    return kRec2020FromRec709 * textureLod(slides, uv, slide_level_of(radius_texels)).rgb;
#endif
}
