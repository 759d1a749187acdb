// SPDX-License-Identifier: Apache-2.0
#include "photometry/photometry.h"

#include "shared/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ghost::scene {
namespace {

constexpr float kMinAngleDeg = 0.1f;
constexpr float kMaxAngleDeg = 170.0f;
constexpr float kMaxPower = 10.0f; // equal beam and field angle: nearly flat
constexpr int kSteps = 512;
constexpr std::size_t kMostFound = 4096;
constexpr float kFrostEnd = 9.0f; // halvings of the peak where a frosted beam ends

float tan_half(float angle_deg) {
    return std::tan(angle_deg * 0.5f * shared::kPi / 180.0f);
}

} // namespace

Profile make_profile(float beam_angle_deg, float field_angle_deg, bool hard_edge) {
    const float field_deg = std::clamp(field_angle_deg, kMinAngleDeg, kMaxAngleDeg);
    const float beam_deg = std::clamp(beam_angle_deg, kMinAngleDeg, field_deg);
    Profile profile;
    profile.tan_field = tan_half(field_deg);
    const float ratio = profile.tan_field / tan_half(beam_deg);
    // 50 % at the beam angle and 10 % at the field angle fix the exponent: scale = ratio^n = log2 10.
    const float n = ratio > 1.0001f ? std::log(std::log2(10.0f)) / std::log(ratio) : 1e9f;
    profile.power = std::clamp(0.5f * n, 0.25f, kMaxPower);
    profile.scale = std::pow(ratio, 2.0f * profile.power);
    if (hard_edge) {
        profile.cut_radius = 1.25f;
    } else {
        // Where the profile has fallen to 0.4 %.
        const float end = std::pow(8.0f / profile.scale, 0.5f / profile.power);
        profile.cut_radius = std::clamp(end, 1.05f, 2.5f);
        // The fade to zero begins where the field ends, so that 10 % stays 10 %.
        profile.edge = 0.5f * (profile.cut_radius - 1.0f);
        profile.aperture = profile.cut_radius - profile.edge;
    }
    return profile;
}

Profile frosted(const Profile& profile, float aperture, float sigma) {
    if (!(sigma > 0.0f)) return profile;
    // Radii of 50 and 10 % of a Gaussian, and how far a straight edge reaches to 10 %, in sigmas.
    constexpr float k50 = 1.17741f, k10 = 2.14597f, kEdge10 = 1.28155f;
    const float p = profile.power;
    const float r50 = std::min(std::pow(profile.scale, -0.5f / p), aperture);
    const float r10 = std::min(std::pow(std::log2(10.0f) / profile.scale, 0.5f / p), aperture);
    const float wide50 = std::sqrt(r50 * r50 + k50 * k50 * sigma * sigma);
    const float fraction = sigma / (sigma + 0.5f * r50); // of a Gaussian in the shape of the edge
    const float edge10 = std::max(kEdge10 + (k10 - k50 - kEdge10) * fraction, k10 - k50) * sigma;
    const float wide10 = wide50 + std::sqrt((r10 - r50) * (r10 - r50) + edge10 * edge10);
    Profile result = profile;
    result.power =
        std::clamp(0.5f * std::log(std::log2(10.0f)) / std::log(wide10 / wide50), 0.25f, kMaxPower);
    result.scale = std::pow(wide50, -2.0f * result.power);
    // A disc of twice the radius spreads as far.
    result.edge = profile.edge + 2.0f * sigma;
    const float end = std::pow(kFrostEnd / result.scale, 0.5f / result.power);
    result.cut_radius = std::max({end, 2.0f * result.edge, wide10 + result.edge});
    result.aperture = result.cut_radius - result.edge;
    return result;
}

float lens_fraction(float tangent, float lens_radius_m) {
    constexpr float kLeast = 1.0f / 3.0f;
    return std::max(1.0f - std::max(lens_radius_m, 0.0f) / (kMeasured_m * tangent), kLeast);
}

Spread spread_of(float beam_deg, float field_deg, float lens_radius_m) {
    const float tan_field = tan_half(std::clamp(field_deg, kMinAngleDeg, kMaxAngleDeg));
    const float fraction = lens_fraction(tan_field, lens_radius_m);
    const auto narrowed = [fraction](float deg) {
        return glm::degrees(2.0f *
                            std::atan(fraction * tan_half(std::clamp(deg, kMinAngleDeg, kMaxAngleDeg))));
    };
    return {narrowed(beam_deg), narrowed(field_deg)};
}

float measured_fraction(const shared::Light& light) {
    const float fraction = kMeasured_m / (kMeasured_m + light.lens_m);
    return fraction * fraction;
}

float rim_fraction(const Profile& profile, float aperture) {
    // How the field falls with the logarithm of the radius.
    const float fall = 2.0f * std::numbers::ln2_v<float> * profile.power * profile.scale *
                       std::pow(aperture, 2.0f * profile.power);
    return std::clamp(1.0f - fall, 0.0f, 1.0f);
}

float beam_solid_angle(const Profile& profile, float aperture) {
    // In gate radii: dOmega = 2 pi r tan^2 / (1 + r^2 tan^2)^(3/2) dr.
    const double tan2 = static_cast<double>(profile.tan_field) * static_cast<double>(profile.tan_field);
    const double dr = static_cast<double>(profile.cut_radius) / kSteps;
    const float fraction = rim_fraction(profile, aperture);
    double solid_angle = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double r = (i + 0.5) * dr;
        const auto r_float = static_cast<float>(r);
        const double shape =
            static_cast<double>(shared::beam_profile(r_float * r_float, profile.power, profile.scale) *
                                shared::beam_opening(r_float, aperture, profile.edge, fraction));
        solid_angle += shape * 2.0 * static_cast<double>(shared::kPi) * r * tan2 /
                       std::pow(1.0 + r * r * tan2, 1.5) * dr;
    }
    return static_cast<float>(solid_angle);
}

float peak_candela(const Profile& profile, float flux_lm) {
    const float solid_angle = beam_solid_angle(profile, profile.aperture);
    return solid_angle > 0 ? flux_lm / solid_angle : 0.0f;
}

const MeasuredProfile& area_profile() {
    static const MeasuredProfile made = [] {
        // Fitted so that the largest error of the candela, at the right lumens, is smallest up to 65 degrees.
        constexpr float kEnd = 7.6f, kFadesFrom = 3.0f; // tangents
        MeasuredProfile area;
        area.profile = {.tan_field = 3.732f, .power = 0.55f, .scale = 2.153f};
        area.profile.cut_radius = kEnd / area.profile.tan_field;
        area.profile.edge = 0.5f * (area.profile.cut_radius - kFadesFrom / area.profile.tan_field);
        area.profile.aperture = area.aperture = area.profile.cut_radius - area.profile.edge;
        area.open_sr = area.iris_sr = area.sent_sr = beam_solid_angle(area.profile, area.aperture);
        return area;
    }();
    return made;
}

void ProfileTable::trim() {
    if (found_.size() > kMostFound) found_.clear();
    frost.trim();
}

const MeasuredProfile& ProfileTable::find(float beam_angle_deg, float field_angle_deg, bool hard_edge,
                                          float iris, float frost_deg) {
    const auto [entry, is_new] =
        found_.try_emplace({beam_angle_deg, field_angle_deg, hard_edge ? 1.0f : 0.0f, iris, frost_deg});
    MeasuredProfile& measured = entry->second;
    if (is_new) {
        measured.profile = make_profile(beam_angle_deg, field_angle_deg, hard_edge);
        measured.open_sr = beam_solid_angle(measured.profile, measured.profile.aperture);
        measured.aperture = measured.profile.aperture * iris;
        measured.iris_sr = beam_solid_angle(measured.profile, measured.aperture);
        measured.sent_sr = measured.iris_sr;
        if (frost_deg > 0.0f) {
            const float sigma = std::tan(frost_deg * shared::kPi / 180.0f) / measured.profile.tan_field;
            measured.profile = frosted(measured.profile, measured.aperture, sigma);
            measured.aperture = measured.profile.aperture;
            measured.sent_sr = beam_solid_angle(measured.profile, measured.aperture);
        }
    }
    return measured;
}

} // namespace ghost::scene
