// SPDX-License-Identifier: Apache-2.0
// The material that a pixel shows, as the baker evaluates it (rays/tracer.cpp): base colour, roughness, metalness,
// specular, emission and the shading normal towards the viewer. With CUT defined, masked and blended surfaces leave samples
// out; a shader that may do so loses the early depth test, so opaque surfaces have one of their own.
#include "shared/g_buffer.h"

#ifdef CUT
layout(constant_id = 0) const uint kAlpha = kMask;
#endif
layout(constant_id = 1) const uint kTextures = 0u;
layout(constant_id = 2) const uint kOfPixel = kSamples; // samples: all of them or one
layout(location = 0) centroid in vec3 in_normal;
layout(location = 1) centroid in vec4 in_tangent;
layout(location = 2) centroid in vec2 in_uv;
layout(location = 3) flat in uint mirrored;
layout(location = 4) flat in float glow;
layout(location = 0) out vec4 out_base;     // base colour, roughness
layout(location = 1) out vec4 out_normal;   // octahedral normal; change of depth per pixel right and down, by the depth
layout(location = 2) out vec4 out_emission; // emission, specular
layout(location = 3) out float out_metalness;
layout(binding = 0) uniform sampler2DArray base_texture;
layout(binding = 1) uniform sampler2DArray normal_texture;
layout(binding = 2) uniform sampler2DArray surface_texture;
layout(binding = 3) uniform sampler2DArray emission_texture;
layout(binding = 4, scalar) uniform Material { MeshMaterial p; };

const float kMostEmission = 65000.0;
// Rec.709 to Rec.2020 (ITU-R BT.2087).
const mat3 kToWorking = mat3(0.6274039, 0.0690973, 0.0163914, 0.3292830, 0.9195404, 0.0880133, 0.0433131, 0.0113623, 0.8955953);

uint hash(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

vec3 unit_or(vec3 v, vec3 fallback) {
    float length2 = dot(v, v);
    return length2 > 1e-20 ? v * inversesqrt(length2) : fallback;
}

vec2 octahedral(vec3 n) {
    vec2 at = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = (1.0 - abs(at.yx)) * vec2(at.x < 0.0 ? -1.0 : 1.0, at.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? folded : at;
}

void main() {
    float depth = gl_FragCoord.z;
    vec2 slope = vec2(dFdx(depth), dFdy(depth)) / max(depth, 1e-12);
    vec3 at = vec3(in_uv, 0.0);
    vec4 base = vec4(p.base_colour, p.alpha);
    if ((kTextures & kBaseTexture) != 0u) {
        vec4 texel = texture(base_texture, at);
        base *= vec4(kToWorking * texel.rgb, texel.a);
    }
#ifdef CUT
    // A mask's edge is one pixel wide. A blended surface takes as many samples as its alpha says, between two
    // numbers by chance, and which ones by chance too: layers behind each other are independent.
    uint chance = hash(hash(hash(uint(gl_FragCoord.x)) ^ uint(gl_FragCoord.y)) ^ p.seed ^ floatBitsToUint(gl_FragCoord.z));
    float fraction = base.a;
    float between = float(chance >> 8) / 16777216.0;
    if (kAlpha == kMask) {
        fraction = (base.a - p.alpha_cutoff) / max(fwidth(base.a), 1e-4) + 0.5;
        between = 0.5;
    }
    uint count = uint(clamp(fraction, 0.0, 1.0) * float(kOfPixel) + between);
    count = min(count, kOfPixel);
    uint bits = (1u << count) - 1u;
    uint turn = chance & (kOfPixel - 1u);
    bits = ((bits << turn) | (bits >> (kOfPixel - turn))) & ((1u << kOfPixel) - 1u);
    gl_SampleMask[0] = int(bits);
#endif
    float roughness = p.roughness;
    float metalness = p.metalness;
    if ((kTextures & kSurfaceTexture) != 0u) {
        vec4 texel = texture(surface_texture, at);
        roughness *= texel.g;
        metalness *= texel.b;
    }
    vec3 emission = p.emission;
    if ((kTextures & kEmissionTexture) != 0u) emission *= kToWorking * texture(emission_texture, at).rgb;
    emission += glow;

    bool behind = gl_FrontFacing == (mirrored != 0u);
    vec3 front = unit_or(in_normal, vec3(0.0, 0.0, 1.0));
    vec3 normal = front;
    if ((kTextures & kNormalTexture) != 0u) {
        vec3 tangent = unit_or(in_tangent.xyz - front * dot(front, in_tangent.xyz), vec3(0.0));
        vec3 bitangent = cross(front, tangent) * (in_tangent.w < 0.0 ? -1.0 : 1.0);
        vec4 texel = texture(normal_texture, at);
        vec3 map = texel.rgb * 2.0 - 1.0;
        // Bumps too small to be seen scatter as a rougher surface does: alpha holds the root of the variance of their slopes,
        // of which a Beckmann lobe has half its alpha squared (Toksvig 2005).
        float spread = texel.a * p.normal_scale;
        float alpha = roughness * roughness;
        roughness = sqrt(sqrt(alpha * alpha + 2.0 * spread * spread));
        normal = unit_or((tangent * map.x + bitangent * map.y) * p.normal_scale + front * max(map.z, 0.01), front);
    }
    out_base = vec4(max(base.rgb, vec3(0.0)), clamp(roughness, 0.0, 1.0));
    out_normal = vec4(octahedral(behind ? -normal : normal), clamp(slope, vec2(-1e3), vec2(1e3)));
    out_emission = vec4(clamp(emission, vec3(0.0), vec3(kMostEmission)), p.specular);
    out_metalness = clamp(metalness, 0.0, 1.0);
}
