// SPDX-License-Identifier: Apache-2.0
// The steps of render/pixels against the shaders of the same names: equal pictures, by less work of the
// device.
#include "bounce/bounce_volumes.h"
#include "passes/distance_maps.h"
#include "render/haze/distance_images.h"
#include "render/pixels/processor.h"
#include "render/relight/relighter.h"
#include "shared/octahedral.h"
#include "support/g_buffer_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/packing.hpp>
#include <memory>
#include <random>

namespace ghost::render {
namespace {

using OnProcessor = RelightTest;

struct Drawn {
    image::ImageF frame;
    image::Image8 picture;
    float ev100 = 0;
    std::uint64_t dispatches = 0;
};

// Twice: the lights as they are, then the first ones dimmer, from kept images with weights.
Drawn drawn_by(Relighter& relighter, std::vector<shared::Light> lights) {
    relighter.draw(lights);
    for (std::size_t k = 0; k < lights.size() / 2; ++k) lights[k].intensity_cd *= glm::vec3(0.3f, 0.5f, 0.1f);
    const std::uint64_t before = device().work().dispatches;
    relighter.draw(lights);
    Drawn drawn;
    drawn.dispatches = device().work().dispatches - before;
    drawn.frame = relighter.frame();
    drawn.picture = relighter.picture();
    drawn.ev100 = relighter.ev100_used();
    return drawn;
}

void expect_equal(const Drawn& shaders, const Drawn& processor) {
    ASSERT_EQ(shaders.frame.samples.size(), processor.frame.samples.size());
    EXPECT_LT(processor.dispatches, shaders.dispatches);
    EXPECT_NEAR(shaders.ev100, processor.ev100, 1e-3f);
    float brightest = 0;
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < shaders.frame.samples.size(); ++k) {
        const float a = shaders.frame.samples[k], b = processor.frame.samples[k];
        brightest = std::max(brightest, a);
        // A half float has eleven binary digits, and each of the sums before it was rounded.
        if (!(std::abs(a - b) <= 0.002f * std::abs(a) + 1e-5f)) ++wrong;
    }
    EXPECT_GT(brightest, 0.5f);
    EXPECT_EQ(wrong, 0u) << "of " << shaders.frame.samples.size();
    int worst = 0;
    for (std::size_t k = 0; k < shaders.picture.samples.size(); ++k)
        worst = std::max(worst, std::abs(static_cast<int>(shaders.picture.samples[k]) -
                                         static_cast<int>(processor.picture.samples[k])));
    EXPECT_LE(worst, 1) << "of 255";
}

float mean_of(const image::ImageF& picture) {
    double sum = 0;
    for (const float sample : picture.samples) sum += static_cast<double>(sample);
    return static_cast<float>(sum / static_cast<double>(picture.samples.size()));
}

Settings foggy() {
    Settings settings;
    settings.haze = {0.03f, 0.03f, 0.77f, -0.6f, 0.035f};
    settings.ambient = glm::vec3(5.0f);
    settings.ev100 = 5;
    return settings;
}

Settings surfaces_only(bool processor) {
    Settings settings = foggy();
    settings.air = false;
    settings.ambient = glm::vec3(0.0f);
    settings.pixels_on_processor = processor;
    return settings;
}

void expect_alike(std::size_t kind, const shared::Light& light, const image::ImageF& shader,
                  const image::ImageF& processor) {
    SCOPED_TRACE("kind " + std::to_string(kind));
    const Difference difference = compare(processor, shader);
    const float brightest = *std::max_element(shader.samples.begin(), shader.samples.end());
    std::printf("beam kind %zu: brightest %.3f, bias %.4f %%, worst %.4f %%, rms %.4f %% of the mean\n", kind,
                brightest, 100 * difference.mean_bias, 100 * difference.worst, 100 * difference.rms);
    EXPECT_GT(brightest, 0.1f);
    // The device decodes sRGB a bit darker than the formula.
    EXPECT_LT(difference.worst, light.slide.layer > 0 ? 0.01 : 0.002);
    EXPECT_LT(std::abs(difference.mean_bias), light.slide.layer > 0 ? 0.005 : 0.0005);
}

// Everything that a gate can hold, a light each.
std::vector<shared::Light> beams_of_every_kind(const glm::vec3& at, const glm::vec3& to) {
    std::vector<shared::Light> kinds(13, aimed_light(at, to, 24, 5000));
    kinds[1] = aimed_light(at, to, 30, 5000, false);
    put_gobo(kinds[2], 1, 30);
    put_gobo(kinds[3], 2, 0);
    put_gobo(kinds[3], 3, 77);
    kinds[3].focus_per_m = 0.5f; // far out of focus
    put_gobo(kinds[4], 1, 10, 0.37f, 2);
    kinds[4].disc = {2, 0.8f, 0.6f, {0.5f, 0.1f}, 0.4f, 0.03f};
    kinds[5].split = -0.2f;
    kinds[5].colour_b = {0.2f, 1.5f, 0.1f};
    kinds[5].panel_m = 0.4f;
    kinds[6].iris_radius = 0.5f;
    kinds[6].rim_fraction = 0.7f;
    kinds[6].shaped = 2;
    for (std::size_t k = 0; k < 4; ++k)
        kinds[6].blade[k] = {
            {k == 0 ? 1.0f : (k == 2 ? -1.0f : 0.0f), k == 1 ? 1.0f : (k == 3 ? -1.0f : 0.0f)},
            0.3f + 0.1f * static_cast<float>(k),
            0.02f * static_cast<float>(k)};
    scene::Projector projector;
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
    return kinds;
}

TEST_F(OnProcessor, PicturesFromPasses) {
    if (!has_vectors()) GTEST_SKIP() << "this processor has no AVX2, FMA and F16C";
    std::mt19937 random(7);
    for (const auto& [width, height] : {std::pair{61, 35}, {64, 32}, {1, 9}, {130, 3}}) {
        scene::Passes passes = edgy_passes(random, width, height);
        const std::vector<shared::Light> lights = random_rig(random, passes, 6);
        for (const Beams beams : {Beams::gate, Beams::cone})
            for (const float strength : {0.0f, 0.3f})
                for (const auto& [automatic, tone] : {std::pair{false, image::Tone::agx},
                                                      {true, image::Tone::aces},
                                                      {false, image::Tone::linear}}) {
                    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + ", " +
                                 (beams == Beams::gate ? "gate" : "cone") + ", glare " +
                                 std::to_string(strength) + ", tone " +
                                 std::to_string(static_cast<int>(tone)));
                    std::array<Drawn, 2> both;
                    for (const bool processor : {false, true}) {
                        Settings settings = foggy();
                        settings.beams.beams = beams;
                        settings.glare.strength = strength;
                        settings.auto_exposure = automatic;
                        settings.tone = tone;
                        settings.lens.on = strength > 0;
                        settings.pixels_on_processor = processor;
                        Relighter relighter(device(), passes, test_gobos(), 6, settings);
                        both[processor ? 1 : 0] = drawn_by(relighter, lights);
                    }
                    expect_equal(both[0], both[1]);
                }
    }
}

// At places that are no multiples of eight pixels.
TEST_F(OnProcessor, SurfacesOfEveryBeam) {
    if (!has_vectors()) GTEST_SKIP() << "this processor has no AVX2, FMA and F16C";
    const glm::vec3 at(-1, -3, 6);
    std::mt19937 random(3);
    scene::Passes passes = edgy_passes(random, 75, 41);
    add_pass(passes, at, [](const glm::vec3&) { return glm::vec3(1.0f, 0.5f, 0.2f); });
    const std::vector<shared::Light> kinds = beams_of_every_kind(at, {0.2f, 4, 2.6f});
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        std::array<image::ImageF, 2> both;
        for (const bool processor : {false, true}) {
            Relighter relighter(device(), passes, test_gobos(), 1, surfaces_only(processor));
            const FrameStatistics drawn = relighter.draw({kinds[kind]});
            EXPECT_GT(drawn.surface_tiles, 10);
            both[processor ? 1 : 0] = relighter.frame();
        }
        expect_alike(kind, kinds[kind], both[0], both[1]);
    }
}

// Half of what a lamp shines at is in a shadow, whose edge is soft; what is seen of the lamp is kept after a
// few frames.
TEST_F(OnProcessor, SurfacesOfAFreeCamera) {
    if (!has_vectors()) GTEST_SKIP() << "this processor has no AVX2, FMA and F16C";
    const glm::vec3 at(-1, -3, 6), to(0.2f, 4, 2.6f);
    scene::DistanceMaps maps;
    maps.size = 256;
    maps.maps.resize(1);
    maps.maps[0].position_m = at;
    for (int y = 0; y < maps.size; ++y)
        for (int x = 0; x < maps.size; ++x) {
            const glm::vec2 place = (glm::vec2(x, y) + 0.5f) / static_cast<float>(maps.size);
            const bool before =
                dot(shared::direction_from_octahedral(place), glm::normalize(to - at)) > 0.7f && x % 16 < 8;
            maps.maps[0].distance.push_back(before ? glm::packHalf1x16(2.0f) : scene::kNoSurface);
        }
    scene::measure(maps.maps[0]);
    const DistanceImages distances(device(), maps);
    Report report;
    const StageModel model(device(), room_with_boards(), report);
    GBuffer buffer(device(), 189, 97);
    buffer.draw(model, pose_of(camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, 189, 97)),
                {glm::vec3(0.0f), foggy().haze});
    std::vector<shared::Light> kinds = beams_of_every_kind(at, to);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        kinds[kind].map = 1;
        kinds[kind].disc_radius_m = 0.07f;
        std::array<image::ImageF, 2> both;
        for (const bool processor : {false, true}) {
            Relighter relighter(device(), buffer, &distances, test_gobos(), 1, surfaces_only(processor));
            FrameStatistics drawn;
            for (int frame = 3; frame >= 0; --frame) { // turns
                shared::Light light = kinds[kind];
                const float turn = 0.02f * static_cast<float>(frame);
                light.axis_u = std::cos(turn) * kinds[kind].axis_u + std::sin(turn) * kinds[kind].axis_w;
                light.axis_w = std::cos(turn) * kinds[kind].axis_w - std::sin(turn) * kinds[kind].axis_u;
                drawn = relighter.draw({light});
            }
            EXPECT_GT(drawn.surface_tiles, 10);
            EXPECT_LT(drawn.direct_units, drawn.surface_tiles / 2);
            both[processor ? 1 : 0] = relighter.frame();
        }
        expect_alike(kind, kinds[kind], both[0], both[1]);
    }
}

// Here and there nothing is known, on surfaces or in the air either; boxes end within the room.
scene::BounceVolumes uneven_volumes(std::mt19937& random) {
    scene::BounceVolumes volumes;
    volumes.low_m = {-5.3f, -3.2f, -0.4f};
    volumes.surfel_m = 0.9f;
    volumes.cell_m = 1.7f;
    const auto fill = [&](scene::BounceVolume& volume, const glm::ivec3& size, int sides, float known) {
        volume.size = size;
        std::uniform_real_distribution<float> light(0.0f, 300.0f), share(0.0f, 1.0f);
        for (int k = 0; k < size.x * size.y * size.z * sides; ++k)
            volume.texels.push_back(
                share(random) < known
                    ? glm::packHalf4x16(glm::vec4(light(random), light(random), light(random), 1))
                    : 0);
    };
    fill(volumes.surfaces, {13, 15, 9}, 6, 0.5f);
    fill(volumes.air, {7, 8, 5}, 6, 0.8f);
    fill(volumes.glow, {7, 8, 5}, 1, 0.8f);
    return volumes;
}

TEST_F(OnProcessor, LightOfARoom) {
    if (!has_vectors()) GTEST_SKIP() << "this processor has no AVX2, FMA and F16C";
    Report report;
    const StageModel model(device(), room_with_boards(), report);
    std::mt19937 random(11);
    const auto volumes = std::make_shared<const scene::BounceVolumes>(uneven_volumes(random));
    const std::vector<shared::Light> lights{aimed_light({-4, 0, 8}, {-1, 2, 0}, 20, 200),
                                            aimed_light({4, 2, 8}, {1, 3, 1}, 35, 200)};
    for (const glm::ivec2 size : {glm::ivec2(192, 96), glm::ivec2(189, 97), glm::ivec2(3, 2)}) {
        GBuffer buffer(device(), size.x, size.y);
        const Settings base = foggy();
        buffer.draw(model, pose_of(camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, size.x, size.y)),
                    {base.ambient, base.haze});
        EXPECT_GT(buffer.fragments().edge_count, size.y > 90 ? 100u : 0u);
        for (const bool lux : {false, true}) {
            SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y) + (lux ? ", lux" : ""));
            std::array<Drawn, 2> both;
            for (const bool processor : {false, true}) {
                Settings settings = foggy();
                settings.glare.strength = 0;
                settings.illuminance = lux;
                settings.pixels_on_processor = processor;
                Relighter relighter(device(), buffer, nullptr, test_gobos(), 2, settings);
                relighter.draw(lights);
                const float without = mean_of(relighter.frame());
                relighter.set_room_light(volumes);
                both[processor ? 1 : 0] = drawn_by(relighter, lights);
                EXPECT_GT(mean_of(both[processor ? 1 : 0].frame), 1.2f * without);
            }
            expect_equal(both[0], both[1]);
        }
    }
}

TEST_F(OnProcessor, PicturesOfAFreeCamera) {
    if (!has_vectors()) GTEST_SKIP() << "this processor has no AVX2, FMA and F16C";
    Report report;
    const scene::Stage stage = room_with_boards();
    const StageModel model(device(), stage, report);
    const std::vector<shared::Light> lights{aimed_light({-4, 0, 8}, {-1, 2, 0}, 20, 20000),
                                            aimed_light({4, 2, 8}, {1, 3, 1}, 35, 20000)};
    for (const glm::ivec2 size :
         {glm::ivec2(192, 96), glm::ivec2(191, 95), glm::ivec2(190, 97), glm::ivec2(33, 2)}) {
        GBuffer buffer(device(), size.x, size.y);
        const Settings base = foggy();
        buffer.draw(model, pose_of(camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, size.x, size.y)),
                    {base.ambient, base.haze});
        for (const bool coarse : {false, true}) {
            SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y) + (coarse ? ", coarse" : ""));
            std::array<Drawn, 2> both;
            for (const bool processor : {false, true}) {
                Settings settings = foggy();
                settings.glare.strength = 0.05f;
                settings.coarse = coarse;
                settings.pixels_on_processor = processor;
                Relighter relighter(device(), buffer, nullptr, test_gobos(), 2, settings);
                both[processor ? 1 : 0] = drawn_by(relighter, lights);
            }
            EXPECT_GT(buffer.fragments().edge_count, size.y > 90 ? 100u : 0u);
            expect_equal(both[0], both[1]);
        }
    }
}

} // namespace
} // namespace ghost::render
