// SPDX-License-Identifier: Apache-2.0
// The two definitions of the light model, double (reference_beam.h) and float (shaders/shared), agree.
#include "image/pyramid.h"
#include "light/gobos.h"
#include "light/projector_beam.h"
#include "reference/reference_beam.h"
#include "support/test_stage.h"

#include "shared/beam.h"
#include "shared/haze.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <random>

namespace ghost::bake {
namespace {
using glm::dvec3;

double as_double(float value) {
    return static_cast<double>(value);
}

// Every kind of beam that a light can be.
shared::Light random_light(std::mt19937& random, int layers) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const auto between = [&](float a, float b) { return a + (b - a) * unit(random); };
    shared::Light light =
        spot({between(-3, 3), between(-3, 3), 5}, {between(-3, 3), between(-3, 3), 0}, between(1, 35), 0);
    light.cut_radius = between(0.8f, 2.0f);
    light.profile_power = between(0.7f, 6.0f);
    light.profile_scale = between(0.0f, 3.4f);
    light.intensity_cd = {between(10, 1e5f), between(10, 1e5f), between(10, 1e5f)};
    light.colour_b = {unit(random), unit(random), unit(random)};
    light.split = unit(random) < 0.5f ? shared::kNoSplit : between(-1, 1);
    light.split_soft = light.split < 0 ? 0.4f : 0.0f;
    light.iris_radius = between(0.2f, 1.2f);
    light.edge = between(0.01f, 0.3f);
    light.focus_per_m = between(0, 1);
    light.lens_radius_m = between(0, 0.2f);
    light.wheel_count = static_cast<std::uint32_t>(between(0, 2.99f));
    for (shared::Wheel& wheel : light.wheel) {
        wheel.layer_a = static_cast<std::uint32_t>(between(0, static_cast<float>(layers) - 0.01f));
        wheel.layer_b = static_cast<std::uint32_t>(between(0, static_cast<float>(layers) - 0.01f));
        wheel.shift = unit(random) < 0.5f ? 0.0f : unit(random);
        const float turn = between(0, 6.28f);
        wheel.cosine = std::cos(turn);
        wheel.sine = std::sin(turn);
        wheel.depth = between(-0.1f, 0.1f);
    }
    if (unit(random) < 0.5f) return light;
    light.shaped = unit(random) < 0.3f ? 1 : 2;
    light.iris_depth = between(-0.1f, 0.1f);
    light.wheel_count = static_cast<std::uint32_t>(between(0, 3.99f));
    for (shared::Blade& blade : light.blade) {
        const float turn = between(0, 6.28f);
        blade = {{std::cos(turn), std::sin(turn)}, between(-0.5f, 2.0f), between(-0.1f, 0.1f)};
    }
    const float turn = between(0, 6.28f);
    light.disc = {static_cast<std::uint32_t>(between(0, static_cast<float>(layers) - 0.01f)),
                  std::cos(turn),
                  std::sin(turn),
                  {between(-1, 1), between(-1, 1)},
                  between(0.2f, 1.0f),
                  between(-0.1f, 0.1f)};
    return light;
}

shared::Gobos two_gobos() {
    shared::Gobos gobos;
    std::mt19937 random(3);
    for (const unsigned cell : {16u, 64u}) {
        image::Image8 image(256, 256, 4);
        std::vector<std::uint8_t> colours(3 * (256 / cell) * (256 / cell));
        for (std::uint8_t& value : colours) value = static_cast<std::uint8_t>(random());
        for (unsigned y = 0; y < 256; ++y)
            for (unsigned x = 0; x < 256; ++x)
                for (unsigned c = 0; c < 4; ++c)
                    image.at(static_cast<int>(x), static_cast<int>(y))[c] =
                        c == 3 ? std::uint8_t{255} : colours[3 * (y / cell * (256 / cell) + x / cell) + c];
        scene::append_gobo(gobos, image.samples.data(), 256, 256);
    }
    return gobos;
}

// A curve that a laser sweeps.
void put_figure(shared::Light& light, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const float turn = 6.28f * unit(random);
    light.figure = {static_cast<std::uint32_t>(1 + random() % 3),
                    {0.4f + 0.6f * unit(random), 0.2f + unit(random)},
                    std::cos(turn),
                    std::sin(turn),
                    0.01f + 0.3f * unit(random),
                    6.28f * unit(random),
                    std::ceil(5.0f * unit(random))};
    light.wheel_count = light.shaped = 0;
    light.disc = {};
}

// A projector among other things in the gate.
void put_slide(shared::Light& light, const image::Pyramid& picture, std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    scene::Projector projector;
    projector.throw_ratio = 0.8f + std::abs(unit(random));
    projector.lens_shift = {0.5f * unit(random), 0.5f * unit(random)};
    projector.keystone_deg = {20.0f * unit(random), 20.0f * unit(random)};
    projector.contrast = 20;
    for (int k = 0; k < 4; ++k) projector.blend[k] = std::max(0.3f * unit(random), 0.0f);
    scene::project(projector, {}, {1, picture.extent, picture.mean, picture.side}, 0, light);
    light.iris_radius = 0.5f + std::abs(unit(random));
}

TEST(ReferenceBeam, AgreesWithTheSharedOne) {
    shared::Gobos gobos = two_gobos();
    image::Image8 film(64, 36, 4);
    for (std::size_t k = 0; k < film.samples.size(); ++k)
        film.samples[k] = k % 4 == 3 ? 255 : static_cast<std::uint8_t>((k / 32 * 7919) % 256);
    const image::Pyramid picture = image::make_pyramid(film, 64);
    gobos.slides.push_back({picture.side, picture.levels});
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    double worst = 0;
    int lit = 0;
    for (int k = 0; k < 2000; ++k) {
        shared::Light light = random_light(random, gobos.layers);
        if (k % 4 == 0) put_slide(light, picture, random);
        if (k % 4 == 1) put_figure(light, random);
        const ReferenceBeam beam(light, gobos);
        for (int n = 0; n < 50; ++n) {
            const float z = 0.05f + 10.0f * std::abs(unit(random));
            const glm::vec3 gate(1.3f * unit(random) * z * light.tan_field,
                                 1.3f * unit(random) * z * light.tan_field, n == 0 ? -z : z);
            const glm::vec3 live = shared::beam_candela(light, gate, gobos);
            const dvec3 ours = beam.candela(dvec3(gate));
            lit += ours.x > 0 ? 1 : 0;
            for (int c = 0; c < 3; ++c) {
                // At the foot of a soft edge only the difference to the beam's peak is a number.
                const double scale = std::max(ours[c], 1e-2 * as_double(light.intensity_cd[c]));
                worst = std::max(worst, std::abs(as_double(live[c]) - ours[c]) / scale);
            }
        }
    }
    std::printf("double beam against float: worst relative difference %.2g over %d lit points\n", worst, lit);
    EXPECT_GT(lit, 20000);
    EXPECT_LT(worst, 1e-4);
}

TEST(ReferenceBeam, BrdfAndPhaseAgreeWithTheSharedOnes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::normal_distribution<float> normal;
    const auto way = [&] {
        return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    };
    double worst = 0;
    for (int k = 0; k < 20000; ++k) {
        const shared::Brdf brdf = shared::brdf_of({unit(random), unit(random), unit(random)},
                                                  0.2f + 0.8f * unit(random), unit(random), unit(random));
        const glm::vec3 n = way(), v = way(), l = way();
        const glm::vec3 live = shared::brdf_times_cosine(brdf, n, v, l);
        const dvec3 ours = reference_brdf_times_cosine(brdf, dvec3(n), dvec3(v), dvec3(l));
        const float nv = unit(random);
        const dvec3 albedo =
            reference_brdf_albedo(brdf, as_double(nv)) - dvec3(shared::brdf_albedo(brdf, nv));
        for (int c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(as_double(live[c]) - ours[c]) / std::max(ours[c], 1e-2));
            worst = std::max(worst, std::abs(albedo[c]));
        }
        const shared::Haze haze{0.1f, 0.1f, 0.9f * unit(random), -0.9f * unit(random), unit(random)};
        const float cosine = 2 * unit(random) - 1;
        worst = std::max(worst, std::abs(as_double(shared::haze_phase(haze, cosine, 1.0f)) /
                                             ReferenceMedium(haze, {}, 1).phase(as_double(cosine)) -
                                         1));
    }
    std::printf("double reflection and phase against float: worst relative difference %.2g\n", worst);
    EXPECT_LT(worst, 2e-4);
}

} // namespace
} // namespace ghost::bake
