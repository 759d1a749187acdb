// SPDX-License-Identifier: Apache-2.0
// Illuminance against what is known: E = I cos / d^2, and the lumens of a beam come out of a plane again.
#include "light/illuminance.h"

#include "photometry/photometry.h"
#include "shared/develop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ghost::scene {
namespace {

// Straight down from 5 m.
shared::Light lamp(float peak_cd, float field_deg) {
    const Profile profile = make_profile(0.6f * field_deg, field_deg, false);
    shared::Light light{};
    light.position_m = {0, 0, 5};
    light.axis_u = {1, 0, 0};
    light.axis_v = {0, -1, 0};
    light.axis_w = {0, 0, -1};
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.edge = profile.edge;
    light.iris_radius = profile.aperture;
    light.intensity_cd = glm::vec3(peak_cd);
    light.colour_b = glm::vec3(1);
    light.split = shared::kNoSplit;
    light.focus_per_m = 0.1f;
    light.lens_m = 0.2f;
    return light;
}

float lux(const shared::Light& light, const glm::vec3& point_m, const glm::vec3& normal,
          const LitAir& air = {}) {
    return shared::luminance_of(illuminance(light, point_m, normal, {}, air));
}

TEST(Illuminance, on_the_axis_it_is_candela_over_the_square_of_metres) {
    const shared::Light light = lamp(10000, 30);
    EXPECT_NEAR(lux(light, {0, 0, 0}, {0, 0, 1}), 10000 / 25.0, 0.4);
    EXPECT_NEAR(lux(light, {0, 0, 3}, {0, 0, 1}), 10000 / 4.0, 2.5);
    EXPECT_EQ(lux(light, {0, 0, 0}, {0, 0, -1}), 0) << "from behind";
    EXPECT_EQ(lux(light, {0, 0, 9}, {0, 0, -1}), 0) << "nothing leaves backwards";
}

TEST(Illuminance, a_slanted_surface_gets_the_cosine) {
    const shared::Light light = lamp(10000, 30);
    for (const float deg : {20.0f, 45.0f, 70.0f}) {
        const float rad = glm::radians(deg);
        EXPECT_NEAR(lux(light, {0, 0, 0}, {std::sin(rad), 0, std::cos(rad)}), 400 * std::cos(rad), 0.4)
            << deg;
    }
}

TEST(Illuminance, haze_and_attenuation_weaken_it) {
    const shared::Light light = lamp(10000, 30);
    LitAir air;
    air.haze.extinction_per_m = 0.1f;
    EXPECT_NEAR(lux(light, {0, 0, 0}, {0, 0, 1}, air), 400 * std::exp(-0.48), 0.4)
        << "there is no haze between apex and lens";
    LitAir linear;
    linear.attenuation = {0, 1, 0};
    EXPECT_NEAR(lux(light, {0, 0, 0}, {0, 0, 1}, linear), 10000 / 5.0, 2);
}

// All that a beam of so many lumens sends out arrives on the floor.
TEST(Illuminance, lux_times_square_metres_are_the_lumens_of_the_lamp) {
    const float flux_lm = 20000;
    const Profile profile = make_profile(24, 40, false);
    shared::Light light = lamp(peak_candela(profile, flux_lm), 40);
    const float step_m = 0.02f;
    double sum = 0;
    for (float y = -8; y < 8; y += step_m)
        for (float x = -8; x < 8; x += step_m)
            sum += static_cast<double>(lux(light, {x, y, 0}, {0, 0, 1}) * step_m * step_m);
    EXPECT_NEAR(sum, flux_lm, 0.005 * flux_lm);
}

} // namespace
} // namespace ghost::scene
