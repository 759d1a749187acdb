// SPDX-License-Identifier: Apache-2.0
// The shader side of gobo_sample (shared/beam.h): the stack of shared/gobos.h as a texture array.
layout(binding = 0) uniform sampler2DArray gobo_stack;

const float kGoboBlurUnit = 2.0 / 256.0;
const float kGoboTopLevel = 6.0;

// Where neighbouring samples are averaged anyway (haze), a level is rounded up or down at random instead of blended: 0..1.
// Below zero the levels are blended.
float gobo_dither = -1.0;

// The mip level of a blur, for shaders that know it outside their loops: they define GOBO_LEVEL and set it, to kLevelOfBlur where
// they do not.
#ifdef GOBO_LEVEL
const float kLevelOfBlur = -1.0;
float gobo_level = 0.0;
#endif

float gobo_level_of(float blur) { return clamp(log2(max(blur / kGoboBlurUnit, 1.0)), 0.0, kGoboTopLevel); }

vec3 gobo_sample(uint layer, vec2 gate, float blur) {
    vec2 uv = gate * vec2(0.5, -0.5) + 0.5;
#ifdef GOBO_LEVEL
    float known = gobo_level == kLevelOfBlur ? gobo_level_of(blur) : gobo_level;
    return textureLod(gobo_stack, vec3(uv, float(layer)), known).rgb;
#else
    float level = gobo_level_of(blur);
    level = gobo_dither < 0.0 ? level : floor(level + gobo_dither);
    return textureLod(gobo_stack, vec3(uv, float(layer)), level).rgb;
#endif
}
