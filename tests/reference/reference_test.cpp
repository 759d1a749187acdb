// SPDX-License-Identifier: Apache-2.0
// The reference picture against closed forms, an adaptive quadrature and the baker.
#include "light/gobos.h"
#include "reference/reference.h"
#include "reference/trace_lit.h"
#include "support/likeness.h"
#include "support/test_stage.h"

#include <atomic>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace ghost::bake {
namespace {
using glm::dvec3;
using std::numbers::pi;

double d(float value) {
    return static_cast<double>(value);
}

// 1 pixel wide unless said otherwise: the pixel's centre looks straight at the target.
scene::Camera looking(const glm::vec3& from, const glm::vec3& to, int width = 1, int height = 1) {
    scene::Camera camera;
    camera.position_m = from;
    camera.target_m = to;
    camera.fov_y_deg = 40;
    camera.width = width;
    camera.height = height;
    return camera;
}

shared::Haze even_haze(float extinction, float scattering, float g) {
    return {extinction, scattering, g, 0.0f, 0.0f};
}

image::ImageF picture_of(const Tracer* tracer, const scene::Camera& camera,
                         const std::vector<shared::Light>& lights, const shared::Haze& haze,
                         const ReferenceOptions& options, float ambient_lux = 0,
                         const shared::Gobos& gobos = {}) {
    auto picture = reference_picture(tracer, camera, lights, gobos, haze, ambient_lux, options);
    EXPECT_TRUE(picture.ok()) << picture.error().text();
    return picture.ok() ? std::move(*picture) : image::ImageF(camera.width, camera.height, 3);
}

// A source that shines everywhere alike, without a lens.
struct Bare {
    shared::Light light;
    ReferenceOptions options;

    Bare(const glm::vec3& at_m, double candela) : light(spot(at_m, at_m + glm::vec3(0, 0, -1), 45, 0)) {
        light.lens_m = -1e4f;
        options.beam = [candela](const dvec3&) { return dvec3(candela); };
    }
};

// Simpson's rule, halved until two levels agree (Lyness 1969).
double adaptive(const std::function<double(double)>& f, double a, double b, double fa, double fm, double fb,
                double whole, double tolerance, int depth) {
    const double m = 0.5 * (a + b);
    const double fl = f(0.5 * (a + m));
    const double fr = f(0.5 * (m + b));
    const double left = (m - a) / 6 * (fa + 4 * fl + fm);
    const double right = (b - m) / 6 * (fm + 4 * fr + fb);
    const double error = left + right - whole;
    if (depth == 0 || std::abs(error) < 15 * tolerance) return left + right + error / 15;
    return adaptive(f, a, m, fa, fl, fm, left, tolerance / 2, depth - 1) +
           adaptive(f, m, b, fm, fr, fb, right, tolerance / 2, depth - 1);
}

double integral(const std::function<double(double)>& f, double a, double b) {
    double sum = 0;
    constexpr int kParts = 64; // so that no peak is overlooked
    for (int k = 0; k < kParts; ++k) {
        const double x0 = a + (b - a) * k / kParts;
        const double x1 = a + (b - a) * (k + 1) / kParts;
        const double f0 = f(x0), fm = f(0.5 * (x0 + x1)), f1 = f(x1);
        sum += adaptive(f, x0, x1, f0, fm, f1, (x1 - x0) / 6 * (f0 + 4 * fm + f1), 1e-13, 40);
    }
    return sum;
}

TEST(Reference, AirlightOfABareSourceIsTheAngleItSees) {
    const Bare bare({1, 4, 0.5f}, 700);
    const scene::Camera camera = looking({0, 0, 0}, {0, 1, 0});
    const image::ImageF picture =
        picture_of(nullptr, camera, {bare.light}, even_haze(0, 0.03f, 0), bare.options);
    const double distance = std::hypot(1.0, 0.5);
    const double angle = std::atan(56 / distance) + std::atan(4 / distance); // far_m is 60
    const double expected = 700 * d(0.03f) / (4 * pi * distance) * angle;
    EXPECT_NEAR(d(picture.at(0, 0)[0]) / expected, 1, 1e-6);
}

TEST(Reference, AirlightWithExtinctionAndPhaseAgreesWithQuadrature) {
    for (const auto& [g, back_g, back_weight, extinction] : {std::array{0.0, 0.0, 0.0, 0.1},
                                                             {0.7, 0.0, 0.0, 0.05},
                                                             {-0.5, 0.0, 0.0, 0.3},
                                                             {0.77, -0.6, 0.035, 0.015}})
        for (const double away : {3.0, 0.5, 0.02}) {
            const Bare bare({static_cast<float>(away), 4, 0}, 100);
            const shared::Haze haze{static_cast<float>(extinction), 0.04f, static_cast<float>(g),
                                    static_cast<float>(back_g), static_cast<float>(back_weight)};
            const image::ImageF picture =
                picture_of(nullptr, looking({0, 0, 0}, {0, 1, 0}), {bare.light}, haze, bare.options);
            const auto lobe = [](double shape, double cosine) {
                return (1 - shape * shape) / (4 * pi * std::pow(1 + shape * shape - 2 * shape * cosine, 1.5));
            };
            const double x = d(bare.light.position_m.x);
            const double expected = integral(
                [&](double t) {
                    const double r = std::hypot(x, t - 4);
                    const double cosine = (4 - t) / r; // of the light's way with the way to the eye
                    const double phase = (1 - d(haze.back_weight)) * lobe(d(haze.forward_g), cosine) +
                                         d(haze.back_weight) * lobe(d(haze.back_g), cosine);
                    return 100 * d(haze.scattering_per_m) * phase *
                           std::exp(-d(haze.extinction_per_m) * (t + r)) / (r * r);
                },
                0, 60);
            EXPECT_NEAR(d(picture.at(0, 0)[1]) / expected, 1, 1e-5) << "g " << g << ", away " << away;
        }
}

// Seen from the side at distance D, a beam of even candela over +-60 degrees fills 120 degrees of the angle.
TEST(Reference, WideBeamFromTheSide) {
    shared::Light light = spot({0, 0, 0}, {0, 0, -1}, 60, 0);
    light.profile_scale = 0;
    light.cut_radius = 1;
    light.iris_radius = 9;
    light.focus_per_m = 0;
    light.lens_radius_m = 0;
    const scene::Camera camera = looking({-30, 0, -2}, {0, 0, -2});
    ReferenceOptions options;
    const image::ImageF picture = picture_of(nullptr, camera, {light}, even_haze(0, 0.02f, 0), options);
    const double expected = 1000 * d(0.02f) / (4 * pi * 2) * (2 * pi / 3);
    EXPECT_NEAR(d(picture.at(0, 0)[0]) / expected, 1, 1.0 / 4096); // two edges, half a sample each
}

TEST(Reference, ARayThroughTheApexIsFinite) {
    shared::Light light = spot({0, 0, 0}, {0, 1, 0}, 10, 0);
    light.lens_m = 0.2f;
    light.lens_radius_m = 0; // no blur by the lens
    const shared::Haze haze = even_haze(0, 0.03f, 0.5f);
    // Into the beam, and out of the back of the lamp: 1/z^2 from the lens to the end of the ray.
    const double front = picture_of(nullptr, looking({0, 8, 0}, {0, 0, 0}), {light}, haze, {}).at(0, 0)[0];
    const double behind = picture_of(nullptr, looking({0, -3, 0}, {0, 0, 0}), {light}, haze, {}).at(0, 0)[0];
    const double lens = d(light.lens_m);
    const double phase = 0.75 / (4 * pi) / std::pow(1.25 - 1.0, 1.5);
    const double back_phase = 0.75 / (4 * pi) / std::pow(1.25 + 1.0, 1.5);
    EXPECT_NEAR(front / (1000 * d(0.03f) * phase * (1 / lens - 1.0 / 8)), 1, 2e-4);
    EXPECT_NEAR(behind / (1000 * d(0.03f) * back_phase * (1 / lens - 1.0 / 57)), 1, 2e-4);
    light.lens_m = 0; // the integral itself diverges here
    EXPECT_GT(picture_of(nullptr, looking({0, 8, 0}, {0, 0, 0}), {light}, haze, {}).at(0, 0)[0], 0.0f);
}

TEST(Reference, NothingShinesBehindTheLens) {
    shared::Light light = spot({0, 0, 4}, {0, 0, 0}, 30, 0);
    light.lens_m = 0.5f;
    const shared::Haze haze = even_haze(0.01f, 0.01f, 0.3f);
    const auto at_height = [&](float z) {
        return picture_of(nullptr, looking({0, -5, z}, {0, 0, z}), {light}, haze, {}).at(0, 0)[0];
    };
    EXPECT_EQ(at_height(3.51f), 0.0f);
    EXPECT_GT(at_height(3.49f), 0.0f);
}

scene::Stage wall(float specular) {
    scene::Stage stage;
    place(stage, add_mesh(stage, quad_mesh({-9, 5, -9}, {18, 0, 0}, {0, 0, 18}),
                          add_material(stage, {0.8f, 0.5f, 0.2f}, specular, 0.6f)));
    return stage;
}

TEST(Reference, WallShowsItsIrradiance) {
    const scene::Stage stage = wall(0);
    const Tracer tracer(stage);
    shared::Light light = spot({1, -2, 2}, {0, 5, 0}, 30, 0);
    light.profile_scale = 0;
    const shared::Haze haze = even_haze(0.05f, 0, 0);
    const scene::Camera camera = looking({0, 0, 0}, {0, 5, 0}, 9, 9);
    const image::ImageF picture = picture_of(&tracer, camera, {light}, haze, {});
    for (const auto& [x, y] : {std::pair{4, 4}, {2, 6}, {7, 3}}) {
        const double tan_y = std::tan(glm::radians(20.0));
        const dvec3 at(5 * tan_y * ((x + 0.5) * 2 / 9 - 1), 5, 5 * tan_y * (1 - (y + 0.5) * 2 / 9));
        const dvec3 way = at - dvec3(1, -2, 2);
        const double d2 = glm::dot(way, way);
        const double expected = 1000 * d(0.5f) / pi * 7 / std::sqrt(d2) / d2 *
                                std::exp(-d(0.05f) * (std::sqrt(d2) + glm::length(at)));
        EXPECT_NEAR(d(picture.at(x, y)[1]) / expected, 1, 1e-5) << x << " " << y;
    }
    ReferenceOptions air_only;
    air_only.surfaces = false;
    EXPECT_EQ(picture_of(&tracer, camera, {light}, haze, air_only).at(4, 4)[1], 0.0f); // nothing scatters
}

// Surfaces against the baker's picture without baking, which has other samples and float beams.
TEST(Reference, SurfacesAgreeWithTraceLit) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    const scene::Camera camera = edgy_camera(96, 54);
    const std::vector<shared::Light> lights = {spot({-3, -3, 6}, {0.5f, 5, 1}, 14, 0),
                                               spot({4, 9, 6}, {1, 4, 0}, 18, 1)};
    const shared::Haze haze = even_haze(0.03f, 0.03f, 0.5f);
    ReferenceOptions options;
    options.air = false;
    options.pixel_samples = 8;
    const image::ImageF ours = picture_of(&tracer, camera, lights, haze, options);
    const image::ImageF lit = trace_lit(stage, camera, lights, {}, 64, haze);
    const double psnr = display_psnr(ours, lit);
    std::printf("surfaces against trace_lit: display PSNR %.1f dB\n", psnr);
    EXPECT_GT(psnr, 40);
}

TEST(Reference, BoxThrowsShadowOnFloorAndInAir) {
    scene::Stage stage;
    const int grey = add_material(stage, glm::vec3(0.5f));
    place(stage, add_mesh(stage, quad_mesh({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), grey));
    const int box = add_mesh(stage, box_mesh({0.5f, 0.5f, 0.1f}), grey);
    place(stage, box, glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 2)));
    const Tracer tracer(stage);
    shared::Light light = spot({0, 0, 4}, {0, 0, 0}, 40, 0);
    light.disc_radius_m = 0.2f;
    light.edge = 0.01f;
    light.focus_per_m = 0.25f;
    const shared::Haze haze = even_haze(0, 0.02f, 0);
    // The upper rim, 1.9 m below the lamp, throws the edge: at 0.5 * 4 / 1.9 on the floor.
    const auto floor_at = [&](float x, const ReferenceOptions& options) {
        return picture_of(&tracer, looking({x, -3, 1}, {x, 0, 0}), {light}, haze, options).at(0, 0)[0];
    };
    ReferenceOptions surfaces;
    surfaces.air = false;
    EXPECT_EQ(floor_at(1.03f, surfaces), 0.0f);
    EXPECT_GT(floor_at(1.07f, surfaces), 0.0f);
    ReferenceOptions unshadowed = surfaces;
    unshadowed.shadows = false;
    EXPECT_GT(floor_at(1.03f, unshadowed), 0.0f);
    // A disc of a lamp sees round the rim: part of the light at the edge of a point's shadow.
    ReferenceOptions disc = surfaces;
    disc.lens_samples = 64;
    const double fraction = d(floor_at(1.053f, disc)) / d(floor_at(1.053f, unshadowed));
    EXPECT_NEAR(fraction, 0.5, 0.1);
    EXPECT_EQ(floor_at(0.2f, disc), 0.0f);

    // Through the air at z = 1 the beam is dark where |x| < 0.5 * 3 / 1.9, and lit beyond.
    ReferenceOptions air;
    air.surfaces = false;
    ReferenceOptions open = air;
    open.shadows = false;
    const scene::Camera across = looking({-8, 0, 1}, {0, 0, 1});
    const double shadowed = picture_of(&tracer, across, {light}, haze, air).at(0, 0)[0];
    const double whole = picture_of(&tracer, across, {light}, haze, open).at(0, 0)[0];
    const double rim = std::atan(0.5 / 1.9);
    const double lost = integral(
        [&](double angle) {
            const dvec3 gate(3 * std::tan(angle), 0, 3);
            return ReferenceBeam(light, {}).candela(gate).x * d(haze.scattering_per_m) / (4 * pi * 3);
        },
        -rim, rim);
    EXPECT_NEAR((whole - shadowed) / lost, 1, 2e-3);
}

TEST(Reference, BodiesThrowNoShadowInAir) {
    scene::Stage stage;
    const int body = add_mesh(stage, box_mesh(glm::vec3(0.3f)), add_material(stage, glm::vec3(0.5f)));
    place(stage, body, glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 4)), 0);
    const Tracer hung(stage);
    const shared::Light light = spot({0, 0, 4}, {0, 0, 0}, 20, 0);
    const shared::Haze haze = even_haze(0.02f, 0.02f, 0.4f);
    const scene::Camera camera = looking({-6, 0, 1}, {0, 0, 1});
    EXPECT_EQ(picture_of(&hung, camera, {light}, haze, {}).samples,
              picture_of(nullptr, camera, {light}, haze, {}).samples);
}

TEST(Reference, AmbientAndEmissionThroughTheHaze) {
    scene::Stage stage = wall(0);
    stage.materials[0].emission = {3, 0, 1};
    const Tracer tracer(stage);
    const image::ImageF picture =
        picture_of(&tracer, looking({0, 0, 0}, {0, 5, 0}), {}, even_haze(0.1f, 0.1f, 0), {}, 50);
    const double seen = std::exp(-5 * d(0.1f));
    EXPECT_NEAR(d(picture.at(0, 0)[0]), (d(0.8f) / pi * 50 + 3) * seen, 1e-4);
    EXPECT_NEAR(d(picture.at(0, 0)[1]), d(0.5f) / pi * 50 * seen, 1e-4);
}

TEST(Reference, DensityScalesAndBoundsTheHaze) {
    const Bare bare({1, 4, 0.5f}, 700);
    const scene::Camera camera = looking({0, 0, 0}, {0, 1, 0});
    ReferenceOptions twice = bare.options;
    twice.density = [](const dvec3&) { return 2.0; };
    EXPECT_NEAR(
        d(picture_of(nullptr, camera, {bare.light}, even_haze(0.03f, 0.02f, 0.6f), twice).at(0, 0)[0]) /
            d(picture_of(nullptr, camera, {bare.light}, even_haze(0.06f, 0.04f, 0.6f), bare.options)
                  .at(0, 0)[0]),
        1, 1e-6);
    // Haze thickening along the ray, against quadrature with the depth integrated on paper.
    ReferenceOptions rising = bare.options;
    rising.density = [](const dvec3& p) { return 0.1 * p.y; };
    rising.far_m = 10;
    const double got =
        d(picture_of(nullptr, camera, {bare.light}, even_haze(0.2f, 0.1f, 0), rising).at(0, 0)[0]);
    const double expected = integral(
        [](double t) {
            const double r = std::sqrt(1.25 + (t - 4) * (t - 4));
            const double depth = d(0.2f) * 0.1 * (0.5 * t * t + r * 0.5 * (t + 4));
            return 700 * d(0.1f) * 0.1 * t / (4 * pi) * std::exp(-depth) / (r * r);
        },
        0, 10);
    EXPECT_NEAR(got / expected, 1, 1e-5);
}

TEST(Reference, ConvergesAndIsRepeatable) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    const scene::Camera camera = edgy_camera(48, 27);
    image::Image8 stripes(256, 256, 4);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (int c = 0; c < 4; ++c) stripes.at(x, y)[c] = c == 3 || (x / 8 + y / 32) % 2 == 0 ? 255 : 0;
    shared::Gobos gobos;
    scene::append_gobo(gobos, stripes.samples.data(), 256, 256);
    std::vector<shared::Light> lights = {spot({-3, 2, 6}, {0.5f, 5, 1}, 8, 0),
                                         spot({2, 11, 6}, {0, -6, 2}, 12, 1)};
    lights[1].wheel_count = 1;
    lights[1].wheel[0] = {1, 0, 0, 1, 0, 0};
    for (shared::Light& light : lights) light.lens_m = 0.3f;
    const shared::Haze haze = even_haze(0.03f, 0.03f, 0.6f);
    const auto with = [&](int samples, int threads) {
        ReferenceOptions options;
        options.surfaces = false;
        options.air_samples = samples;
        options.threads = threads;
        return picture_of(&tracer, camera, lights, haze, options, 0, gobos);
    };
    const image::ImageF finest = with(32768, 0);
    double last = 1e9;
    for (const int samples : {1024, 4096, 8192}) {
        const image::ImageF picture = with(samples, 0);
        double error = 0, sum = 0;
        for (std::size_t k = 0; k < finest.samples.size(); ++k) {
            error += std::abs(d(picture.samples[k]) - d(finest.samples[k]));
            sum += d(finest.samples[k]);
        }
        std::printf("%d samples: mean error %.3g of the mean, display PSNR %.1f dB\n", samples, error / sum,
                    display_psnr(picture, finest));
        EXPECT_LT(error, 0.7 * last);
        last = error;
        if (samples == 4096) {
            EXPECT_LT(error / sum, 2e-3);
            EXPECT_EQ(picture.samples, with(4096, 1).samples);
        }
    }
}

TEST(Reference, EveryTakesTheSamePixels) {
    const shared::Light light = spot({0, 0, 4}, {0, 0, 0}, 20, 0);
    const shared::Haze haze = even_haze(0.02f, 0.02f, 0.4f);
    const scene::Camera camera = looking({-6, 0, 2}, {0, 0, 2}, 11, 7);
    ReferenceOptions options;
    options.air_samples = 256;
    const image::ImageF all = picture_of(nullptr, camera, {light}, haze, options);
    options.every = 4;
    const image::ImageF some = picture_of(nullptr, camera, {light}, haze, options);
    ASSERT_EQ(some.width, 3);
    ASSERT_EQ(some.height, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) EXPECT_EQ(some.at(x, y)[2], all.at(4 * x, 4 * y)[2]);
    EXPECT_GT(some.at(1, 1)[2], 0.0f);
}

TEST(Reference, BadInputIsAnErrorThatSaysWhere) {
    Bare bare({0, 4, 0}, 1);
    const scene::Camera camera = looking({0, 0, 0}, {0, 1, 0}, 8, 8);
    bare.options.air_samples = 64;
    const auto text = [&](const shared::Haze& haze, const ReferenceOptions& options) {
        const auto picture = reference_picture(nullptr, camera, {bare.light}, {}, haze, 0, options);
        return picture.ok() ? std::string() : picture.error().text();
    };
    const shared::Haze haze = even_haze(0.02f, 0.02f, 0);
    EXPECT_EQ(text(haze, bare.options), "");
    ReferenceOptions hole = bare.options;
    hole.beam = [](const dvec3& gate) { // below the pixels' middle row, on the left
        return dvec3(gate.z > 0.1 && gate.x > 0.1 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
    };
    const std::string message = text(haze, hole);
    EXPECT_NE(message.find("pixel ("), std::string::npos) << message;
    EXPECT_NE(message.find("of 64 pixels"), std::string::npos) << message;
    EXPECT_EQ(message.find("64 of 64"), std::string::npos) << message;
    EXPECT_NE(text(even_haze(std::numeric_limits<float>::quiet_NaN(), 1, 0), bare.options).find("64 of 64"),
              std::string::npos);
    ReferenceOptions none = bare.options;
    none.air_samples = 0;
    EXPECT_NE(text(haze, none).find("air_samples is 0, expected 1"), std::string::npos);
    ReferenceOptions no_end = bare.options;
    no_end.far_m = std::numeric_limits<float>::infinity();
    EXPECT_NE(text(haze, no_end).find("far_m"), std::string::npos);
}

TEST(Reference, StopsSoonAndTellsItsProgress) {
    const shared::Light light = spot({0, 0, 4}, {0, 0, 0}, 20, 0);
    const scene::Camera camera = looking({-6, 0, 2}, {0, 0, 2}, 64, 32);
    const shared::Haze haze = even_haze(0.02f, 0.02f, 0.4f);
    ReferenceOptions options;
    options.air_samples = 64;
    double fraction = 0;
    options.progress = [&](double now) {
        EXPECT_GT(now, fraction);
        fraction = now;
    };
    EXPECT_TRUE(reference_picture(nullptr, camera, {light}, {}, haze, 0, options).ok());
    EXPECT_EQ(fraction, 1.0);
    fraction = 0;
    std::atomic<int> asked = 0;
    options.stop = [&] { return ++asked > 100; };
    const auto stopped = reference_picture(nullptr, camera, {light}, {}, haze, 0, options);
    ASSERT_FALSE(stopped.ok());
    EXPECT_NE(stopped.error().text().find("stopped"), std::string::npos);
    EXPECT_LT(fraction, 0.5);
}

} // namespace
} // namespace ghost::bake
