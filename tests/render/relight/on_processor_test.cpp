// SPDX-License-Identifier: Apache-2.0
// The steps of render/pixels against the shaders of the same names: equal pictures, by less work of the
// device.
#include "render/pixels/processor.h"
#include "render/relight/relighter.h"
#include "support/g_buffer_picture.h"

#include <cmath>
#include <cstdlib>
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

Settings foggy() {
    Settings settings;
    settings.haze = {0.03f, 0.03f, 0.77f, -0.6f, 0.035f};
    settings.ambient = glm::vec3(5.0f);
    settings.ev100 = 5;
    return settings;
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
