#version 460
// SPDX-License-Identifier: Apache-2.0
// What stands on a surface: the picture where it lies, black beside it, and over it marks and figures, premultiplied and sRGB.
// On sRGB surfaces these are blended as they are, as a window does it, else as light.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/present.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray picture;
layout(binding = 1) uniform sampler2DArray overlay;
layout(binding = 2) writeonly uniform image2DArray surface;
layout(push_constant, scalar) uniform Push { PresentPush p; };

vec3 picture_at(ivec2 at) {
    vec2 place = vec2(at) + 0.5 - p.place;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThanEqual(place, p.size))) return vec3(0.0);
    if (p.exact == 1u) return texelFetch(picture, ivec3(ivec2(place), 0), 0).rgb;
    vec3 sum = vec3(0.0);
    for (uint y = 0u; y < p.taps; ++y)
        for (uint x = 0u; x < p.taps; ++x) {
            vec2 within = (vec2(x, y) + 0.5) / float(p.taps) - 0.5;
            sum += textureLod(picture, vec3((place + within) / p.size, 0.0), 0.0).rgb;
        }
    return sum / float(p.taps * p.taps);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(surface).xy))) return;
    vec4 over = p.covers == 1u ? texelFetch(overlay, ivec3(at, 0), 0) : vec4(0.0);
    vec3 shown = picture_at(at);
    if (p.encoding == kEncodeSrgb) {
        if (p.light == 1u) shown = encode_light(shown, kEncodeSrgb);
        shown = shown * (1.0 - over.a) + over.rgb;
    } else {
        if (p.light == 0u) shown = rec2020_of_rec709() * srgb_decode(shown);
        vec3 above = over.a > 0.0 ? rec2020_of_rec709() * srgb_decode(min(over.rgb / over.a, vec3(1.0))) : vec3(0.0);
        shown = encode_light(mix(shown, above, over.a), p.encoding);
    }
    imageStore(surface, ivec3(at, 0), vec4(p.swaps == 1u ? shown.bgr : shown, 1.0));
}
