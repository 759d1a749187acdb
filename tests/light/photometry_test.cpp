// SPDX-License-Identifier: Apache-2.0
// The photometry of the beam against brute force: shared::beam_candela integrated over the sphere in double.
#include "photometry/photometry.h"

#include "shared/beam.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

constexpr double kTau = 6.283185307179586;
const shared::Gobos kOpenGate;

shared::Light open_light(const Profile& profile, float flux_lm, float lens_radius_m, float focus_m) {
    shared::Light light{};
    light.axis_u = {1, 0, 0};
    light.axis_v = {0, 1, 0};
    light.axis_w = {0, 0, 1};
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.intensity_cd = glm::vec3(peak_candela(profile, flux_lm));
    light.colour_b = glm::vec3(1.0f);
    light.split = shared::kNoSplit;
    light.iris_radius = profile.aperture;
    light.edge = profile.edge;
    light.focus_per_m = 1.0f / focus_m;
    light.lens_radius_m = lens_radius_m;
    return light;
}

double candela(const shared::Light& light, double theta, double phi, double distance_m) {
    const double side = std::sin(theta) * distance_m;
    const glm::dvec3 q(side * std::cos(phi), side * std::sin(phi), std::cos(theta) * distance_m);
    return static_cast<double>(shared::beam_candela(light, glm::vec3(q), kOpenGate).y);
}

// Rings of equal angle from the axis to the far side: fine inside the beam, where the light is, coarse
// behind.
double ring_flux_lm(const shared::Light& light, double distance_m) {
    constexpr int kRings = 6000;
    constexpr int kPhi = 16;
    const double end = std::atan(static_cast<double>(light.tan_field * light.cut_radius)) * 1.02;
    double flux = 0;
    const auto add = [&](double from, double to, int rings) {
        for (int ring = 0; ring < rings; ++ring) {
            const double width = (to - from) / rings;
            const double theta = from + (ring + 0.5) * width;
            double mean = 0;
            for (int k = 0; k < kPhi; ++k) mean += candela(light, theta, (k + 0.5) * kTau / kPhi, distance_m);
            flux += mean / kPhi * kTau * std::sin(theta) * width;
        }
    };
    add(0, end, kRings);
    add(end, kTau / 2, 500);
    return flux;
}

double tan_half(double angle_deg) {
    return std::tan(angle_deg * kTau / 720.0);
}

// Candela at an angle from the axis, as a fraction of the peak.
double fraction_at(const Profile& profile, double full_angle_deg) {
    const shared::Light light = open_light(profile, 10000.0f, 0.0f, 10.0f);
    return candela(light, full_angle_deg * kTau / 720.0, 0.3, 8.0) /
           static_cast<double>(light.intensity_cd.y);
}

TEST(photometry, FluxOfABeamIsItsLumens) {
    double worst = 0;
    for (const float zoom_deg : {2.0f, 4.0f, 7.5f, 12.0f, 20.0f, 30.0f, 42.5f, 60.0f})
        for (const float ratio : {0.25f, 0.5f, 0.7f, 0.85f, 0.95f, 1.0f})
            for (const bool hard : {true, false}) {
                const Profile profile = make_profile(ratio * zoom_deg, zoom_deg, hard);
                const double flux = ring_flux_lm(open_light(profile, 14000.0f, 0.0f, 10.0f), 10.0);
                EXPECT_NEAR(flux / 14000.0, 1.0, 0.001) << zoom_deg << " " << ratio << " " << hard;
                worst = std::max(worst, std::abs(flux / 14000.0 - 1.0));
            }
    std::printf("flux against lumens: worst error %.4f %%\n", worst * 100);
}

// The blurred edge of a spot out of focus moves light about; it must not make or lose much.
TEST(photometry, FocusKeepsTheFlux) {
    double worst = 0;
    for (const float zoom_deg : {15.0f, 25.0f, 42.5f})
        for (const float distance_m : {2.0f, 5.0f, 10.0f, 30.0f}) { // from the lens
            const Profile profile = make_profile(zoom_deg * 0.75f, zoom_deg, true);
            const double flux = ring_flux_lm(open_light(profile, 14000.0f, 0.08f, 10.0f),
                                             static_cast<double>(distance_m + 0.08f / profile.tan_field));
            worst = std::max(worst, std::abs(flux / 14000.0 - 1.0));
            EXPECT_NEAR(flux / 14000.0, 1.0, 0.02) << zoom_deg << " " << distance_m;
        }
    std::printf("flux out of focus: worst error %.3f %%\n", worst * 100);
}

TEST(photometry, HalfAtTheBeamAngleATenthAtTheFieldAngle) {
    for (const float field_deg : {4.0f, 14.0f, 30.0f, 60.0f})
        for (const float ratio : {0.4f, 0.55f, 0.7f, 0.8f, 0.88f}) {
            const Profile profile = make_profile(ratio * field_deg, field_deg, false);
            SCOPED_TRACE(std::to_string(field_deg) + " deg, beam / field " + std::to_string(ratio));
            EXPECT_NEAR(fraction_at(profile, ratio * field_deg), 0.5, 0.002);
            EXPECT_NEAR(fraction_at(profile, field_deg), 0.1, 0.002);
            EXPECT_EQ(fraction_at(profile, field_deg * 2.6), 0.0);
        }
}

// The stop of a spot stands at its field angle: sharp in focus, half of the profile's light on the edge
// itself.
TEST(photometry, SpotEndsAtItsFieldAngle) {
    const Profile profile = make_profile(15.0f, 20.0f, true);
    EXPECT_NEAR(fraction_at(profile, 15.0), 0.5, 0.002);
    EXPECT_NEAR(
        fraction_at(profile, 19.6),
        std::exp2(-static_cast<double>(profile.scale) *
                  std::pow(tan_half(19.6) / tan_half(20.0), 2.0 * static_cast<double>(profile.power))),
        0.002);
    EXPECT_NEAR(fraction_at(profile, 20.0), 0.05, 0.002);
    EXPECT_EQ(fraction_at(profile, 20.4), 0.0);
}

TEST(photometry, NarrowerBeamsOfTheSameLampAreBrighter) {
    float last = 1e30f;
    for (const float zoom_deg : {2.0f, 5.0f, 10.0f, 20.0f, 40.0f, 60.0f}) {
        const float peak = peak_candela(make_profile(zoom_deg * 0.7f, zoom_deg, true), 10000.0f);
        EXPECT_LT(peak, last);
        last = peak;
    }
    // A flat disc of light of 60 degrees, by hand: 10000 / (2 pi (1 - cos 30 deg)) = 11880 cd.
    EXPECT_NEAR(peak_candela(make_profile(60, 60, true), 10000.0f), 11880.0f, 1300.0f);
}

TEST(photometry, OddAnglesAreTaken) {
    for (const float beam : {-5.0f, 0.0f, 0.01f, 30.0f, 179.0f, 1000.0f})
        for (const float field : {-1.0f, 0.0f, 0.05f, 20.0f, 180.0f, 4000.0f})
            for (const bool hard : {true, false}) {
                const Profile profile = make_profile(beam, field, hard);
                const float peak = peak_candela(profile, 10000.0f);
                EXPECT_TRUE(std::isfinite(peak) && peak > 0) << beam << " " << field;
                for (const float value : {profile.tan_field, profile.power, profile.scale, profile.aperture,
                                          profile.edge, profile.cut_radius})
                    EXPECT_TRUE(std::isfinite(value) && value > 0) << beam << " " << field;
            }
}

TEST(photometry, IrisCutsTheBeamAtItsRadius) {
    const Profile profile = make_profile(15.0f, 20.0f, true);
    shared::Light light = open_light(profile, 10000.0f, 0.0f, 10.0f);
    light.iris_radius = 0.5f;
    const auto at = [&](double gate_radius) {
        return candela(light, std::atan(gate_radius * tan_half(20.0)), 1.0, 10.0);
    };
    const shared::Light open = open_light(profile, 10000.0f, 0.0f, 10.0f);
    EXPECT_EQ(at(0.0), candela(open, 0.0, 1.0, 10.0));
    EXPECT_EQ(at(0.45), candela(open, std::atan(0.45 * tan_half(20.0)), 1.0, 10.0));
    EXPECT_NEAR(at(0.5) / candela(open, std::atan(0.5 * tan_half(20.0)), 1.0, 10.0), 0.5, 0.01);
    EXPECT_EQ(at(0.55), 0.0);
}

TEST(photometry, NothingLeavesBackwards) {
    const shared::Light light = open_light(make_profile(100, 150, false), 10000.0f, 0.0f, 10.0f);
    for (const double theta : {1.58, 2.0, 2.7, 3.1}) EXPECT_EQ(candela(light, theta, 0.4, 3.0), 0.0);
}

} // namespace
} // namespace ghost::scene
