// SPDX-License-Identifier: Apache-2.0
// Surfaces and the sum of lights on the GPU, against formulas and against relighting on the CPU.
#include "passes/relight_cpu.h"
#include "shared/beam.h"
#include "shared/develop.h"
#include "support/test_view.h"

#include <array>
#include <cstdio>
#include <cstring>

namespace ghost::render {
namespace {

using glm::vec3;

using Surfaces = RelightTest;
using Frames = RelightTest;

image::ImageF drawn(const scene::Passes& passes, const std::vector<shared::Light>& lights,
                    const Settings& settings) {
    Relighter relighter(device(), passes, test_gobos(), static_cast<int>(lights.size()), settings);
    relighter.draw(lights);
    return relighter.frame();
}

// A pass of radiance 1: the picture is the beam itself.
TEST_F(Surfaces, BeamOnTheGpuIsTheBeamInCpp) {
    scene::Passes passes = white_wall(160, 90);
    const vec3 at(-1, -3, 6);
    add_pass(passes, at, [](const vec3&) { return vec3(1.0f); });
    std::vector<shared::Light> kinds(13, aimed_light(at, {0.2f, 4, 2.6f}, 24, 5000));
    kinds[1] = aimed_light(at, {0.2f, 4, 2.6f}, 30, 5000, false);
    put_gobo(kinds[2], 1, 30);
    put_gobo(kinds[3], 2, 0);
    put_gobo(kinds[3], 3, 77);
    kinds[3].focus_per_m = 0.5f; // far out of focus
    put_gobo(kinds[4], 1, 10, 0.37f, 2);
    kinds[5].split = -0.2f;
    kinds[5].colour_b = {0.2f, 1.5f, 0.1f};
    kinds[6].iris_radius = 0.35f;
    put_gobo(kinds[6], 3, 200);
    scene::Projector
        projector; // 7: sharp, 8: far out of focus, 9: all that a projector has, and an iris and a gobo
    put_slide(kinds[7], projector);
    put_slide(kinds[8], projector);
    kinds[8].focus_per_m = 0.5f;
    projector.lens_shift = {0.1f, -0.2f};
    projector.keystone_deg = {10, -15};
    projector.contrast = 50;
    projector.blend = {0.1f, 0, 0.2f, 0.3f};
    put_slide(kinds[9], projector);
    put_gobo(kinds[9], 1, 30);
    kinds[9].iris_radius = 0.6f;
    kinds[9].iris_depth = 0.05f;
    kinds[9].shaped = 2;
    for (shared::Blade& blade : kinds[9].blade) blade.offset = 8;
    for (std::uint32_t figure = shared::kLineFigure; figure <= shared::kWaveFigure; ++figure)
        put_figure(kinds[9 + figure], figure, 1.0f);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        SCOPED_TRACE("kind " + std::to_string(kind));
        const image::ImageF picture = drawn(passes, {kinds[kind]}, clear_air());
        image::ImageF reference(passes.width, passes.height, 3);
        for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
            const vec3 q = shared::to_gate(kinds[kind], vec3(passes.fragments[p]) - at);
            const vec3 value = shared::beam_candela(kinds[kind], q, test_gobos());
            for (int c = 0; c < 3; ++c) reference.samples[3 * p + static_cast<std::size_t>(c)] = value[c];
        }
        const Difference difference = compare(picture, reference);
        std::printf("beam kind %zu: bias %.4f %%, worst %.3f %% of the peak\n", kind,
                    100 * difference.mean_bias, 100 * difference.worst);
        // Texture units have 8 bits for the place between two texels.
        EXPECT_LT(difference.worst,
                  kinds[kind].wheel_count > 0 || kinds[kind].slide.layer > 0 ? 0.015 : 0.002);
        // The device decodes sRGB a bit darker than the formula.
        EXPECT_LT(std::abs(difference.mean_bias), kinds[kind].slide.layer > 0 ? 0.002 : 0.001);
    }
}

TEST_F(Surfaces, IrradianceOnAWhiteWall) {
    scene::Passes passes = white_wall(96, 54);
    const vec3 at(1, -2, 5);
    const float albedo = 0.8f;
    const auto lambert = [&](const vec3& x) {
        const vec3 way = x - at;
        const float distance = glm::length(way);
        return vec3(albedo / shared::kPi * (way.y / distance) / (distance * distance));
    };
    add_pass(passes, at, lambert);
    shared::Light light = aimed_light(at, {0, 4, 2.5f}, 60, 4000, false);
    light.profile_scale = 1e-6f; // even light over the whole cone
    light.cut_radius = 4;
    light.iris_radius = 4;
    const image::ImageF picture = drawn(passes, {light}, clear_air());
    double worst = 0;
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        const glm::dvec3 way = glm::dvec3(passes.fragments[p]) - glm::dvec3(at);
        const double d2 = glm::dot(way, way);
        const double expected =
            4000.0 * (way.y / std::sqrt(d2)) / d2 * static_cast<double>(albedo) / 3.14159265358979;
        worst = std::max(worst, std::abs(picture.samples[3 * p + 1] / expected - 1.0));
    }
    std::printf("I cos / d^2 albedo / pi: worst error %.3f %%\n", 100 * worst);
    EXPECT_LT(worst, 0.005);
}

TEST_F(Surfaces, ExtinctionCountsTheWholeWay) {
    scene::Passes passes = white_wall(32, 20);
    const vec3 at(0, -2, 5);
    add_pass(passes, at, [](const vec3&) { return vec3(0.01f); });
    const shared::Light light = aimed_light(at, {0, 4, 2.5f}, 60, 3000, false);
    Settings settings = clear_air();
    const image::ImageF clear = drawn(passes, {light}, settings);
    settings.haze.extinction_per_m = 0.1f;
    const image::ImageF hazy = drawn(passes, {light}, settings);
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        const vec3 x(passes.fragments[p]);
        const float lens_fraction = light.lens_m / shared::to_gate(light, x - at).z;
        const float way = glm::length(x - at) * (1.0f - lens_fraction) + glm::length(x - eye_of(passes));
        ASSERT_NEAR(hazy.samples[3 * p], clear.samples[3 * p] * std::exp(-0.1f * way),
                    2e-3f * hazy.samples[3 * p] + 1e-4f);
    }
}

TEST_F(Surfaces, AmbientAndEmissionWithoutAnyLight) {
    scene::Passes passes = white_wall(20, 12);
    passes.ambient.assign(passes.pixel_count(), glm::vec4(0.1f, 0.2f, 0.3f, 0));
    passes.emission.assign(passes.pixel_count(), glm::vec4(5, 0, 1, 0));
    passes.fragments[7].w = -1; // no surface: nothing is added for the way there but what the pass says
    Settings settings;
    settings.ambient = glm::vec3(10);
    settings.haze = {0.05f, 0.05f, 0.7f, -0.6f, 0.03f};
    const image::ImageF picture = drawn(passes, {}, settings);
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        if (p == 7) continue;
        const float seen = std::exp(-0.05f * glm::length(vec3(passes.fragments[p]) - eye_of(passes)));
        EXPECT_NEAR(picture.samples[3 * p], (1.0f + 5.0f) * seen, 6.0f * 1e-3f);
        EXPECT_NEAR(picture.samples[3 * p + 1], 2.0f * seen, 2.0f * 1e-3f);
        EXPECT_NEAR(picture.samples[3 * p + 2], (3.0f + 1.0f) * seen, 4.0f * 1e-3f);
    }
}

// Bounced light: the picture of the bounces times the lumens over 4 pi, cut by no cone, dimmed on the way to
// the camera.
TEST_F(Surfaces, BouncedLightFollowsTheLumens) {
    scene::Passes passes = white_wall(37, 23);
    passes.fragments[30].w = -1;
    const vec3 at(0, -2, 5);
    for (int k = 0; k < 3; ++k) add_pass(passes, at, [](const vec3&) { return vec3(0.0f); });
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) // pass 1 has none
        for (std::size_t p = 0; p < passes.pixel_count(); ++p)
            for (int c = 0; c < 4; ++c) {
                const float value =
                    p == 30 || c == 3 ? 0.0f : 0.001f * static_cast<float>((k + 1) * (p % 50));
                passes.lights[k].indirect.push_back(glm::packHalf1x16(value * scene::kRadianceScale));
            }
    std::vector<shared::Light> lights(4,
                                      aimed_light(at, at + vec3(0, -1, 0), 10, 3000)); // away from the wall
    for (std::size_t k = 0; k < lights.size(); ++k) {
        lights[k].pass = static_cast<std::uint32_t>(k); // the last one has no pass at all
        lights[k].bounce_cd = vec3(100, 200, 50) * static_cast<float>(k + 1);
    }
    put_gobo(lights[2], 1); // another class of shader
    Settings settings = clear_air();
    settings.haze.extinction_per_m = 0.05f;
    const image::ImageF picture = drawn(passes, lights, settings);
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        const float seen =
            p == 30 ? 0 : std::exp(-0.05f * glm::length(vec3(passes.fragments[p]) - eye_of(passes)));
        const float value = 0.001f * static_cast<float>(p % 50) * seen * 100.0f * (1 * 1 + 3 * 3);
        for (std::size_t c = 0; c < 3; ++c) {
            const float expected = value * std::array{1.0f, 2.0f, 0.5f}[c];
            ASSERT_NEAR(picture.samples[3 * p + c], expected, 0.003f * expected + 1e-4f) << p;
        }
    }
}

TEST_F(Surfaces, GpuAgreesWithCpu) {
    struct Row {
        int width;
        int height;
        int lights;
    };
    for (const Row row : {Row{37, 23, 5}, Row{64, 40, 12}, Row{16, 8, 3}, Row{17, 9, 30}, Row{100, 1, 4},
                          Row{1, 70, 4}, Row{33, 31, 300}, Row{40, 24, 700}}) {
        SCOPED_TRACE(std::to_string(row.width) + "x" + std::to_string(row.height) + ", " +
                     std::to_string(row.lights));
        std::mt19937 random(static_cast<unsigned>(row.width * 1000 + row.lights));
        scene::Passes passes = edgy_passes(random, row.width, row.height);
        const std::vector<shared::Light> lights = random_rig(random, passes, row.lights);
        Settings settings = clear_air();
        settings.haze = {0.03f, 0.03f, 0.7f, -0.6f, 0.03f};
        const image::ImageF reference = scene::relight_cpu(passes, lights, test_gobos(), settings.haze);
        // Both ways of drawing: light by light (lavapipe) and all lights of a tile in one loop (GPUs).
        for (const std::uint32_t per_dispatch : {1u, shared::kLightsPerChunk}) {
            settings.lights_per_dispatch = per_dispatch;
            const image::ImageF picture = drawn(passes, lights, settings);
            const Difference difference = compare(picture, reference);
            std::printf(
                "%3d x %2d, %3d lights, %3u a dispatch: bias %.4f %%, worst %.3f %% of the brightest\n",
                row.width, row.height, row.lights, per_dispatch, 100 * difference.mean_bias,
                100 * difference.worst);
            EXPECT_LT(difference.worst, 0.012);
            EXPECT_LT(std::abs(difference.mean_bias), 0.005);
            Settings few = settings;
            few.most_groups = 3;
            EXPECT_EQ(drawn(passes, lights, few).samples, picture.samples);
        }
    }
}

TEST_F(Frames, NothingChangedCostsNothing) {
    std::mt19937 random(5);
    scene::Passes passes = edgy_passes(random, 48, 20);
    std::vector<shared::Light> lights = random_rig(random, passes, 9);
    Relighter relighter(device(), passes, test_gobos(), 9, Settings{});
    EXPECT_EQ(relighter.draw(lights).drawn, 9);
    const std::vector<float> before = relighter.frame().samples;
    const image::Image8 picture = relighter.picture();
    for (int frame = 0; frame < 3; ++frame) {
        const FrameStatistics statistics = relighter.draw(lights);
        EXPECT_EQ(statistics.changed, 0);
        EXPECT_EQ(statistics.drawn, 0);
        EXPECT_EQ(statistics.additions, 0);
        EXPECT_TRUE(statistics.spans.empty()) << "nothing is submitted";
        EXPECT_EQ(relighter.frame().samples, before);
        EXPECT_EQ(relighter.picture().samples, picture.samples);
    }
    lights[4].intensity_cd *= 0.5f;
    for (int frame = 0; frame < 4; ++frame) {
        lights[4].tan_field *= 1.01f;
        const FrameStatistics statistics = relighter.draw(lights);
        EXPECT_EQ(statistics.changed, 1);
        EXPECT_LE(statistics.additions, 4);
        if (frame > 0) {
            EXPECT_EQ(statistics.drawn, 1);
        }
    }
}

// Dimmer and colour are weights of kept images: within what a half float holds the picture is that of drawing
// everything.
TEST_F(Frames, AFadeDrawsNoLight) {
    std::mt19937 random(6);
    scene::Passes passes = edgy_passes(random, 41, 22);
    std::vector<shared::Light> lights = random_rig(random, passes, 9);
    Relighter relighter(device(), passes, test_gobos(), 9, Settings{});
    Settings fresh_settings;
    fresh_settings.reuse = false;
    Relighter fresh(device(), passes, test_gobos(), 9, fresh_settings);
    (void)relighter.draw(lights);
    std::uniform_real_distribution<float> fraction(0.05f, 1.0f);
    const std::vector<shared::Light> full = lights;
    for (int frame = 0; frame < 12; ++frame) {
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const glm::vec3 by(fraction(random), fraction(random), fraction(random));
            lights[k].intensity_cd = by * full[k].intensity_cd;
            lights[k].bounce_cd = by * full[k].bounce_cd;
        }
        const FrameStatistics statistics = relighter.draw(lights);
        EXPECT_TRUE(frame == 0 || statistics.drawn == 0) << frame << ": " << statistics.drawn;
        (void)fresh.draw(lights);
        const std::vector<float> kept = relighter.frame().samples, drawn = fresh.frame().samples;
        const float brightest = *std::max_element(drawn.begin(), drawn.end());
        for (std::size_t i = 0; i < kept.size(); ++i)
            ASSERT_NEAR(kept[i], drawn[i], 0.002f * brightest) << "frame " << frame << ", sample " << i;
    }
}

// Kept images or none, any history: the picture of the lights as they are now.
TEST_F(Frames, HistoryDoesNotShow) {
    std::mt19937 random(9);
    scene::Passes passes = edgy_passes(random, 37, 23);
    std::vector<shared::Light> lights = random_rig(random, passes, 11);
    Settings settings;
    settings.haze = {0.02f, 0.02f, 0.77f, -0.6f, 0.03f};
    Settings little = settings;
    little.image_memory_bytes = 37 * 23 * 8 * 3; // three kept images
    Settings none = settings;
    none.reuse = false;
    Relighter kept(device(), passes, test_gobos(), 11, settings);
    Relighter squeezed(device(), passes, test_gobos(), 11, little);
    Relighter fresh(device(), passes, test_gobos(), 11, none);
    double worst = 0;
    for (int frame = 0; frame < 30; ++frame) {
        for (unsigned k = random() % 4; k > 0; --k) {
            shared::Light& light = lights[(static_cast<unsigned>(frame) / 5 + k) % 11];
            light.intensity_cd = vec3(static_cast<float>(random() % 3000));
        }
        kept.draw(lights);
        squeezed.draw(lights);
        EXPECT_EQ(fresh.draw(lights).drawn, 11);
        const image::ImageF expected = fresh.frame();
        for (Relighter* const other : {&kept, &squeezed}) {
            const Difference difference = compare(other->frame(), expected);
            EXPECT_LT(difference.worst, 0.005) << frame;
            EXPECT_LT(std::abs(difference.mean_bias), 0.001) << frame;
            worst = std::max(worst, difference.worst);
        }
    }
    std::printf("kept images against drawing everything: worst %.4f %% of the brightest\n", 100 * worst);
}

TEST_F(Frames, SameHistorySameBytes) {
    std::mt19937 random(3);
    scene::Passes passes = edgy_passes(random, 50, 30);
    std::vector<shared::Light> lights = random_rig(random, passes, 20);
    Settings settings;
    settings.haze = {0.02f, 0.02f, 0.77f, -0.6f, 0.03f};
    settings.auto_exposure = true;
    Relighter a(device(), passes, test_gobos(), 20, settings);
    Relighter b(device(), passes, test_gobos(), 20, settings);
    for (int frame = 0; frame < 10; ++frame) {
        lights[static_cast<std::size_t>(frame) % 5].intensity_cd *= 0.9f;
        a.draw(lights);
        b.draw(lights);
        const image::ImageF from_a = a.frame();
        const image::ImageF from_b = b.frame();
        ASSERT_EQ(
            std::memcmp(from_a.samples.data(), from_b.samples.data(), from_a.samples.size() * sizeof(float)),
            0);
        ASSERT_EQ(a.picture().samples, b.picture().samples);
        ASSERT_EQ(a.ev100_used(), b.ev100_used());
    }
}

TEST_F(Frames, OddLightsGiveNumbers) {
    scene::Passes passes = white_wall(37, 23);
    const vec3 eye = eye_of(passes);
    const vec3 on_wall(passes.fragments[400]);
    std::vector<shared::Light> lights(9, aimed_light(eye + vec3(0, 2, 2), {0, 4, 2}, 20, 3000));
    lights[0] = aimed_light({0, -3, 6}, {0, 4, 2}, 0.1f, 1e7f); // the narrowest that there is
    lights[1].intensity_cd = vec3(0);
    lights[2] = aimed_light(eye - vec3(0, 0.1f, 0), {0, 4, 2}, 30, 3000); // the eye is inside the lens
    lights[3] = aimed_light(eye, {0, 4, 2}, 30, 3000);                    // and in the apex
    lights[4] = aimed_light(on_wall, on_wall + vec3(0, -1, 0), 40, 3000); // at a surface
    lights[5] = aimed_light(on_wall + vec3(0, -0.01f, 0), on_wall, 170, 1e9f, false);
    lights[6].iris_radius = 0.02f;
    lights[7].focus_per_m = 10.0f;
    put_gobo(lights[7], 1);
    lights[8] = aimed_light(eye + vec3(0, 6, 0), eye, 5, 1e6f); // into the camera
    for (std::size_t k = 0; k < lights.size(); ++k) {
        lights[k].pass = add_pass(passes, lights[k].position_m, [](const vec3&) { return vec3(0.05f); });
        if (k % 3 == 0) lights[k].haze_samples = 0;
    }
    for (const Beams beams : {Beams::cone, Beams::march})
        for (const float extinction : {0.0f, 0.02f, 5.0f}) {
            Settings settings;
            settings.haze = {extinction, extinction, 0.77f, -0.6f, 0.03f};
            settings.beams.beams = beams;
            settings.auto_exposure = true;
            Relighter relighter(device(), passes, test_gobos(), static_cast<int>(lights.size()), settings);
            relighter.draw(lights);
            for (const float value : relighter.frame().samples)
                ASSERT_TRUE(std::isfinite(value) && value >= 0);
            EXPECT_TRUE(std::isfinite(relighter.ev100_used()));
        }
}

TEST_F(Frames, NoLightsIsTheBaseAndDark) {
    const scene::Passes passes = [] {
        scene::Passes made = white_wall(19, 11);
        made.ambient.assign(made.pixel_count(), glm::vec4(0));
        return made;
    }();
    Relighter relighter(device(), passes, test_gobos(), 0, Settings{});
    relighter.draw(std::vector<shared::Light>{});
    for (const float value : relighter.frame().samples) ASSERT_EQ(value, 0.0f);
    EXPECT_TRUE(relighter.draw(std::vector<shared::Light>{}).spans.empty());
}

// The display picture is the HDR frame through shared::develop, the exposure the camera's or the log average.
TEST_F(Frames, PictureIsTheDevelopedFrame) {
    std::mt19937 random(12);
    scene::Passes passes = edgy_passes(random, 61, 35);
    const std::vector<shared::Light> lights = random_rig(random, passes, 6);
    for (const auto& [automatic, tone] : {std::pair{false, image::Tone::agx},
                                          {true, image::Tone::agx},
                                          {false, image::Tone::aces},
                                          {false, image::Tone::linear}}) {
        Settings settings = clear_air();
        settings.ev100 = 4;
        settings.auto_exposure = automatic;
        Relighter relighter(device(), passes, test_gobos(), 6, settings);
        relighter.draw(lights);
        relighter.set_tone(tone); // what rests is developed anew
        relighter.draw(lights);
        const image::ImageF frame = relighter.frame();
        const image::Image8 picture = relighter.picture();
        ASSERT_EQ(picture.width, 61);
        ASSERT_EQ(picture.channels, 4);
        if (automatic) {
            double sum = 0;
            int count = 0;
            for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
                const float* t = frame.samples.data() + 3 * p;
                const float luminance = shared::luminance_of({t[0], t[1], t[2]});
                if (luminance <= shared::kMeterFloor) continue;
                sum += std::log2(static_cast<double>(luminance));
                ++count;
            }
            ASSERT_GT(count, 100);
            // It measures every fifth pixel.
            EXPECT_NEAR(relighter.ev100_used(), sum / count + 3.0 + static_cast<double>(shared::kAutoBias),
                        0.35);
        } else {
            EXPECT_EQ(relighter.ev100_used(), 4.0f);
        }
        const float exposure = shared::exposure_of(relighter.ev100_used());
        int worst = 0;
        for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
            const float* t = frame.samples.data() + 3 * p;
            const vec3 expected =
                shared::develop({t[0], t[1], t[2]}, exposure, static_cast<std::uint32_t>(tone)) * 255.0f;
            for (int c = 0; c < 3; ++c)
                worst = std::max(
                    worst, std::abs(static_cast<int>(picture.samples[4 * p + static_cast<std::size_t>(c)]) -
                                    static_cast<int>(std::lround(expected[c]))));
            ASSERT_EQ(picture.samples[4 * p + 3], 255);
        }
        EXPECT_LE(worst, 1) << "of 255";
    }
}

TEST(image_slots, FollowsTheBudget) {
    EXPECT_EQ(image_slots(0, 1024, 300, 10), 0);
    EXPECT_EQ(image_slots(std::uint64_t{1} << 30, 1024, 300, 10), 19); // a full tree
    EXPECT_EQ(image_slots(1024 * 300 * 8 * 5, 1024, 300, 10), 5);
    EXPECT_GT(image_slots(std::uint64_t{1} << 40, 16, 16, 100000), 1000); // bounded by the layers of an image
    EXPECT_LE(image_slots(std::uint64_t{1} << 40, 16, 16, 100000), 2047);
    EXPECT_EQ(image_slots(1, 8192, 8192, 0), 0);
    EXPECT_EQ(image_slots(std::uint64_t{1} << 30, 8192, 8192, 0), 1) << "a tree of no light has one place";
}

} // namespace
} // namespace ghost::render
