// SPDX-License-Identifier: Apache-2.0
#include "light/projector_beam.h"

#include "light/private/gate.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using glm::mat3;
using glm::vec2;
using glm::vec3;

constexpr float kLeastBlend = 1e-4f;
constexpr float kEdge = 0.002f;    // gate radii: a pixel of a panel of 1000
constexpr float kSpill = 0.05f;    // gate radii beyond the corners, for what is out of focus: at least
constexpr float kMostSpill = 3.0f; // and at most
constexpr int kFitSteps = 30;

// Columns: where the picture's x, y and middle lie, as directions before the lens, z along the optical axis.
mat3 picture_plane(const Projector& projector, const vec2& half, const vec3& middle, float picture_aspect) {
    const vec2 turn = glm::radians(projector.keystone_deg);
    const vec3 right(std::cos(turn.x), 0.0f, std::sin(turn.x));
    // Up, on a plane that leans about the turned right.
    const vec3 ahead(-std::sin(turn.x), 0.0f, std::cos(turn.x));
    const vec3 up = std::cos(turn.y) * vec3(0, 1, 0) + std::sin(turn.y) * ahead;
    const float panel_aspect = half.x / half.y;
    vec2 size = half;
    const float ratio = picture_aspect / panel_aspect;
    if (projector.fit == Fit::contain) size *= ratio > 1.0f ? vec2(1.0f, 1.0f / ratio) : vec2(ratio, 1.0f);
    if (projector.keystone_deg == vec2(0.0f)) return {size.x * vec3(1, 0, 0), size.y * vec3(0, 1, 0), middle};
    // As large as its corners stay on the panel.
    float low = 0.0f, high = 2.0f;
    for (int step = 0; step < kFitSteps; ++step) {
        const float scale = 0.5f * (low + high);
        bool inside = true;
        for (int corner = 0; corner < 4; ++corner) {
            const vec3 at = middle + scale * ((corner % 2 ? 1.0f : -1.0f) * size.x * right +
                                              (corner / 2 ? 1.0f : -1.0f) * size.y * up);
            inside = inside && at.z > 0.05f && std::abs(at.x / at.z - middle.x) <= half.x &&
                     std::abs(at.y / at.z - middle.y) <= half.y;
        }
        (inside ? low : high) = scale;
    }
    return {low * size.x * right, low * size.y * up, middle};
}

void put_rows(const mat3& matrix, vec3 (&rows)[3]) {
    for (int k = 0; k < 3; ++k) rows[k] = vec3(matrix[0][k], matrix[1][k], matrix[2][k]);
}

} // namespace

float throw_ratio_for(float diagonal_deg, float aspect) {
    const float half_diagonal = std::tan(0.5f * glm::radians(std::clamp(diagonal_deg, 0.1f, 170.0f)));
    return 0.5f * std::sqrt(1.0f + 1.0f / (aspect * aspect)) / half_diagonal;
}

Throw throw_of(const Projector& projector, float throw_ratio, const MediaNow& now) {
    const float half_width = 0.5f / throw_ratio;
    const vec2 half(half_width, half_width / projector.aspect); // tangents
    const vec3 middle(2.0f * projector.lens_shift * half, 1.0f);

    Throw result;
    // The shortest turn from the optical axis to the panel's middle.
    const vec3 w = glm::normalize(middle);
    const vec3 u = glm::normalize(vec3(1, 0, 0) - w * w.x);
    const vec3 v = glm::cross(w, u);
    result.turn = mat3(u, v, w);
    float most = 0.0f, brightest = 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const vec3 way = middle + vec3(corner % 2 ? half.x : -half.x, corner / 2 ? half.y : -half.y, 0.0f);
        const vec3 at = glm::transpose(result.turn) * way;
        most = std::max(most, glm::length(vec2(at)) / at.z);
        brightest = std::max(brightest, glm::length(way));
    }
    result.tan_field = most;
    // Illuminance is even over the panel's picture: candela grow with the cube of 1 / cosine from the optical
    // axis.
    brightest = brightest * brightest * brightest;
    result.solid_angle = 4.0f * half.x * half.y / brightest;

    const mat3 to_way = result.turn * mat3(vec3(most, 0, 0), vec3(0, most, 0), vec3(0, 0, 1));
    const mat3 to_panel(vec3(1.0f / half.x, 0, 0), vec3(0, 1.0f / half.y, 0),
                        vec3(-middle.x / half.x, -middle.y / half.y, 1.0f));
    shared::Slide& slide = result.slide;
    put_rows(std::cbrt(brightest) * (to_panel * to_way), slide.panel);
    const float picture_aspect = now.extent.x / std::max(now.extent.y, 1e-6f);
    put_rows(glm::inverse(picture_plane(projector, half, middle, picture_aspect)) * to_way, slide.picture);
    for (int k = 0; k < 4; ++k)
        slide.blend[k] = projector.blend[k] > kLeastBlend ? 0.5f / projector.blend[k] : 0.0f;
    slide.extent = now.extent;
    // The panel shows as much of the picture as it has the shape for.
    const float ratio = picture_aspect / projector.aspect;
    if (projector.fit == Fit::cover)
        slide.extent *= ratio > 1.0f ? vec2(1.0f / ratio, 1.0f) : vec2(1.0f, ratio);
    slide.black = 1.0f / std::max(projector.contrast, 1.0f);
    const float per_gate = glm::length(vec2(slide.picture[0])) / std::max(slide.picture[2].z, 1e-3f);
    slide.texel = 2.0f / (static_cast<float>(now.side) * std::max(per_gate * slide.extent.x, 1e-6f));
    return result;
}

float project(const Projector& projector, const fixture::Optics& optics, const MediaNow& now,
              std::uint32_t layer, shared::Light& light) {
    const float throw_ratio = projector.throw_ratio > 0 ? projector.throw_ratio
                                                        : throw_ratio_for(optics.zoom_deg, projector.aspect);
    const Throw made = throw_of(projector, throw_ratio, now);
    const mat3 axes = mat3(light.axis_u, light.axis_v, light.axis_w) * made.turn;
    light.axis_u = axes[0];
    light.axis_v = axes[1];
    light.axis_w = axes[2];
    light.tan_field = made.tan_field;
    // Frost blurs over a disc of twice its standard deviation, as with any beam.
    const float frost = std::tan(glm::radians(optics.frost * optics.frost_full_deg)) / made.tan_field;
    light.edge = kEdge + 2.0f * frost;
    if (projector.focus_m > 0) light.focus_per_m = 1.0f / projector.focus_m;
    // What is focused near is blurred this wide far away.
    const float far_blur = light.lens_radius_m * light.focus_per_m / light.tan_field;
    light.cut_radius = 1.0f + std::min(light.edge + std::max(far_blur, kSpill), kMostSpill);
    light.profile_power = 1.0f;
    light.profile_scale = 0.0f;
    light.iris_radius = optics.iris < kOpenIris ? std::max(optics.iris, kLeastIris) : 2.0f * light.cut_radius;
    light.slide = made.slide;
    light.slide.layer = layer + 1;
    light.slide.moment = now.moment;
    return made.solid_angle;
}

glm::vec3 picture_transmittance(const Projector& projector, const MediaNow& now) {
    const float ratio = now.extent.x / std::max(now.extent.y, 1e-6f) / projector.aspect;
    const float area = projector.fit == Fit::contain ? std::min(ratio, 1.0f / ratio) : 1.0f;
    const float black = 1.0f / std::max(projector.contrast, 1.0f);
    return glm::mix(now.mean * area, vec3(1.0f), black);
}

} // namespace ghost::scene
