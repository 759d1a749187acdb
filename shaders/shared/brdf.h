// SPDX-License-Identifier: Apache-2.0
// Metallic-roughness reflection as glTF 2.0 (appendix B) defines it: Lambert under a GGX layer, height-correlated Smith masking
// (Heitz 2014), Schlick's Fresnel with F0 = 0.04. The only definition; the baker and the live renderer both call it.
// All vectors are unit and point away from the surface.
#ifndef GHOST_SHARED_BRDF_H
#define GHOST_SHARED_BRDF_H
#include "shared/types.h"

SHARED_BEGIN

struct Brdf {
    vec3 diffuse; // albedo of the Lambert layer before Fresnel
    real alpha;   // squared perceptual roughness
    vec3 f0;      // reflectance at normal incidence
    real f90;     // and at grazing incidence
};
SHARED_SIZE(Brdf, 32);

// specular scales the dielectric reflection (KHR_materials_specular): 0 leaves pure Lambert.
SHARED_FN Brdf brdf_of(vec3 base_colour, real roughness, real metalness, real specular) {
#ifdef __cplusplus
    using namespace glm;
#endif
    Brdf brdf;
    brdf.diffuse = base_colour * (1.0f - metalness);
    // Below this the highlight of a point source is smaller than any pixel: it would only sparkle.
    real clamped = max(roughness, 0.06f);
    brdf.alpha = clamped * clamped;
    brdf.f0 = mix(vec3(0.04f * specular), base_colour, metalness);
    brdf.f90 = mix(specular, 1.0f, metalness);
    return brdf;
}

// Reflected radiance per unit of radiance times solid angle: f(l, v) cos(n, l).
SHARED_FN vec3 brdf_times_cosine(Brdf brdf, vec3 n, vec3 v, vec3 l) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real nl = dot(n, l);
    real nv = max(abs(dot(n, v)), 1e-4f);
    vec3 h = normalize(l + v);
    real nh = clamp(dot(n, h), 0.0f, 1.0f);
    real vh = clamp(dot(v, h), 0.0f, 1.0f);
    real a2 = brdf.alpha * brdf.alpha;
    real d = nh * nh * (a2 - 1.0f) + 1.0f;
    real distribution = a2 / (kPi * d * d);
    real visibility = 0.5f / (nl * sqrt(nv * nv * (1.0f - a2) + a2) + nv * sqrt(nl * nl * (1.0f - a2) + a2));
    real away = 1.0f - vh;
    real away2 = away * away;
    vec3 fresnel = brdf.f0 + (vec3(brdf.f90) - brdf.f0) * (away2 * away2 * away);
    vec3 value = (vec3(1.0f) - fresnel) * brdf.diffuse * (1.0f / kPi) + fresnel * (distribution * visibility);
    return select(nl > 0.0f, value * nl, vec3(0.0f));
}

// Fraction of even light from everywhere that leaves towards v: Lambert plus the fit of the split-sum integral by Karis (2014).
SHARED_FN vec3 brdf_albedo(Brdf brdf, real nv) {
#ifdef __cplusplus
    using namespace glm;
#endif
    real rough = sqrt(brdf.alpha);
    real r0 = 1.0f - rough;
    real r1 = 0.0425f - 0.0275f * rough;
    real r2 = 1.04f - 0.572f * rough;
    real r3 = 0.022f * rough - 0.04f;
    real a = min(r0 * r0, exp2(-9.28f * clamp(nv, 0.0f, 1.0f))) * r0 + r1;
    real scale = -1.04f * a + r2;
    real bias = 1.04f * a + r3;
    vec3 mirror = clamp(brdf.f0 * scale + vec3(brdf.f90 * bias), vec3(0.0f), vec3(1.0f));
    return brdf.diffuse * (vec3(1.0f) - mirror) + mirror;
}

SHARED_END
#endif
