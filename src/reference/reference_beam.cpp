// SPDX-License-Identifier: Apache-2.0
#include "reference/reference_beam.h"

#include "shared/figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ghost::bake {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;

// Part of the model, not of its precision: nothing leaves nearer than this to the plane of the apex.
constexpr double kNearestGate_m = 1e-4;
constexpr double kSlotPitch = 2.4; // gate radii between the centres of two slots

// Smooth step across an edge of width 2 blur about the aperture's radius.
double fraction_inside(double radius, double aperture, double blur) {
    const double t = std::clamp(0.5 + 0.5 * (aperture - radius) / blur, 0.0, 1.0);
    return (3.0 - 2.0 * t) * t * t;
}

dvec3 texel(const shared::Gobos& gobos, std::size_t level, std::uint32_t layer, long x, long y) {
    const long side = shared::kGoboSize >> level;
    x = std::clamp(x, 0L, side - 1);
    y = std::clamp(y, 0L, side - 1);
    const std::uint32_t code =
        gobos.texels[level][static_cast<std::size_t>((static_cast<long>(layer) * side + y) * side + x)];
    return dvec3(code % 512, (code >> 9) % 512, (code >> 18) % 512) *
           std::exp2(static_cast<double>(code >> 27) - 24.0);
}

dvec3 bilinear(const shared::Gobos& gobos, std::size_t level, std::uint32_t layer, const dvec2& uv) {
    // Texel centres stand at half numbers.
    const dvec2 place = uv * static_cast<double>(shared::kGoboSize >> level) - 0.5;
    const dvec2 corner = glm::floor(place);
    const dvec2 part = place - corner;
    dvec3 sum(0.0);
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx)
            sum += texel(gobos, level, layer, std::lround(corner.x) + dx, std::lround(corner.y) + dy) *
                   ((dx == 1 ? part.x : 1.0 - part.x) * (dy == 1 ? part.y : 1.0 - part.y));
    return sum;
}

double decoded(std::uint8_t code) {
    const double v = code / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

dvec3 slide_texel(const shared::SlidePicture& picture, std::size_t level, long x, long y) {
    const long side = picture.side >> level;
    const auto at =
        static_cast<std::size_t>(std::clamp(y, 0L, side - 1) * side + std::clamp(x, 0L, side - 1)) * 4;
    const std::uint8_t* rgba = &(*picture.levels)[level][at];
    return {decoded(rgba[0]), decoded(rgba[1]), decoded(rgba[2])};
}

dvec3 slide_bilinear(const shared::SlidePicture& picture, std::size_t level, const dvec2& uv) {
    const dvec2 place = uv * static_cast<double>(picture.side >> level) - 0.5;
    const dvec2 corner = glm::floor(place), part = place - corner;
    const long x = std::lround(corner.x), y = std::lround(corner.y);
    return glm::mix(
        glm::mix(slide_texel(picture, level, x, y), slide_texel(picture, level, x + 1, y), part.x),
        glm::mix(slide_texel(picture, level, x, y + 1), slide_texel(picture, level, x + 1, y + 1), part.x),
        part.y);
}

// A map of the gate: place, and the third coordinate it was divided by.
dvec3 mapped(const glm::vec3 (&rows)[3], const dvec2& gate) {
    const dvec3 way(gate, 1.0);
    const double z = std::max(glm::dot(dvec3(rows[2]), way), 1e-3);
    return {glm::dot(dvec3(rows[0]), way) / z, glm::dot(dvec3(rows[1]), way) / z, z};
}

// Share that a round opening lets through at a radius: a ring of 2 blur about a radius that keeps the
// light of an even field (the variance of the edge is a fifth of blur^2), or of one that falls; where blur is
// larger, all of it is that ring, weaker.
double fraction_of_opening(double radius, double opening, double blur, double rim_fraction) {
    const double own2 = rim_fraction * blur * blur;
    if (opening * opening >= 1.2 * own2)
        return fraction_inside(radius, std::sqrt(opening * opening - own2 / 5.0), blur);
    return fraction_inside(radius, std::sqrt(own2), blur) * opening * opening / (1.2 * own2);
}

// Fraction of the frame -1..1 of such a map that lets light pass, blurred.
double framed(const glm::vec3 (&rows)[3], const dvec3& at, double blur) {
    double fraction = 1.0;
    for (int k = 0; k < 2; ++k) {
        const double scale = std::hypot(static_cast<double>(rows[k].x), static_cast<double>(rows[k].y)) /
                             std::max(static_cast<double>(rows[2].z), 1e-3);
        fraction *= fraction_inside(std::abs(at[k]), 1.0, blur * scale);
    }
    return fraction;
}

double henyey_greenstein(double g, double cosine) {
    // The model's lobe is no sharper than this at its tip.
    const double base = std::max(1.0 + g * g - 2.0 * g * cosine, 1e-4);
    return (1.0 - g * g) / (4.0 * pi * std::pow(base, 1.5));
}

} // namespace

ReferenceBeam::ReferenceBeam(const shared::Light& light, const shared::Gobos& gobos, BeamOverride instead)
    : light_(light), gobos_(gobos), instead_(std::move(instead)),
      axes_(glm::transpose(glm::dmat3(dvec3(light.axis_u), dvec3(light.axis_v), dvec3(light.axis_w)))) {}

dvec3 ReferenceBeam::to_gate(const dvec3& offset_m) const {
    return axes_ * offset_m;
}

// A thin lens of radius R, f the distance at which the plane of depth 0 is sharp: its circle of confusion in
// gate units. Another plane is blurred by `depth` far away while that one is sharp.
double ReferenceBeam::blur_at(double z_m, double depth) const {
    const double lens_m = light_.lens_radius_m;
    const double tan_field = static_cast<double>(light_.tan_field);
    const double wide_m = std::max(z_m * tan_field - lens_m, 0.0), before_m = wide_m / tan_field;
    if (lens_m + wide_m == 0.0) return static_cast<double>(light_.edge);
    const double signed_blur =
        (lens_m - lens_m * before_m * static_cast<double>(light_.focus_per_m) + depth * wide_m) /
        (lens_m + wide_m);
    return static_cast<double>(light_.edge) + std::abs(signed_blur);
}

dvec3 ReferenceBeam::disc_colour(const dvec2& gate, double blur) const {
    const shared::Disc& disc = light_.disc;
    if (disc.layer == 0) return dvec3(1.0);
    const double scale = disc.scale;
    const dvec2 at = dvec2(disc.centre) + scale * gate;
    const double covered = fraction_inside(glm::length(at), 1.0, std::max(scale * blur, 0.01));
    const double c = disc.cosine, s = disc.sine;
    const dvec3 picture = gobo_colour(disc.layer, {at.x * c + at.y * s, at.y * c - at.x * s}, scale * blur);
    return glm::mix(dvec3(1.0), picture, covered);
}

// Two blades that face each other take away what each of them covers.
double ReferenceBeam::slit(int first, const dvec2& gate, double z_m) const {
    double open = 1.0;
    for (const int k : {first, first + 2}) {
        const shared::Blade& blade = light_.blade[k];
        const double into = glm::dot(gate, dvec2(blade.normal)) - static_cast<double>(blade.offset);
        open -= 1.0 - fraction_inside(into, 0.0, blur_at(z_m, static_cast<double>(blade.depth)));
    }
    return std::max(open, 0.0);
}

dvec3 ReferenceBeam::gobo_colour(std::uint32_t layer, const dvec2& gate, double blur) const {
    if (layer == 0 || static_cast<int>(layer) >= gobos_.layers) return dvec3(1.0);
    const dvec2 uv = glm::clamp(dvec2(0.5 + 0.5 * gate.x, 0.5 - 0.5 * gate.y), 0.0, 1.0);
    // Level k is blurred over a disc of 2^k pixels' radius.
    const double pixels = std::max(blur * shared::kGoboSize / 2.0, 1.0);
    const double level = std::min(std::log2(pixels), shared::kGoboLevels - 1.0);
    const double below = std::floor(level);
    const auto sharp = static_cast<std::size_t>(below);
    const std::size_t soft = std::min<std::size_t>(sharp + 1, shared::kGoboLevels - 1);
    return glm::mix(bilinear(gobos_, sharp, layer, uv), bilinear(gobos_, soft, layer, uv), level - below);
}

dvec3 ReferenceBeam::slide_colour(const dvec2& gate, double blur) const {
    const shared::Slide& slide = light_.slide;
    const dvec3 panel = mapped(slide.panel, gate), at = mapped(slide.picture, gate);
    const double slope = static_cast<double>(light_.tan_field) * glm::length(gate);
    // Rows of the panel are scaled by the cube root of its brightest corner: 1 / cosine from the optical
    // axis, cubed.
    const double even = std::pow(std::sqrt(1.0 + slope * slope) / panel.z, 3.0);
    double fraction = framed(slide.picture, at, blur);
    for (int k = 0; k < 4; ++k) {
        if (slide.blend[k] == 0.0f) continue;
        const double from_edge = (k % 2 == 0 ? at[k / 2] : -at[k / 2]) + 1.0;
        const double t = std::clamp(from_edge * static_cast<double>(slide.blend[k]), 0.0, 1.0);
        fraction *= (3.0 - 2.0 * t) * t * t;
    }
    dvec3 colour(0.0);
    if (slide.layer <= gobos_.slides.size() && gobos_.slides[slide.layer - 1].levels) {
        const shared::SlidePicture& picture = gobos_.slides[slide.layer - 1];
        const dvec2 place = dvec2(at) * dvec2(slide.extent);
        const dvec2 uv(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y);
        const double top = static_cast<double>(picture.levels->size() - 1);
        const double level =
            std::clamp(std::log2(std::max(blur / static_cast<double>(slide.texel), 1.0)), 0.0, top);
        const double below = std::floor(level);
        const auto sharp = static_cast<std::size_t>(below);
        const dvec3 rgb = glm::mix(
            slide_bilinear(picture, sharp, uv),
            slide_bilinear(picture, std::min(sharp + 1, picture.levels->size() - 1), uv), level - below);
        // Rec.709 to Rec.2020 (ITU-R BT.2087).
        colour = {0.6274 * rgb.r + 0.3293 * rgb.g + 0.0433 * rgb.b,
                  0.0691 * rgb.r + 0.9195 * rgb.g + 0.0114 * rgb.b,
                  0.0164 * rgb.r + 0.0880 * rgb.g + 0.8956 * rgb.b};
    }
    const double black = slide.black;
    return even * (black * framed(slide.panel, panel, blur) + (1.0 - black) * fraction * colour);
}

// A normal distribution across the curve that the scanner draws; its unit is a figure of 1/128 gate radius.
double ReferenceBeam::figure_transmittance(const dvec2& gate, double blur) const {
    const shared::LaserCurve& figure = light_.figure;
    const double c = figure.cosine, s = figure.sine, a = figure.half_size.x, b = figure.half_size.y;
    const double own = figure.deviation, sigma = std::hypot(own, 0.5 * blur);
    const dvec2 at(c * gate.x + s * gate.y, c * gate.y - s * gate.x);
    double distance = at.y, spread = sigma, density = 1.0;
    if (figure.kind == shared::kCircleFigure) {
        // In the frame where the ellipse is a circle its round is even in the angle.
        const double angle = std::atan2(at.y / b, at.x / a), radius = std::hypot(at.x / a, at.y / b);
        distance = radius - 1.0;
        spread = sigma * std::hypot(std::cos(angle) / a, std::sin(angle) / b);
        density = std::min(a, b) / (a * b * std::max(radius, 1e-6));
    } else {
        density = fraction_inside(std::abs(at.x), a, 2.0 * sigma);
        if (figure.kind == shared::kWaveFigure) {
            const double k = pi * static_cast<double>(figure.waves) / a;
            const double angle = k * at.x + static_cast<double>(figure.phase);
            distance = at.y - b * std::sin(angle);
            spread = sigma * std::hypot(1.0, b * k * std::cos(angle));
        }
    }
    const double normal = std::exp(-0.5 * std::pow(distance / spread, 2.0)) / (spread * std::sqrt(2.0 * pi));
    const double tan2 = std::pow(static_cast<double>(light_.tan_field), 2.0);
    const double cut = light_.cut_radius;
    return normal * density / 128.0 *
           std::pow((1.0 + tan2 * glm::dot(gate, gate)) / (1.0 + tan2 * cut * cut), 1.5);
}

dvec3 ReferenceBeam::wheel_colour(const shared::Wheel& wheel, const dvec2& gate, double blur) const {
    const auto of_slot = [&](std::uint32_t layer, double centre_x) {
        const dvec2 in_slot(gate.x - centre_x, gate.y);
        const double cosine = wheel.cosine;
        const double sine = wheel.sine;
        const dvec2 turned(cosine * in_slot.x + sine * in_slot.y, cosine * in_slot.y - sine * in_slot.x);
        const dvec3 colour = gobo_colour(layer, turned, blur);
        // A centred slot is limited by the aperture alone, one that is moving by its own rim.
        return wheel.shift == 0.0f
                   ? colour
                   : colour * fraction_inside(glm::length(in_slot), 1.0, std::max(blur, 0.01));
    };
    const double first_x = -static_cast<double>(wheel.shift) * kSlotPitch;
    const dvec3 first = of_slot(wheel.layer_a, first_x);
    return wheel.shift == 0.0f ? first : first + of_slot(wheel.layer_b, first_x + kSlotPitch);
}

dvec3 ReferenceBeam::candela(const dvec3& gate_m) const {
    if (instead_) return instead_(gate_m);
    if (!(gate_m.z > std::max(static_cast<double>(light_.lens_m), kNearestGate_m))) return dvec3(0.0);
    const dvec2 gate = dvec2(gate_m) / (gate_m.z * static_cast<double>(light_.tan_field));
    const double radius = glm::length(gate);
    if (!(radius < static_cast<double>(light_.cut_radius))) return dvec3(0.0);
    const bool shaped = light_.shaped != 0;
    const auto blur_of = [&](float depth) {
        return blur_at(gate_m.z, shaped ? static_cast<double>(depth) : 0.0);
    };
    const double rim_blur =
        light_.rim_fraction < 0.0f ? static_cast<double>(light_.edge) : blur_of(light_.iris_depth);
    double open =
        fraction_of_opening(radius, light_.iris_radius, rim_blur, std::max(light_.rim_fraction, 0.0f));
    const bool cut = light_.shaped > 1;
    if (cut) open *= slit(0, gate, gate_m.z) * slit(1, gate, gate_m.z);
    if (open == 0.0) return dvec3(0.0);
    const double shape = std::exp2(-static_cast<double>(light_.profile_scale) *
                                   std::pow(radius * radius, static_cast<double>(light_.profile_power)));
    const double half = 0.125 + static_cast<double>(light_.split_soft);
    const double side = std::clamp(0.5 * (gate.x - static_cast<double>(light_.split)) / half + 0.5, 0.0, 1.0);
    dvec3 colour =
        dvec3(light_.intensity_cd) * (shape * open) * glm::mix(dvec3(1.0), dvec3(light_.colour_b), side);
    const double distance2 = glm::dot(gate_m, gate_m), panel_m = light_.panel_m;
    colour *= distance2 / (distance2 + panel_m * panel_m);
    if (light_.figure.kind != shared::kNoFigure) return colour * figure_transmittance(gate, blur_of(0.0f));
    for (std::uint32_t k = 0; k < std::min(light_.wheel_count, 3u); ++k)
        colour *= wheel_colour(light_.wheel[k], gate, blur_of(light_.wheel[k].depth));
    if (light_.slide.layer != 0) colour *= slide_colour(gate, blur_of(0.0f));
    if (cut) colour *= disc_colour(gate, blur_of(light_.disc.depth));
    return colour;
}

ReferenceMedium::ReferenceMedium(const shared::Haze& haze, HazeDensity density, int path_samples)
    : haze_(haze), density_(std::move(density)), path_samples_(path_samples) {}

double ReferenceMedium::phase(double cosine, double narrow) const {
    const double back = haze_.back_weight, forward_g = haze_.forward_g, back_g = haze_.back_g;
    return (1.0 - back) * henyey_greenstein(forward_g * narrow, cosine) +
           back * henyey_greenstein(back_g * narrow, cosine);
}

double ReferenceMedium::optical_depth(const dvec3& from_m, const dvec3& to_m) const {
    const double whole = extinction_per_m() * glm::length(to_m - from_m);
    if (homogeneous() || whole == 0.0) return whole;
    double sum = 0.0;
    for (int k = 0; k < path_samples_; ++k) sum += density(glm::mix(from_m, to_m, (k + 0.5) / path_samples_));
    return whole * sum / path_samples_;
}

dvec3 reference_brdf_times_cosine(const shared::Brdf& brdf, const dvec3& n, const dvec3& v, const dvec3& l) {
    const double nl = glm::dot(n, l);
    if (!(nl > 0.0)) return dvec3(0.0);
    const double nv = std::max(std::abs(glm::dot(n, v)), 1e-4);
    const dvec3 h = glm::normalize(l + v);
    const double nh = std::clamp(glm::dot(n, h), 0.0, 1.0);
    const double vh = std::clamp(glm::dot(v, h), 0.0, 1.0);
    const double a2 = static_cast<double>(brdf.alpha) * static_cast<double>(brdf.alpha);
    // Appendix B.3.2: D of Trowbridge and Reitz, V height-correlated, F of Schlick.
    const double distribution = a2 / (pi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
    const double visibility =
        0.5 / (nl * std::sqrt(a2 + (1.0 - a2) * nv * nv) + nv * std::sqrt(a2 + (1.0 - a2) * nl * nl));
    const dvec3 f0(brdf.f0);
    const dvec3 fresnel = f0 + (static_cast<double>(brdf.f90) - f0) * std::pow(1.0 - vh, 5.0);
    return nl * ((1.0 - fresnel) * dvec3(brdf.diffuse) / pi + fresnel * distribution * visibility);
}

dvec3 reference_brdf_albedo(const shared::Brdf& brdf, double nv) {
    const double rough = std::sqrt(static_cast<double>(brdf.alpha));
    const glm::dvec4 r =
        rough * glm::dvec4(-1.0, -0.0275, -0.572, 0.022) + glm::dvec4(1.0, 0.0425, 1.04, -0.04);
    const double a = std::min(r.x * r.x, std::exp2(-9.28 * std::clamp(nv, 0.0, 1.0))) * r.x + r.y;
    const dvec3 mirror = glm::clamp(
        dvec3(brdf.f0) * (-1.04 * a + r.z) + static_cast<double>(brdf.f90) * (1.04 * a + r.w), 0.0, 1.0);
    return dvec3(brdf.diffuse) * (1.0 - mirror) + mirror;
}

} // namespace ghost::bake
