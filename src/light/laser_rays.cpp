// SPDX-License-Identifier: Apache-2.0
#include "light/laser_rays.h"

#include "beam_groups/prism.h"
#include "shared/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ghost::scene {
namespace {

using glm::vec2;

constexpr float kLeastLens_m = 0.01f; // before the apex
// Of the gate, round a figure: room for its blur, in haze's table too.
constexpr float kMargin = 0.06f;
constexpr float kDeviations = 4.0f; // of its cross-section, at least
// A circle is as high as that, and no flatter.
constexpr float kFlattest = 0.1f;
constexpr float kLeast_deg = 0.1f;   // of a curve that is no point
constexpr float kFigureEdge = 1e-5f; // nothing has an edge there, but blur is divided by

vec2 half_tangents(const fixture::LaserCurve& figure) {
    return glm::tan(0.5f *
                    glm::radians(glm::clamp(figure.size_deg, vec2(0.0f), vec2(fixture::kWidestFigure_deg))));
}

vec2 turned_by_deg(const vec2& at, float deg) {
    const float c = std::cos(glm::radians(deg)), s = std::sin(glm::radians(deg));
    return {c * at.x - s * at.y, s * at.x + c * at.y};
}

// From -1 to 1.
float place(int index, int count) {
    return count > 1 ? 2.0f * static_cast<float>(index) / static_cast<float>(count - 1) - 1.0f : 0.0f;
}

// Even in angle, as a scanner is driven.
vec2 way_to(const fixture::LaserCurve& figure, const vec2& fraction) {
    return glm::tan(0.5f * glm::radians(figure.size_deg) * fraction);
}

std::vector<vec2> ways_of(const fixture::LaserCurve& figure) {
    const int count = std::clamp(figure.count, 1, fixture::kMostRays);
    std::vector<vec2> ways;
    if (figure.kind == fixture::LaserCurveKind::grid) {
        // As many columns and rows as look even, every row full.
        const vec2 size = glm::max(figure.size_deg, vec2(1e-3f));
        const int columns = std::clamp(
            static_cast<int>(std::lround(std::sqrt(static_cast<float>(count) * size.x / size.y))), 1, count);
        const int rows = std::max(count / columns, 1);
        for (int k = 0; k < columns * rows; ++k)
            ways.push_back(way_to(figure, {place(k % columns, columns), place(k / columns, rows)}));
        return ways;
    }
    for (int k = 0; k < count; ++k) {
        const float angle = 2.0f * shared::kPi * static_cast<float>(k) / static_cast<float>(count);
        ways.push_back(figure.kind == fixture::LaserCurveKind::ring
                           ? half_tangents(figure) * vec2(std::cos(angle), std::sin(angle))
                           : way_to(figure, {place(k, count), 0.0f}));
    }
    return ways;
}

} // namespace

std::vector<Copy> rays_of(const fixture::LaserCurve& figure, float tan_field) {
    if (figure.kind == fixture::LaserCurveKind::beam) return {Copy{}};
    std::vector<Copy> rays;
    const std::vector<vec2> ways = ways_of(figure);
    const glm::vec3 fraction(1.0f / static_cast<float>(ways.size()));
    for (const vec2& way : ways) rays.push_back({turned_by_deg(way, figure.deg) / tan_field, 1.0f, fraction});
    return rays;
}

shared::Light swept(const shared::Light& beam, const fixture::LaserCurve& figure) {
    using fixture::LaserCurveKind;
    vec2 half = half_tangents(figure);
    const float least = std::tan(0.5f * glm::radians(kLeast_deg));
    const bool is_circle = figure.kind == LaserCurveKind::circle;
    if (std::max(half.x, is_circle ? half.y : 0.0f) < least) return beam;
    // Standard deviation of a round beam, across: half its radius.
    const float deviation = 0.5f * beam.tan_field;
    if (is_circle) half = glm::max(half, vec2(kFlattest * std::max(half.x, half.y)));
    if (figure.kind == LaserCurveKind::line) half.y = 0.0f;
    const float reach = is_circle ? std::max(half.x, half.y) : glm::length(half);
    shared::Light light = beam;
    light.tan_field = (reach + kDeviations * deviation) / (1.0f - kMargin);
    light.cut_radius = 1.0f;
    light.iris_radius = 2.0f;
    light.edge = kFigureEdge;
    light.profile_power = 1.0f;
    light.profile_scale = 0.0f;
    light.wheel_count = light.shaped = 0;
    light.split = shared::kNoSplit;
    light.colour_b = glm::vec3(1.0f);
    // As thick as at its lens wherever it goes, and wider by its divergence.
    light.lens_radius_m = beam.disc_radius_m;
    light.focus_per_m = 0.0f;
    // Swept from its lens, where the round beam's own apex lies far behind.
    light.lens_m = std::max(light.lens_radius_m / light.tan_field, kLeastLens_m);
    const glm::vec3 moved_m = (beam.lens_m - light.lens_m) * light.axis_w;
    light.position_m += moved_m;
    light.off_map_m += moved_m;
    shared::LaserCurve& curve = light.figure;
    curve.kind = is_circle                             ? shared::kCircleFigure
                 : figure.kind == LaserCurveKind::wave ? shared::kWaveFigure
                                                       : shared::kLineFigure;
    curve.half_size = half / light.tan_field;
    curve.cosine = std::cos(glm::radians(figure.deg));
    curve.sine = std::sin(glm::radians(figure.deg));
    curve.deviation = deviation / light.tan_field;
    curve.phase = -2.0f * shared::kPi * figure.phase;
    curve.waves = static_cast<float>(std::clamp(figure.count, 1, fixture::kMostRays));
    // The lumens stay: those of the round beam, over what the curve spreads them.
    const float lumens_per_cd =
        4.0f * shared::kPi * std::max({beam.bounce_cd.x, beam.bounce_cd.y, beam.bounce_cd.z}) /
        std::max({beam.intensity_cd.x, beam.intensity_cd.y, beam.intensity_cd.z, 1e-12f});
    const float area =
        shared::kFigureWidth * shared::figure_length(curve) * light.tan_field * light.tan_field;
    light.intensity_cd = beam.intensity_cd * lumens_per_cd *
                         (shared::figure_slant(light.tan_field, light.cut_radius * light.cut_radius) / area);
    return light;
}

} // namespace ghost::scene
