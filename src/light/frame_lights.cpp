// SPDX-License-Identifier: Apache-2.0
#include "light/frame_lights.h"

#include "shared/beam.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ghost::scene {
namespace {

using glm::vec3;

vec3 lens_of(const shared::Light& light) {
    return light.position_m + light.lens_m * light.axis_w;
}

bool same_split(const shared::Light& a, const shared::Light& b) {
    return a.split == b.split && a.split_soft == b.split_soft && a.colour_b == b.colour_b;
}

// Mean colour of what a beam between two colours sends, relative to the first.
vec3 mean_colour(const shared::Light& light) {
    if (light.split >= shared::kNoSplit) return vec3(1.0f);
    const float fraction = std::clamp(0.5f - light.split / shared::kSlotSpacing, 0.0f, 1.0f);
    return glm::mix(vec3(1.0f), light.colour_b, fraction);
}

} // namespace

vec3 hung_place_m(const BeamGroups& emitters, int place, const FixturePose& hung) {
    const vec3 aside_m = emitters.places_m[static_cast<std::size_t>(place)] - emitters.middle_m;
    return hung.middle_m + glm::mat3(hung.to_world) * aside_m;
}

std::vector<LensFace> faces_of(const fixture::Type& type, const std::vector<fixture::BeamState>& beams,
                               const glm::mat4& to_world, const GoboStack& gobos, ProfileTable& profiles,
                               const Projector* projector, const BeamShape* shape) {
    std::vector<LensFace> faces;
    for (std::size_t b = 0; b < beams.size(); ++b) {
        LensFace& face = faces.emplace_back();
        face.glows = only_glows(*type.geometries[static_cast<std::size_t>(beams[b].geometry)].beam);
        face.light = light_from(type, beams[b], to_world, gobos, profiles, projector, shape);
    }
    return faces;
}

shared::Light light_of(const BeamGroup& emitter, const std::vector<LensFace>& faces, const vec3& place_m) {
    const auto face_of = [&](std::size_t k) -> const shared::Light& {
        return faces[static_cast<std::size_t>(emitter.beams[k])].light;
    };
    shared::Light light = face_of(0);
    if (emitter.beams.size() > 1) {
        bool one_split = true;
        for (std::size_t k = 1; k < emitter.beams.size(); ++k)
            one_split = one_split && same_split(face_of(k), light);
        vec3 apex_m(0.0f), lens_m(0.0f), axis(0.0f), intensity_cd(0.0f), bounce_cd(0.0f);
        for (std::size_t k = 0; k < emitter.beams.size(); ++k) {
            const shared::Light& cell = face_of(k);
            apex_m += emitter.weights[k] * cell.position_m;
            lens_m += emitter.weights[k] * lens_of(cell);
            axis += emitter.weights[k] * cell.axis_w;
            intensity_cd += cell.intensity_cd * (one_split ? vec3(1.0f) : mean_colour(cell));
            bounce_cd += cell.bounce_cd;
        }
        // A disc of the same spread as the cells, which are discs themselves.
        float spread_m2 = 0.0f;
        for (std::size_t k = 0; k < emitter.beams.size(); ++k) {
            const vec3 aside_m = lens_of(face_of(k)) - lens_m;
            const float own_m = face_of(k).disc_radius_m;
            spread_m2 += emitter.weights[k] * (2.0f * glm::dot(aside_m, aside_m) + own_m * own_m);
        }
        light.disc_radius_m = std::sqrt(spread_m2);
        if (light.panel_m > 0) light.panel_m = light.disc_radius_m;
        light.intensity_cd = intensity_cd;
        light.bounce_cd = bounce_cd;
        if (!one_split) {
            light.split = shared::kNoSplit;
            light.colour_b = vec3(1.0f);
        }
        light.axis_w = glm::normalize(axis);
        light.axis_u = glm::normalize(light.axis_u - light.axis_w * glm::dot(light.axis_u, light.axis_w));
        // The gate keeps its handedness.
        const vec3 across = glm::cross(light.axis_u, light.axis_w);
        light.axis_v = glm::dot(across, light.axis_v) < 0.0f ? -across : across;
        light.lens_m = std::max(glm::dot(lens_m - apex_m, light.axis_w), 0.0f);
        light.position_m = apex_m;
    }
    if (glm::distance(light.position_m, place_m) < kOnPlace_m) light.position_m = place_m;
    light.off_map_m = light.position_m - place_m;
    return light;
}

} // namespace ghost::scene
