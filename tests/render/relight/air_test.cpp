// SPDX-License-Identifier: Apache-2.0
// Haze that is not the same everywhere and light that falls off otherwise than physics has it, against a
// march of 4096 steps in double, written down here once more from the formula; swirls in time and wind; no
// haze at all.
#include "shared/beam.h"
#include "shared/haze.h"
#include "support/likeness.h"
#include "support/test_view.h"

#include <cstdio>

namespace ghost::render {
namespace {

using glm::dvec3;
using glm::vec3;

class Smoke : public RelightTest {};

constexpr float kWall_m = 6;

shared::Air swirling(float unevenness, float patch_m) {
    shared::Air air = even_air();
    air.unevenness = unevenness;
    air.per_m = shared::kPi / patch_m; // as the show file has it: air_of
    return air;
}

shared::Air with_plume(shared::Air air) {
    air.plume[air.hazers++] = {{-1.5f, 2, 3.2f}, 4, glm::normalize(vec3(1, 0, 0.2f)), 0.27f, 6, 0};
    return air;
}

scene::Passes house() {
    return wall_passes(camera_at({0, -12, 3}, {0, 4, 3}, 26, 45, 27), kWall_m);
}

double factor(const shared::Attenuation& a, double d_m) {
    return d_m * d_m /
           (static_cast<double>(a.constant) + static_cast<double>(a.linear) * d_m +
            static_cast<double>(a.quadratic) * d_m * d_m);
}

// Rays through the middles of the pixels. Light is weakened as by even haze.
image::ImageF reference_of(const scene::Passes& passes, const shared::Light& light, const shared::Air& air) {
    constexpr int kSteps = 4096;
    image::ImageF picture(passes.width, passes.height, 3);
    const dvec3 eye(eye_of(passes));
    const auto phase = [](double g, double cosine) {
        return (1 - g * g) / (4 * 3.14159265358979 * std::pow(1 + g * g - 2 * g * cosine, 1.5));
    };
    const double extinction = kHaze.extinction_per_m, back = kHaze.back_weight;
    for (int y = 0; y < passes.height; ++y)
        for (int x = 0; x < passes.width; ++x) {
            const dvec3 dir(ray_through(passes, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
            const glm::vec4 surface = passes.fragments[static_cast<std::size_t>(y * passes.width + x)];
            const double far = surface.w < 0 ? 60.0 : glm::length(dvec3(surface) - eye);
            dvec3 sum(0);
            for (int k = 0; k < kSteps; ++k) {
                const double t = (k + 0.5) * far / kSteps;
                const dvec3 place = eye + t * dir;
                const dvec3 way = place - dvec3(light.position_m);
                const vec3 gate = shared::to_gate(light, vec3(way));
                if (gate.z <= light.lens_m) continue;
                const vec3 candela = shared::beam_candela(light, gate, test_gobos());
                if (candela == vec3(0)) continue;
                const double distance = glm::length(way);
                const double cosine = -glm::dot(way, dir) / distance;
                sum += dvec3(candela) *
                       (((1 - back) * phase(kHaze.forward_g, cosine) + back * phase(kHaze.back_g, cosine)) *
                        std::exp(-extinction *
                                 (t + distance * (1.0 - static_cast<double>(light.lens_m / gate.z)))) /
                        (distance * distance) * factor(air.attenuation, distance) *
                        static_cast<double>(shared::air_density(air, vec3(place))));
            }
            sum *= static_cast<double>(kHaze.scattering_per_m) * far / kSteps;
            for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<float>(sum[c]);
        }
    return picture;
}

Settings smoky(const shared::Air& air) {
    Settings settings;
    settings.haze = kHaze;
    settings.air_field = air;
    settings.beams.uneven = air.unevenness > 0 || air.hazers > 0;
    return settings;
}

image::ImageF drawn_smoke(const scene::Passes& passes, const shared::Light& light, const Settings& settings) {
    Relighter relighter(device(), passes, test_gobos(), 1, settings);
    relighter.draw({light});
    return relighter.frame();
}

shared::Light across() {
    return aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 24, 8000);
}

TEST_F(Smoke, SwirlsAndPlumesAgreeWithTheReference) {
    shared::Light gobo = across();
    put_gobo(gobo, 2, 20);
    struct Case {
        const char* name;
        shared::Light light;
        shared::Air air;
    };
    const Case cases[] = {
        {"swirls of 2.5 m", across(), swirling(0.7f, 2.5f)},
        {"swirls of 1 m", across(), swirling(1, 1)},
        {"a plume", across(), with_plume(even_air())},
        {"both", across(), with_plume(swirling(0.7f, 2.5f))},
        {"both, gobo", gobo, with_plume(swirling(0.7f, 2.5f))},
        {"both, at the camera", aimed_light({1, 5, 6}, {0.5f, -12, 3}, 16, 2000),
         with_plume(swirling(0.7f, 2.5f))},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.name);
        const image::ImageF reference = reference_of(house(), one.light, one.air);
        const image::ImageF gate = drawn_smoke(house(), one.light, smoky(one.air));
        const Difference difference = compare(gate, reference);
        const double even_db =
            likeness(drawn_smoke(house(), one.light, smoky(even_air())), reference).psnr_db;
        const double db = likeness(gate, reference).psnr_db;
        std::printf("%-20s gate: %.1f dB, bias %.2f %%; even haze instead: %.1f dB\n", one.name, db,
                    100 * difference.mean_bias, even_db);
        EXPECT_GE(db, 45.0);
        EXPECT_LT(std::abs(difference.mean_bias), 0.006);
        EXPECT_GE(db, even_db + 6); // the swirls are there, and where they should be
    }
}

// Rays that pass close to a lamp see nearly all of their way in a few degrees at both ends: what stands there
// for many swirls must be their mean, or they are rays of a sun round the lamp.
TEST_F(Smoke, SwirlsMakeNoSunRoundALampThatFacesTheCamera) {
    const scene::Passes close = wall_passes(camera_at({-1, -2, 2}, {-1.3f, 5, 4.5f}, 30, 45, 27), 9);
    const shared::Light light = aimed_light({-1.2f, 5, 5}, {-1, -2, 2.2f}, 24, 2000);
    for (const shared::Air& air : {swirling(0.8f, 1.5f), with_plume(even_air())}) {
        const image::ImageF reference = reference_of(close, light, air);
        const image::ImageF gate = drawn_smoke(close, light, smoky(air));
        float least = 1e9f, most = 0;
        for (std::size_t k = 0; k < reference.samples.size(); k += 3) {
            if (reference.samples[k] <= 0.2f) continue;
            const float ratio = gate.samples[k] / reference.samples[k];
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
        const double db = likeness(gate, reference).psnr_db;
        std::printf("%s: %.1f dB, ratio %.3f to %.3f\n", air.hazers > 0 ? "plume" : "swirls", db,
                    static_cast<double>(least), static_cast<double>(most));
        EXPECT_GE(db, 50.0);
        EXPECT_GE(least, air.hazers > 0 ? 0.9f : 0.97f);
        EXPECT_LE(most, air.hazers > 0 ? 1.15f : 1.03f);
    }
}

TEST_F(Smoke, TheSameMomentIsTheSamePicture) {
    const scene::Passes passes = house();
    shared::Air later = with_plume(swirling(0.8f, 2));
    later.drift_m = {3, 1, 0};
    later.churn = 0.7f;
    Relighter relighter(device(), passes, test_gobos(), 1, smoky(with_plume(swirling(0.8f, 2))));
    relighter.draw({across()});
    const image::ImageF now = relighter.frame();
    relighter.set_air(later);
    relighter.draw({across()});
    const image::ImageF then = relighter.frame();
    EXPECT_NE(now.samples, then.samples);
    relighter.set_air(with_plume(swirling(0.8f, 2)));
    relighter.draw({across()});
    EXPECT_EQ(relighter.frame().samples, now.samples);
    EXPECT_EQ(drawn_smoke(passes, across(), smoky(later)).samples, then.samples);
}

// The wind carries all swirls along: a camera, a light and a wall that go with it see them stand still.
TEST_F(Smoke, SwirlsGoWithTheWind) {
    const vec3 drift_m{2.5f, 0.75f, -0.5f};
    shared::Air air = swirling(0.9f, 2);
    const image::ImageF before = drawn_smoke(house(), across(), smoky(air));
    air.drift_m = drift_m;
    const image::ImageF stayed = drawn_smoke(house(), across(), smoky(air));
    const scene::Passes along = wall_passes(
        camera_at(vec3(0, -12, 3) + drift_m, vec3(0, 4, 3) + drift_m, 26, 45, 27), kWall_m + drift_m.y);
    shared::Light light = across();
    light.position_m += drift_m;
    const image::ImageF went = drawn_smoke(along, light, smoky(air));
    std::printf("swirls after 2.7 m of wind: %.1f dB for who went along, %.1f dB for who stayed\n",
                likeness(went, before).psnr_db, likeness(stayed, before).psnr_db);
    EXPECT_GE(likeness(went, before).psnr_db, 60.0);
    EXPECT_LT(likeness(stayed, before).psnr_db, 30.0);
}

TEST_F(Smoke, NoSmokeLeavesTheSurfacesAndNoBeam) {
    scene::Passes passes = house();
    shared::Light light = aimed_light({-3, 1, 6}, {1, 6, 2}, 30, 8000);
    light.pass = add_pass(passes, light.position_m, [](const vec3&) { return vec3(0.01f); });
    Settings none = smoky(with_plume(swirling(1, 2)));
    none.haze.extinction_per_m = none.haze.scattering_per_m = 0;
    Settings off = none;
    off.air = false;
    const image::ImageF surfaces = drawn_smoke(passes, light, off);
    EXPECT_GT(compare(surfaces, surfaces).mean_bias +
                  *std::max_element(surfaces.samples.begin(), surfaces.samples.end()),
              1.0);
    EXPECT_EQ(drawn_smoke(passes, light, none).samples, surfaces.samples);
    Settings only_air = none;
    only_air.surfaces = false;
    for (const float value : drawn_smoke(passes, light, only_air).samples) ASSERT_EQ(value, 0.0f);
}

const shared::Attenuation kAttenuations[] = {
    {0, 0.1f, 0}, {0, 0, 0.05f}, {1, 0.2f, 0.02f}, {0, 0, 1}, {2, 0, 0}};

TEST_F(Smoke, AttenuationOfSurfacesIsTheClosedForm) {
    scene::Passes passes = house();
    shared::Light light = aimed_light({-3, 1, 6}, {1, 6, 2}, 40, 300);
    light.pass = add_pass(passes, light.position_m, [](const vec3&) { return vec3(0.01f); });
    Settings settings = clear_air();
    const image::ImageF physical = drawn_smoke(passes, light, settings);
    for (const shared::Attenuation& attenuation : kAttenuations) {
        settings.air_field.attenuation = attenuation;
        const image::ImageF picture = drawn_smoke(passes, light, settings);
        double worst = 0;
        int lit = 0;
        for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
            const double d_m = glm::length(dvec3(passes.fragments[p]) - dvec3(light.position_m));
            const double expected = static_cast<double>(physical.samples[3 * p]) * factor(attenuation, d_m);
            if (expected < 1e-2) continue;
            ++lit;
            worst = std::max(worst, std::abs(static_cast<double>(picture.samples[3 * p]) / expected - 1));
        }
        std::printf("surfaces, %g %g %g: worst of %d pixels %.3f %%\n",
                    static_cast<double>(attenuation.constant), static_cast<double>(attenuation.linear),
                    static_cast<double>(attenuation.quadratic), lit, 100 * worst);
        EXPECT_GT(lit, 100);
        EXPECT_LT(worst, 0.002); // half floats, twice
    }
}

TEST_F(Smoke, AttenuationOfHazeIsTheClosedForm) {
    for (const shared::Attenuation& attenuation : kAttenuations) {
        shared::Air air = even_air();
        air.attenuation = attenuation;
        const image::ImageF reference = reference_of(house(), across(), air);
        const image::ImageF gate = drawn_smoke(house(), across(), smoky(air));
        const Difference difference = compare(gate, reference);
        std::printf("haze, %g %g %g: %.1f dB, bias %.3f %%\n", static_cast<double>(attenuation.constant),
                    static_cast<double>(attenuation.linear), static_cast<double>(attenuation.quadratic),
                    likeness(gate, reference).psnr_db, 100 * difference.mean_bias);
        EXPECT_GE(likeness(gate, reference).psnr_db, 42.0);
        EXPECT_LT(std::abs(difference.mean_bias), 0.01);
    }
}

} // namespace
} // namespace ghost::render
