// SPDX-License-Identifier: Apache-2.0
// Haze on the GPU against a march of 4096 steps in double on the CPU, written down here once more from the
// formula: beam x phase x transmittance / d^2 along the ray. A pixel is the mean of its four corners, as on
// the GPU, so that what is left is the error of the integrators.
#include "shared/beam.h"
#include "shared/haze.h"
#include "support/likeness.h"
#include "support/test_view.h"

#include <cstdio>
#include <map>
#include <string>

namespace ghost::render {
namespace {

using glm::dvec3;
using glm::vec3;

using Haze = RelightTest;

double phase(double g, double cosine) {
    return (1 - g * g) / (4 * 3.14159265358979 * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

// Haze on the rays through the pixels' corners (offset 0) or middles (0.5).
image::ImageF rays_of(const scene::Passes& passes, const std::vector<shared::Light>& lights, float offset) {
    constexpr int kSteps = 4096;
    image::ImageF picture(passes.width, passes.height, 3);
    const dvec3 eye(eye_of(passes));
    const double extinction = kHaze.extinction_per_m, back = kHaze.back_weight;
    for (int y = 0; y < passes.height; ++y)
        for (int x = 0; x < passes.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y * passes.width + x);
            const dvec3 dir(
                ray_through(passes, static_cast<float>(x) + offset, static_cast<float>(y) + offset));
            const glm::vec4 surface = passes.fragments[p];
            const double far = surface.w < 0 ? 60.0 : glm::length(dvec3(surface) - eye);
            const double step = far / kSteps;
            dvec3 sum(0);
            for (const shared::Light& light : lights)
                for (int k = 0; k < kSteps; ++k) {
                    const double t = (k + 0.5) * step;
                    const dvec3 way = eye + t * dir - dvec3(light.position_m);
                    const vec3 gate = shared::to_gate(light, vec3(way));
                    if (gate.z <= light.lens_m) continue;
                    const vec3 candela = shared::beam_candela(light, gate, test_gobos());
                    if (candela == vec3(0)) continue;
                    const double distance = glm::length(way);
                    const double cosine = -glm::dot(way, dir) / distance;
                    const double narrow = distance / std::hypot(distance, static_cast<double>(light.panel_m));
                    const double weight =
                        ((1 - back) * phase(narrow * kHaze.forward_g, cosine) +
                         back * phase(narrow * kHaze.back_g, cosine)) *
                        std::exp(-extinction *
                                 (t + distance * (1.0 - static_cast<double>(light.lens_m / gate.z)))) /
                        (distance * distance);
                    sum += dvec3(candela) * weight;
                }
            sum *= static_cast<double>(kHaze.scattering_per_m) * step;
            for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<float>(sum[c]);
        }
    return picture;
}

image::ImageF reference_of(const scene::Passes& passes, const std::vector<shared::Light>& lights) {
    const image::ImageF corners = rays_of(passes, lights, 0);
    image::ImageF picture(passes.width, passes.height, 3);
    for (int y = 0; y < passes.height; ++y)
        for (int x = 0; x < passes.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const int x1 = std::min(x + 1, passes.width - 1);
                const int y1 = std::min(y + 1, passes.height - 1);
                picture.at(x, y)[c] = 0.25f * (corners.at(x, y)[c] + corners.at(x1, y)[c] +
                                               corners.at(x, y1)[c] + corners.at(x1, y1)[c]);
            }
    return picture;
}

image::ImageF drawn(const scene::Passes& passes, const std::vector<shared::Light>& lights, Beams beams,
                    int steps) {
    Settings settings;
    settings.haze = kHaze;
    settings.beams.beams = beams;
    settings.beams.march_steps = steps;
    Relighter relighter(device(), passes, test_gobos(), static_cast<int>(lights.size()), settings);
    relighter.draw(lights);
    return relighter.frame();
}

struct View {
    const char* name;
    scene::Passes passes;
    std::vector<shared::Light> lights;
    // Limits a little above what was measured; rms as a fraction of the reference's mean. Four samples are
    // few where the beam comes at the camera, 110 over the whole ray are few for a narrow beam beside its
    // lens: that is how the papers have it.
    double cone_bias;
    double cone_rms;
    double march_bias;
    double march_rms;
};

// Blades in planes of their own, one gobo, the iris: focused so that nothing but one plane is sharp.
shared::Light shaped_light(const vec3& from, const vec3& to, float field_deg, bool gobo) {
    shared::Light light = aimed_light(from, to, field_deg, 8000);
    light.shaped = 2;
    light.haze_samples = 10;
    light.iris_depth = 0.05f;
    if (gobo) put_gobo(light, 2, 20);
    const float offsets[4] = {0.5f, 0.6f, 0.2f, 0.4f};
    for (int k = 0; k < 4; ++k) {
        const float turn = 0.2f - 1.5708f * static_cast<float>(k);
        light.blade[k] = {
            {-std::sin(turn), std::cos(turn)}, offsets[k], 0.07f + 0.005f * static_cast<float>(k)};
    }
    return light;
}

// A piece of a LED wall right before the wall at y = 6, towards the house.
shared::Light panel_light() {
    shared::Light light = aimed_light({0, 5.98f, 3}, {0, 0, 3}, 100, 2000, false);
    const scene::MeasuredProfile& measured = scene::area_profile();
    light.tan_field = measured.profile.tan_field;
    light.cut_radius = measured.profile.cut_radius;
    light.profile_power = measured.profile.power;
    light.profile_scale = measured.profile.scale;
    light.edge = measured.profile.edge;
    light.iris_radius = measured.aperture;
    light.lens_m = 0.01f;
    light.panel_m = 1.4f;
    return light;
}

std::vector<View> views() {
    const auto wall = [](const vec3& eye, const vec3& target, float fov_deg) {
        return wall_passes(camera_at(eye, target, fov_deg, 45, 27), 6.0f);
    };
    std::vector<View> all;
    const scene::Passes house = wall({0, -12, 3}, {0, 4, 3}, 26);
    // Across the picture.
    all.push_back({"wash across",
                   house,
                   {aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 30, 8000, false)},
                   0.0023,
                   0.015,
                   0.025,
                   0.42});
    all.push_back(
        {"spot across", house, {aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 14, 8000)}, 0.0023, 0.12, 0.098, 1.6});
    shared::Light gobo = aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 30, 8000);
    put_gobo(gobo, 1, 20);
    all.push_back({"gobo across", house, {gobo}, 0.0039, 0.08, 0.016, 0.25});
    put_gobo(gobo, 2, 50);
    all.push_back({"two gobos across", house, {gobo}, 0.0053, 0.26, 0.0017, 0.29});
    all.push_back({"into the camera",
                   house,
                   {aimed_light({1, 5, 6}, {0, -12, 3}, 20, 2000)},
                   0.084,
                   1.4,
                   0.0015,
                   0.005});
    shared::Light behind = aimed_light({0, -16, 5}, {0, 4, 2.5f}, 30, 8000);
    all.push_back({"camera inside the cone", house, {behind}, 0.013, 0.022, 0.0016, 0.0035});
    all.push_back({"away from the camera",
                   house,
                   {aimed_light({2, -9, 5}, {-1, 6, 2}, 25, 8000)},
                   0.0055,
                   0.037,
                   0.0016,
                   0.004});
    all.push_back({"from below",
                   wall({2, -6, 1.5f}, {0, 4, 3.5f}, 50),
                   {aimed_light({0, 3, 0}, {1, 3, 9}, 18, 8000, false)},
                   0.0018,
                   0.019,
                   0.04,
                   0.65});
    all.push_back({"onto a near wall",
                   wall({-3, -2, 2}, {0, 6, 2}, 60),
                   {aimed_light({2, 0, 5}, {-1, 6, 1}, 12, 8000)},
                   0.0017,
                   0.16,
                   0.016,
                   0.37});
    all.push_back({"blades across",
                   house,
                   {shaped_light({-4, 2, 6}, {4, 2, 0.5f}, 30, false)},
                   0.0016,
                   0.016,
                   0.0058,
                   0.41});
    all.push_back({"blades and gobo across",
                   house,
                   {shaped_light({-4, 2, 6}, {4, 2, 0.5f}, 30, true)},
                   0.0053,
                   0.19,
                   0.011,
                   0.48});
    all.push_back({"blades into the camera",
                   house,
                   {shaped_light({1, 5, 6}, {0.5f, -12, 2}, 24, false)},
                   0.0025,
                   0.074,
                   0.0017,
                   0.005});
    all.push_back({"panel from the house", house, {panel_light()}, 0.0044, 0.03, 0.0016, 0.004});
    all.push_back({"panel from the wings",
                   wall({-6, 5.5f, 3}, {0, 5.45f, 3}, 40),
                   {panel_light()},
                   0.09,
                   0.43,
                   0.0016,
                   0.004});
    shared::Light film = aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 30, 8000);
    put_slide(film);
    all.push_back({"film across", house, {film}, 0.0022, 0.068, 0.013, 0.39});
    shared::Light towards = aimed_light({1, 5, 6}, {0.5f, -12, 2}, 24, 8000);
    put_slide(towards);
    all.push_back({"film into the camera", house, {towards}, 0.013, 0.29, 0.0036, 0.019});
    return all;
}

// Curves that a laser sweeps; too thin for integrators that take samples.
std::vector<View> swept_views() {
    std::vector<View> all;
    const scene::Passes house = wall_passes(camera_at({0, -12, 3}, {0, 4, 3}, 26, 60, 36), 6.0f);
    for (const auto& [name, kind] : {std::pair{"line", shared::kLineFigure},
                                     {"circle", shared::kCircleFigure},
                                     {"wave", shared::kWaveFigure}}) {
        shared::Light across = aimed_light({-4, 2, 6}, {4, 2, 0.5f}, 30, 8000);
        put_figure(across, kind, 2.5f);
        all.push_back({name, house, {across}, 0, 0, 0, 0});
        shared::Light towards = aimed_light({1, 5, 4}, {0.5f, -12, 2}, 24, 8000);
        put_figure(towards, kind, 2.5f);
        all.push_back({name, house, {towards}, 0, 0, 0, 0});
    }
    return all;
}

// Of views(), made once for all tests.
const image::ImageF& kept_reference_of(const View& view) {
    static std::map<std::string, image::ImageF> kept;
    const auto [at, is_new] = kept.try_emplace(view.name);
    if (is_new) at->second = reference_of(view.passes, view.lights);
    return at->second;
}

TEST_F(Haze, ConeAndMarchAgreeWithTheReference) {
    for (const View& view : views()) {
        SCOPED_TRACE(view.name);
        const image::ImageF& reference = kept_reference_of(view);
        const Difference cone = compare(drawn(view.passes, view.lights, Beams::cone, 0), reference);
        const Difference march = compare(drawn(view.passes, view.lights, Beams::march, 110), reference);
        const Difference fine = compare(drawn(view.passes, view.lights, Beams::march, 4096), reference);
        std::printf(
            "%-22s cone: bias %6.2f %%, rms %5.1f %%;  march 110: bias %6.2f %%, rms %5.1f %%;  march 4096: "
            "bias %6.3f %%, rms %5.2f %% of the mean\n",
            view.name, 100 * cone.mean_bias, 100 * cone.rms, 100 * march.mean_bias, 100 * march.rms,
            100 * fine.mean_bias, 100 * fine.rms);
        EXPECT_LT(std::abs(cone.mean_bias), view.cone_bias);
        EXPECT_LT(cone.rms, view.cone_rms);
        EXPECT_LT(std::abs(march.mean_bias), view.march_bias);
        EXPECT_LT(march.rms, view.march_rms);
        const bool gobo = view.lights[0].wheel_count > 0, film = view.lights[0].slide.layer > 0;
        // With as many steps as the reference, nothing but rounding is left, and the levels of pictures.
        EXPECT_LT(std::abs(fine.mean_bias), gobo || film ? 0.003 : 0.0003);
        EXPECT_LT(fine.rms, gobo ? 0.11 : film ? 0.006 : 0.003);
    }
}

// Without this the limits of the views might let faults pass.
TEST_F(Haze, ALightThatIsDimmerOrAimsElsewhereIsSeen) {
    for (const View& view : views()) {
        SCOPED_TRACE(view.name);
        const image::ImageF& reference = kept_reference_of(view);
        const auto is_seen = [&](const shared::Light& light) {
            const Difference cone = compare(drawn(view.passes, {light}, Beams::cone, 0), reference);
            const Difference march = compare(drawn(view.passes, {light}, Beams::march, 110), reference);
            return std::abs(cone.mean_bias) > view.cone_bias || cone.rms > view.cone_rms ||
                   std::abs(march.mean_bias) > view.march_bias || march.rms > view.march_rms;
        };
        shared::Light dimmer = view.lights[0];
        dimmer.intensity_cd *= 0.97f;
        EXPECT_TRUE(is_seen(dimmer));
        shared::Light elsewhere = view.lights[0];
        const float turn = glm::radians(1.0f);
        const vec3 u = elsewhere.axis_u, w = elsewhere.axis_w;
        elsewhere.axis_w = w * std::cos(turn) + u * std::sin(turn);
        elsewhere.axis_u = u * std::cos(turn) - w * std::sin(turn);
        EXPECT_TRUE(is_seen(elsewhere));
    }
}

TEST_F(Haze, GateAgreesWithTheReference) {
    std::vector<View> all = views();
    for (View& view : swept_views()) all.push_back(std::move(view));
    for (const View& view : all) {
        SCOPED_TRACE(view.name);
        const image::ImageF reference = rays_of(view.passes, view.lights, 0.5f);
        const image::ImageF gate = drawn(view.passes, view.lights, Beams::gate, 0);
        const Difference difference = compare(gate, reference);
        const double psnr_db = likeness(gate, reference).psnr_db;
        std::printf("%-22s gate: bias %6.3f %%, rms %5.2f %% of the mean, tone-mapped PSNR %.1f dB\n",
                    view.name, 100 * difference.mean_bias, 100 * difference.rms, psnr_db);
        // Several pictures blurred each by itself: see docs/design/optics.md.
        const bool mixed = view.lights[0].shaped != 0 && view.lights[0].wheel_count > 0;
        // A thin curve is a small part of what 16 bits of a sum can tell.
        const bool swept = view.lights[0].figure.kind != shared::kNoFigure;
        // A film seen through its lens, blurred by that lens: 44.9 dB.
        const bool film = view.lights[0].slide.layer != 0;
        // Along a panel, 1.5 %.
        const bool panel = view.lights[0].panel_m > 0;
        EXPECT_LT(std::abs(difference.mean_bias), panel           ? 0.02
                                                  : mixed         ? 0.01
                                                  : swept || film ? 0.005
                                                                  : 0.003);
        EXPECT_GE(psnr_db, film ? 44.5 : 45.0);
    }
}

TEST_F(Haze, ExtinctionAloneScattersNothing) {
    const View view = views()[0];
    Settings settings;
    settings.haze = kHaze;
    settings.haze.scattering_per_m = 0;
    Relighter relighter(device(), view.passes, test_gobos(), 1, settings);
    relighter.draw(view.lights);
    for (const float value : relighter.frame().samples) ASSERT_EQ(value, 0.0f);
}

// A beam that is thinner than a pixel is a line, not dots: every column has the light that it has in a
// picture 16 times as fine.
TEST_F(Haze, AThinBeamIsALine) {
    constexpr int kFiner = 16, kWidth = 48, kHeight = 27, kFirst = 12,
                  kLast = 44; // after the lamp, before the floor
    for (const float field_deg : {0.05f, 0.3f}) {
        std::vector<shared::Light> light{aimed_light({-4, 2, 6}, {4, 2, 0.5f}, field_deg, 8000)};
        light[0].lens_radius_m = 0;
        const auto columns = [&](int finer) {
            const scene::Passes passes =
                wall_passes(camera_at({0, -12, 3}, {0, 4, 3}, 26, kWidth * finer, kHeight * finer), 6.0f);
            const image::ImageF picture = drawn(passes, light, Beams::gate, 0);
            std::vector<double> sums(kWidth);
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x)
                    sums[static_cast<std::size_t>(x / finer)] +=
                        static_cast<double>(picture.at(x, y)[1]) / (finer * finer);
            return sums;
        };
        const std::vector<double> coarse = columns(1), fine = columns(kFiner);
        double worst = 0;
        for (std::size_t x = kFirst; x <= kLast; ++x)
            worst = std::max(worst, std::abs(coarse[x] / std::max(fine[x], 1e-9) - 1));
        std::printf("%.2f degrees: columns differ by up to %.1f %%\n", static_cast<double>(field_deg),
                    100 * worst);
        EXPECT_GT(fine[kWidth / 2], 0.0);
        EXPECT_LT(worst, 0.12); // 0.08 measured
    }
}

// Rays right before a wall that stands across the beam: what the air shows there, row by row, is the beam
// that the wall shows.
TEST_F(Haze, AirAndSurfaceAgreeAtTheWall) {
    for (const bool gobo : {false, true}) {
        const shared::Light light = shaped_light({0, 0, 3}, {0, 8, 3}, 24, gobo);
        const scene::Passes passes = wall_passes(camera_at({-6, 7.95f, 3}, {0, 7.95f, 3}, 34, 8, 96), 7.95f);
        const image::ImageF air = drawn(passes, {light}, Beams::gate, 0),
                            wall = rays_of(passes, {light}, 0.5f);
        double air_all = 0, wall_all = 0, apart = 0;
        for (int y = 0; y < 96; ++y) {
            double air_row = 0, wall_row = 0;
            for (int x = 3; x < 5; ++x) {
                air_row += static_cast<double>(air.at(x, y)[1]);
                wall_row += static_cast<double>(wall.at(x, y)[1]);
            }
            air_all += air_row;
            wall_all += wall_row;
            apart += std::abs(air_row - wall_row);
        }
        std::printf("air before the wall%s: %.2f %% of the wall's light, rows %.2f %% apart\n",
                    gobo ? ", gobo" : "", 100 * air_all / wall_all, 100 * apart / wall_all);
        EXPECT_NEAR(air_all / wall_all, 1.0, 0.01);
        EXPECT_LT(apart / wall_all, gobo ? 0.1 : 0.01);
    }
}

// The same for curves of a laser: half a degree thick.
TEST_F(Haze, AirAndSurfaceAgreeWhereALaserIsSwept) {
    for (const std::uint32_t kind : {shared::kLineFigure, shared::kCircleFigure, shared::kWaveFigure}) {
        shared::Light light = aimed_light({0, 0, 3}, {0, 8, 3}, 30, 8000);
        put_figure(light, kind, 0.5f);
        const scene::Passes passes = wall_passes(camera_at({-9, 7.95f, 3}, {0, 7.95f, 3}, 70, 4, 192), 7.95f);
        const image::ImageF air = drawn(passes, {light}, Beams::gate, 0),
                            wall = rays_of(passes, {light}, 0.5f);
        double air_all = 0, wall_all = 0;
        for (int y = 0; y < 192; ++y)
            for (int x = 1; x < 3; ++x) {
                air_all += static_cast<double>(air.at(x, y)[1]);
                wall_all += static_cast<double>(wall.at(x, y)[1]);
            }
        std::printf("air before the wall, figure %u: %.2f %% of the wall's light\n", kind,
                    100 * air_all / wall_all);
        EXPECT_NEAR(air_all / wall_all, 1.0, 0.01);
    }
}

// What culling leaves out must be dark: every light alone, with the picture larger than one tile.
TEST_F(Haze, EveryViewIsSeenWholeAtAnySize) {
    const shared::Light light = aimed_light({-3, 3, 6}, {3, 2, 0}, 35, 8000, false);
    for (const auto& [width, height] : {std::pair{37, 23}, {16, 8}, {130, 9}, {15, 60}}) {
        const scene::Passes passes = wall_passes(camera_at({0, -10, 3}, {0, 4, 3}, 40, width, height), 6.0f);
        const Difference difference =
            compare(drawn(passes, {light}, Beams::cone, 0), reference_of(passes, {light}));
        EXPECT_LT(std::abs(difference.mean_bias), 0.006) << width << "x" << height;
        EXPECT_LT(difference.worst, 0.05) << width << "x" << height;
    }
}

} // namespace
} // namespace ghost::render
