// SPDX-License-Identifier: Apache-2.0
#include "render/haze/fan.h"

#include "shared/figure.h"
#include "shared/gobos.h"
#include "shared/optics.h"

#include <algorithm>
#include <cmath>

namespace ghost::render {
namespace {

constexpr double kNearest_m = 1e-3; // an eye in the lamp itself
constexpr float kFanStep = 32;      // sizes can be halved
constexpr double kParallel = 1e-6;  // sine below which pole and axis are one line
// Nearer to the rim rows that are even in the sine lie thin at their ends: the two ways are alike here.
constexpr double kNearRim = 1.05;
constexpr float kThin_pixels = 2.0f;
constexpr double kDeepInside = 0.7; // from here to the rim more and more rows lie where the beam is

// A Gaussian is sampled evenly where its standard deviation is three quarters of a column (to 0.01 %).
constexpr float kFigureBlur = 1.5f;

// Rows for a pixel of the width of an open beam: it has no detail but its rim.
constexpr float kOpenRows = 0.5f;

bool is_open(const shared::Light& light) {
    return light.wheel_count == 0 && light.shaped == 0 && light.slide.layer == 0 &&
           light.figure.kind == shared::kNoFigure;
}

std::uint32_t size_of(const shared::Light& light, const BeamExtent& extent, FanDetail detail) {
    const bool figure = light.figure.kind != shared::kNoFigure;
    // A moving picture counts as a gobo.
    const FanDetail wanted = light.shaped != 0 ? detail : FanDetail::fine;
    const float per_pixel = is_open(light) ? kOpenRows : rows_per_pixel(wanted);
    const float rows = std::ceil(per_pixel * extent.widest_pixels() / kFanStep) * kFanStep;
    const bool large = extent.surrounds || rows > 2.0f * shared::kFinestFan;
    const std::uint32_t finest = is_open(light) || light.shaped != 0 ? shared::kFinestNode
                                 : large || figure                   ? shared::kFinestFan
                                                                     : shared::kMiddleFan;
    if (extent.surrounds) return finest;
    return std::clamp(static_cast<std::uint32_t>(rows), shared::kLeastSharp, finest);
}

// Rows of the shade for a pixel of the beam's width: kFarFraction of them lie in the beam.
constexpr float kShadeRows = 2;
constexpr std::uint32_t kMostShadeHalvings = 3;

void set_shade(shared::Fan& fan, const BeamExtent& extent, ShadeDetail detail) {
    if (detail == ShadeDetail::coarse) fan.coarse_shade = 1;
    if (detail == ShadeDetail::full || extent.surrounds) return;
    const float wanted = kShadeRows * extent.widest_pixels();
    while (fan.coarse_shade < kMostShadeHalvings &&
           static_cast<float>(shared::fan_shade_rows(fan)) / 2 >= wanted)
        ++fan.coarse_shade;
}

constexpr double kShadeFrom_m =
    0.05;                    // before the lens; nearer, what is in the way may be beside the shade's cone
constexpr double kFar_m = 1; // before the lens: from here on the beam has kFarShare of the shade's columns
constexpr double kFarFraction = 0.6;
constexpr double kWidestShade = 4; // tangent
constexpr double kAround =
    1.05; // of the beam's own tangent, so that its rim is not in the shade's last rows and columns
constexpr double kMostBend = 30;

// Tangent of the beam's rim so far before the lens, seen from the distance map's place.
double tangent_from_map(const shared::Light& light, double tangent, double before_m) {
    using glm::dvec3;
    const dvec3 axis(light.axis_w);
    const dvec3 lens = dvec3(light.off_map_m) + double{light.lens_m} * axis; // from the map's place
    const double ahead = glm::dot(lens, axis);
    const double radius = (double{light.lens_m} + before_m) * tangent + glm::length(lens - ahead * axis);
    return std::clamp(radius / std::max(ahead + before_m, 0.5 * before_m), tangent * kAround,
                      std::max(tangent * kAround, kWidestShade));
}

// Bend (shared::fan_bent) that gives kFarShare of all places to this fraction of them.
float bend_for(double fraction) {
    return static_cast<float>(
        std::clamp((kFarFraction / std::max(fraction, 1e-6) - 1) / (1 - kFarFraction), 0.0, kMostBend));
}

// Planes through a place, for the cone of this tangent about the axis.
shared::Planes planes_of(const glm::dvec3& place_m, const shared::Light& light, const glm::vec3& eye_m,
                         double tangent) {
    using glm::dvec3;
    const dvec3 axis(light.axis_w);
    dvec3 pole = dvec3(eye_m) - place_m;
    double distance_m = glm::length(pole);
    if (distance_m < kNearest_m) {
        distance_m = kNearest_m;
        pole = dvec3(light.axis_u);
    } else {
        pole /= distance_m;
    }
    const double cosine = std::clamp(glm::dot(pole, axis), -1.0, 1.0);
    dvec3 along = axis - cosine * pole;
    double sine = glm::length(along);
    if (sine < kParallel) {
        along = dvec3(light.axis_u) - glm::dot(dvec3(light.axis_u), pole) * pole;
        along = glm::normalize(along);
        sine = 0;
    } else {
        along /= sine;
    }
    const double cos_cone = 1.0 / std::sqrt(1.0 + tangent * tangent);
    const double sin_cone = tangent * cos_cone;
    const double fraction =
        std::min(sin_cone / std::max(sine, 1e-9), 1.0); // sine of the last meridian, or all

    shared::Planes planes{};
    planes.pole = glm::vec3(pole);
    planes.eye_m = static_cast<float>(distance_m);
    planes.along = glm::vec3(along);
    planes.cos_axis = static_cast<float>(cosine);
    planes.across = glm::vec3(glm::cross(pole, along));
    planes.sin_axis = static_cast<float>(sine);
    planes.cos_cone = static_cast<float>(cos_cone);
    planes.sin_cone = static_cast<float>(sin_cone);
    if (sine > sin_cone * kNearRim)
        planes.row_scale = static_cast<float>(sine / sin_cone);
    else if (fraction < 1)
        planes.row_scale = -1.0f / shared::fan_turn(static_cast<float>(std::sqrt(1 - fraction * fraction)),
                                                    static_cast<float>(fraction));
    else
        planes.row_scale = -static_cast<float>(1 + 0.9 * glm::smoothstep(kDeepInside, 1.0, sine / sin_cone));
    return planes;
}

} // namespace

shared::Fan make_fan(const shared::Light& light, const glm::vec3& eye_m, float pixels_per_rad, float reach_m,
                     FanDetail detail, std::uint32_t layer, ShadeDetail shade) {
    const glm::dvec3 apex_m(light.position_m);
    const double tangent = static_cast<double>(light.tan_field) * static_cast<double>(light.cut_radius);
    shared::Fan fan{};
    fan.beam = planes_of(apex_m, light, eye_m, tangent);
    const double widest = tangent_from_map(light, tangent, kShadeFrom_m);
    const double far = std::min(tangent_from_map(light, tangent, kFar_m), widest);
    fan.shade = planes_of(apex_m - glm::dvec3(light.off_map_m), light, eye_m, widest);
    fan.column_bend = bend_for(far / widest);
    const double meridian =
        far / std::sqrt(1 + far * far) / std::max(double{fan.shade.sin_axis}, 1e-9); // sine
    if (meridian < 1)
        fan.row_bend =
            bend_for(double{shared::fan_row(fan.shade, static_cast<float>(std::sqrt(1 - meridian * meridian)),
                                            static_cast<float>(meridian))});
    const bool surrounds = fan.beam.row_scale < 0;
    const BeamExtent extent = extent_of(fan.beam, tangent, pixels_per_rad, reach_m, surrounds);
    fan.thin = !surrounds && extent.pixels < kThin_pixels ? 1 : 0;
    // The brightest colour of a split gate.
    fan.most = std::max({light.colour_b.x, light.colour_b.y, light.colour_b.z, 1.0f});
    fan.layer = layer;
    fan.size = size_of(light, extent, detail);
    set_shade(fan, extent, shade);
    // Detail finer than a column would be cut into steps. The gobos' own levels of blur are used as they are.
    const float finest = std::max(2.0f * light.cut_radius / static_cast<float>(fan.size), light.edge);
    if (light.shaped != 0) {
        fan.sharpest = finest;
        set_nodes(fan, light, extent, detail);
        return fan;
    }
    // A figure is out of focus nowhere: beside its cone, even the first centimetres are thin.
    if (light.figure.kind != shared::kNoFigure) {
        fan.sharpest = kFigureBlur * finest;
        // A row that runs along the curve, at its brightest: no more, so that those across it are as exact as
        // may be.
        const float deviation = std::hypot(light.figure.deviation, 0.5f * fan.sharpest);
        fan.most = std::min(0.4f * shared::kFigureWidth / deviation, 1.0f);
        fan.levels = 1;
        while (fan.size >> (fan.halvings + 1) >= shared::kLeastSharp) ++fan.halvings;
        return fan;
    }
    const float texel = light.slide.layer != 0 ? light.slide.texel : shared::kGoboBlurUnit;
    const float octaves = std::max(std::floor(std::log2(finest / texel)), 0.0f);
    fan.sharpest = light.wheel_count > 0 || light.slide.layer != 0 ? texel * std::exp2(octaves) : finest;
    fan.levels = 1;
    // At its lens a beam is blurred over the whole gate.
    while (light.lens_radius_m > 0 && fan.levels < shared::kFanLevels &&
           std::ldexp(fan.sharpest, static_cast<int>(fan.levels) - 1) < 1.0f)
        ++fan.levels;
    while (fan.size >> (fan.halvings + 1) >= shared::kLeastSharp) ++fan.halvings;
    return fan;
}

} // namespace ghost::render
