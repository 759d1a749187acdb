// SPDX-License-Identifier: Apache-2.0
// What is the same for all lights of a frame: how light weakens with distance (shared/attenuation.h), and where the haze is
// thicker or thinner than on average: slow swirls that the wind carries, and plumes of hazers. Density is relative, 1 on
// average; light is weakened on its way as by even haze. One definition for shaders and the reference.
#ifndef GHOST_SHARED_AIR_H
#define GHOST_SHARED_AIR_H
#include "shared/attenuation.h"
#include "shared/types.h"

SHARED_BEGIN

SHARED_CONST uint kMostHazers = 8u;

// A plume: a cone from the nozzle, thinning out with the square of its width up to its reach.
struct Plume {
    vec3 position_m;
    float rate;   // density 1 m before the nozzle, relative
    vec3 direction; // unit
    float spread; // tangent of half its angle
    float reach_m;
    float unused;
};
SHARED_SIZE(Plume, 40);

struct Air {
    Attenuation attenuation;
    float unevenness; // 0 even .. 1 from nothing to twice as thick
    vec3 drift_m;     // how far the wind has carried the haze
    float per_m;      // 2 pi / size of the swirls
    float churn;      // phase of their own slow motion
    uint hazers;
    Plume plume[kMostHazers];
};
SHARED_SIZE(Air, 360);

// Swirls: a few sine waves, bent by others (domain warping), -1..1, mean 0.
SHARED_FN float air_swirl(Air air, vec3 position_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 p = (position_m - air.drift_m) * air.per_m;
    vec3 q = p + vec3(1.1f * sin(0.63f * p.y + air.churn) + 0.5f * p.z, 1.0f * sin(0.71f * p.z + 1.3f * air.churn + 2.0f) - 0.4f * p.x,
                      0.9f * sin(0.57f * p.x - 0.8f * air.churn + 4.0f) + 0.3f * p.y);
    float large = sin(q.x) * sin(q.y + 1.0f) + sin(q.y * 1.1f + 2.0f) * sin(q.z + 0.5f) + sin(q.z * 0.9f) * sin(q.x * 1.2f + 3.0f);
    float fine = sin(2.3f * q.x + q.z) * sin(2.1f * q.y - q.x + 1.5f);
    return clamp((large + 0.7f * fine) * 0.45f, -1.0f, 1.0f);
}

// Mean over a piece of a ray: span_m long, round a place. dir: unit, of the ray. Waves fade as they do for a normal distribution
// as wide as the piece (1.4: they run aslant of the axes); a plume gets wider along the ray.
SHARED_FN float air_density_along(Air air, vec3 position_m, vec3 dir, float span_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    float waves = 1.4f * span_m * air.per_m;
    float density = 1.0f + air.unevenness * air_swirl(air, position_m) * exp(-waves * waves / 24.0f);
    for (uint k = 0u; k < air.hazers; ++k) {
        Plume plume = air.plume[k];
        vec3 way = position_m - plume.position_m;
        float ahead = dot(way, plume.direction);
        float width = max(ahead, 0.0f) * plume.spread + 0.05f;
        vec3 aside = way - ahead * plume.direction;
        vec3 across = dir - dot(dir, plume.direction) * plume.direction;
        float crossing = dot(across, across); // squared sine of the two ways
        float along2 = dot(aside, across) * dot(aside, across) / max(crossing, 1e-6f);
        float widened = width * width + crossing * span_m * span_m / 3.0f;
        float aside2 = max(dot(aside, aside) - along2, 0.0f) / (width * width) + along2 / widened;
        float width1 = plume.spread + 0.05f;
        float fade = clamp(1.0f - ahead / plume.reach_m, 0.0f, 1.0f);
        float extra = max(plume.rate - 1.0f, 0.0f) * (width1 * width1) / (width * sqrt(widened)) * exp(-2.0f * aside2) * fade;
        density += ahead > 0.0f ? min(extra, 4.0f * plume.rate) : 0.0f;
    }
    return density;
}

SHARED_FN float air_density(Air air, vec3 position_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    return air_density_along(air, position_m, vec3(1.0f, 0.0f, 0.0f), 0.0f);
}

SHARED_END
#endif
