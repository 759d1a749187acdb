// SPDX-License-Identifier: Apache-2.0
// Lenses against photometry: the light of a disc that arrives at the eye is the light's candela / distance^2,
// at any size, place and angle.
#include "shared/beam.h"
#include "support/test_glare.h"

namespace ghost::render {
namespace {

using glm::vec3;

using Lens = RelightTest;

constexpr shared::Haze kThinHaze{0.02f, 0.02f, 0.77f, -0.6f, 0.035f};

// Lux that a light's beam brings to the eye at the origin.
double lux_at_eye(const shared::Light& light, const shared::Haze& haze = {}) {
    const vec3 candela = shared::beam_candela(light, shared::to_gate(light, -light.position_m), test_gobos());
    const double lens_m = glm::length(lens_of(light));
    return double{candela.y} / double{glm::dot(light.position_m, light.position_m)} *
           std::exp(-double{haze.extinction_per_m} * lens_m);
}

TEST_F(Lens, LuminanceOfALargeDisc) {
    DarkHall hall(200, 120, 20, 30, kThinHaze);
    shared::Light light = aimed_light({0.1f, 2.5f, 0.05f}, {0.4f, 0, 0.1f}, 40, 20.0f);
    light.disc_radius_m = 0.09f;
    hall.draw({light});
    const vec3 lens = lens_of(light);
    const double lens_m = glm::length(lens);
    const double cosine = double{glm::dot(-lens, light.axis_w)} / lens_m;
    ASSERT_LT(cosine, 0.999);
    const double expected =
        lux_at_eye(light, kThinHaze) * lens_m * lens_m / (3.14159265358979 * 0.09 * 0.09 * cosine);
    const glm::ivec2 centre(hall.pixel_of(lens));
    EXPECT_NEAR(hall.frame().at(centre.x, centre.y)[1] / expected, 1.0, 0.01);
}

TEST_F(Lens, LightAtTheEyeAtAnySizeAndAngle) {
    DarkHall hall(160, 96, 40, 60, kThinHaze);
    for (const float away_m : {3.0f, 8.0f, 20.0f, 50.0f})
        for (const float aside_deg : {0.0f, 4.0f, 10.0f, 35.0f, 60.0f}) {
            const float turn = glm::radians(aside_deg);
            const vec3 from(0.1f * away_m, away_m, -0.07f * away_m);
            const vec3 to = from + 5.0f * glm::vec3(std::sin(turn), -std::cos(turn), 0.03f);
            shared::Light light = aimed_light(from, to, 150, 4.0f * away_m, false);
            light.disc_radius_m = 0.08f;
            hall.draw({light});
            const double lux = hall.light() * hall.pixel_sr(hall.pixel_of(lens_of(light)));
            // A large disc is projected as if the projection were linear, hence the first distance's share.
            EXPECT_NEAR(lux / lux_at_eye(light, kThinHaze), 1.0, 0.004)
                << away_m << " m, " << aside_deg << " deg";
        }
}

TEST_F(Lens, MovesBetweenPixelsWithoutFlicker) {
    DarkHall hall(64, 48, 40, 60);
    const float pixel_m = 30.0f / pixels_per_rad(hall.view());
    double least = 1e30, most = 0, step = 0, last_peak = 0;
    for (int k = 0; k <= 20; ++k) {
        const vec3 from(0.1f * static_cast<float>(k) * pixel_m, 30, 0.037f * static_cast<float>(k) * pixel_m);
        shared::Light light = aimed_light(from, {0, 0, 0}, 20, 5000.0f);
        light.disc_radius_m = 0.02f; // a tenth of a pixel
        hall.draw({light});
        const double sum = hall.light();
        least = std::min(least, sum);
        most = std::max(most, sum);
        const image::ImageF frame = hall.frame();
        const double peak = *std::max_element(frame.samples.begin(), frame.samples.end());
        if (k > 0) step = std::max(step, std::abs(peak / last_peak - 1.0));
        last_peak = peak;
    }
    EXPECT_GT(least, 0);
    EXPECT_LT(most / least, 1.002);
    EXPECT_LT(step, 0.15);
}

TEST_F(Lens, WhatDoesNotFitIntoTheFrameIsKept) {
    DarkHall hall(96, 64, 20, 60);
    shared::Light light = aimed_light({0, 15, 0}, {0, 0, 0}, 8, 1e6f);
    shared::Light second = aimed_light({0.05f, 14, 0.1f}, {0, 0, 0}, 12, 2e6f);
    put_gobo(second, 1); // another shader, over the same pixels
    hall.draw({light, second});
    const image::ImageF frame = hall.frame();
    EXPECT_NEAR(*std::max_element(frame.samples.begin(), frame.samples.end()), shared::kMostLight, 50);
    const double lux = hall.light() * hall.pixel_sr({48, 32});
    EXPECT_NEAR(lux / (lux_at_eye(light) + lux_at_eye(second)), 1.0, 0.01);
    // Resting lights leave nothing behind.
    light.intensity_cd = second.intensity_cd = vec3(0);
    hall.draw({light, second});
    EXPECT_EQ(hall.light(), 0.0);
}

TEST_F(Lens, DarkTurnedAwayBesideTheBeamAndOutOfThePicture) {
    DarkHall hall(64, 48, 40, 60);
    const shared::Light at_us = aimed_light({0, 10, 0}, {0, 0, 0}, 10, 1000);
    shared::Light dark = at_us;
    dark.intensity_cd = vec3(0);
    const shared::Light away = aimed_light({0, 10, 0}, {0, 20, 0}, 10, 1000);
    const shared::Light beside = aimed_light({0, 10, 0}, {4, 0, 0}, 10, 1000);
    const shared::Light outside = aimed_light({30, 10, 0}, {0, 0, 0}, 10, 1000);
    const shared::Light behind = aimed_light({0, -10, 0}, {0, 0, 0}, 10, 1000);
    hall.draw({dark, away, beside, outside, behind});
    EXPECT_EQ(hall.lenses().drawn(), 0);
    EXPECT_EQ(hall.light(), 0.0);
    hall.draw({dark, at_us});
    EXPECT_EQ(hall.lenses().drawn(), 1);
    EXPECT_GT(hall.light(), 0.0);
}

TEST_F(Lens, StrayLightShowsALensBesideItsBeam) {
    LensSettings settings;
    settings.stray = 0.01f;
    DarkHall hall(64, 48, 40, 60, {}, settings);
    shared::Light light = aimed_light({0, 10, 0}, {10, 0, 0}, 10, 1000);
    light.bounce_cd = vec3(50); // 628 lumens
    hall.draw({light});
    const vec3 lens = lens_of(light);
    const double cosine = double{glm::dot(-lens, light.axis_w)} / double{glm::length(lens)};
    // Lambert: flux / pi on the axis.
    const double lux = 0.01 * 50 * 4 * cosine / double{glm::dot(lens, lens)};
    EXPECT_NEAR(hall.light() * hall.pixel_sr(hall.pixel_of(lens)) / lux, 1.0, 0.01);
}

TEST_F(Lens, IsHiddenBehindAWallButNotByItsOwnBody) {
    const shared::Light light = aimed_light({0, 10, 0}, {0, 0, 0}, 10, 1000);
    const auto light_with_wall = [&](float wall_y) {
        DarkHall hall(64, 48, 40, wall_y);
        hall.draw({light});
        return hall.light();
    };
    const double open = light_with_wall(60);
    EXPECT_GT(open, 0);
    EXPECT_EQ(light_with_wall(9.0f), 0.0); // the lens is at 9.745 m
    EXPECT_NEAR(light_with_wall(9.5f) / open, 1.0, 1e-6);
}

// The gobo is seen in the lens: through each of its places another part of the gate.
TEST_F(Lens, ShowsTheGoboWithTheLightOfTheBeam) {
    DarkHall hall(240, 160, 14, 30);
    for (const float focus_m : {1.5f, 40.0f}) {
        shared::Light light = aimed_light({0, 4, 0}, {0.15f, 0, 0.1f}, 30, 30.0f);
        light.focus_per_m = 1.0f / focus_m;
        light.lens_radius_m = light.disc_radius_m = 0.1f;
        put_gobo(light, 2, 20);
        hall.draw({light});
        const image::ImageF frame = hall.frame();

        // The gate that the eye sees through the lens, sampled sharp.
        const vec3 q = shared::to_gate(light, -light.position_m);
        const glm::vec2 middle = glm::vec2(q) / (q.z * light.tan_field);
        const float before_m = q.z - 0.1f / light.tan_field;
        const float blur = 0.1f * (before_m / focus_m - 1.0f) / (0.1f + before_m * light.tan_field);
        const auto gate_at = [&](const glm::vec2& place) {
            return light.intensity_cd.y * shared::beam_gate(light, middle + blur * place,
                                                            shared::even_focus(light, light.edge),
                                                            test_gobos())
                                              .y;
        };
        double sum = 0;
        int count = 0;
        for (int y = -50; y <= 50; ++y)
            for (int x = -50; x <= 50; ++x) {
                const glm::vec2 place = glm::vec2(x, y) / 50.0f;
                if (glm::length(place) > 1.0f) continue;
                sum += double{gate_at(place)};
                ++count;
            }
        const double to_nit = 1.0 / double{glm::dot(q, q)} / hall.pixel_sr(hall.pixel_of(lens_of(light)));
        EXPECT_NEAR(hall.light() / (sum / count * to_nit), 1.0, 0.02) << focus_m;

        // And each place of the picture of the lens by itself.
        const double disc_sr = 3.14159265358979 * 0.01 * double{glm::dot(-lens_of(light), light.axis_w)} /
                               std::pow(double{glm::length(lens_of(light))}, 3);
        double difference = 0, mirrored = 0, mean = 0;
        for (int y = -6; y <= 6; ++y)
            for (int x = -6; x <= 6; ++x) {
                const glm::vec2 place = glm::vec2(x, y) / 10.0f;
                const glm::ivec2 at(
                    hall.pixel_of(lens_of(light) + 0.1f * (place.x * light.axis_u + place.y * light.axis_v)));
                const glm::vec2 rounded = (glm::vec2(at) + 0.5f - hall.pixel_of(lens_of(light)));
                const float px = pixels_per_rad(hall.view()) * 0.1f / glm::length(lens_of(light));
                // The light looks against the view: u and v lie in the picture as projected.
                const glm::vec2 u = glm::normalize(hall.pixel_of(lens_of(light) + 0.1f * light.axis_u) -
                                                   hall.pixel_of(lens_of(light)));
                const glm::vec2 v = glm::normalize(hall.pixel_of(lens_of(light) + 0.1f * light.axis_v) -
                                                   hall.pixel_of(lens_of(light)));
                const glm::vec2 back(glm::dot(rounded, u) / px, glm::dot(rounded, v) / px);
                const double expected = double{gate_at(back)} / double{glm::dot(q, q)} / disc_sr;
                const double turned = double{gate_at(-back)} / double{glm::dot(q, q)} / disc_sr;
                difference += std::abs(double{frame.at(at.x, at.y)[1]} - expected);
                mirrored += std::abs(double{frame.at(at.x, at.y)[1]} - turned);
                mean += expected;
            }
        // A pixel of the lens is wider than the sharp gate.
        EXPECT_LT(difference / mean, 0.2) << focus_m;
        EXPECT_GT(mirrored / mean, 0.5) << focus_m;
    }
}

TEST_F(Lens, MoreLensesThanOneBufferHolds) {
    DarkHall hall(320, 100, 40, 60);
    std::vector<shared::Light> lights;
    double lux = 0, sum = 0;
    for (int k = 0; k < 600; ++k) {
        const vec3 from(static_cast<float>(k % 30) * 0.5f - 7.0f, 20, static_cast<float>(k / 30) * 0.3f - 3);
        lights.push_back(aimed_light(from, {0, 0, 0}, 30, 100.0f + static_cast<float>(k % 7) * 100.0f));
        hall.draw({lights.back()});
        sum += hall.light();
        lux += lux_at_eye(lights.back());
    }
    EXPECT_GT(lux, 0);
    hall.draw(lights);
    EXPECT_EQ(hall.lenses().drawn(), 600);
    EXPECT_NEAR(hall.light() / sum, 1.0, 0.001);
}

} // namespace
} // namespace ghost::render
