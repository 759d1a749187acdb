// SPDX-License-Identifier: Apache-2.0
// Light at half the size of the picture against light at all of it.
#include "render/relight/coarse_light.h"

#include "render/relight/relighter.h"
#include "support/g_buffer_picture.h"

#include <cmath>

namespace ghost::render {
namespace {

using CoarseLightTest = RelightTest;

std::vector<shared::Light> lights() {
    return {aimed_light({-4, 0, 8}, {-1, 2, 0}, 20, 20000), aimed_light({4, 2, 8}, {1, 3, 1}, 35, 20000)};
}

Settings settings(bool coarse) {
    Settings all;
    all.haze = {0.03f, 0.03f, 0.77f, -0.6f, 0.035f};
    all.ambient = glm::vec3(5.0f);
    all.coarse = coarse;
    return all;
}

struct Pictures {
    image::ImageF whole, coarse;
};

Pictures pictures(int width, int height, const std::vector<shared::Light>& lit) {
    Report report;
    const StageModel model(device(), room_with_boards(), report);
    GBuffer buffer(device(), width, height);
    const Settings whole = settings(false);
    buffer.draw(model, pose_of(camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, width, height)),
                {whole.ambient, whole.haze});
    Pictures both;
    for (const bool coarse : {false, true}) {
        Relighter relighter(device(), buffer, nullptr, test_gobos(), static_cast<int>(lit.size()),
                            settings(coarse));
        EXPECT_EQ(relighter.width(), width);
        EXPECT_EQ(relighter.height(), height);
        relighter.draw(lit);
        (coarse ? both.coarse : both.whole) = relighter.frame();
    }
    return both;
}

double mean(const image::ImageF& picture) {
    double sum = 0;
    for (const float sample : picture.samples) sum += static_cast<double>(sample);
    return sum / static_cast<double>(picture.samples.size());
}

TEST_F(CoarseLightTest, HasTheSameLightAndNearlyTheSamePicture) {
    for (const glm::ivec2 size : {glm::ivec2(192, 96), glm::ivec2(191, 95)}) {
        SCOPED_TRACE(size.x);
        const Pictures both = pictures(size.x, size.y, lights());
        EXPECT_NEAR(mean(both.coarse) / mean(both.whole), 1.0, 0.01);
        double error = 0;
        for (std::size_t k = 0; k < both.whole.samples.size(); ++k)
            error += std::abs(static_cast<double>(both.whole.samples[k]) -
                              static_cast<double>(both.coarse.samples[k]));
        EXPECT_LT(error / static_cast<double>(both.whole.samples.size()), 0.06 * mean(both.whole));
    }
}

TEST_F(CoarseLightTest, WithoutLightsItIsThePictureBitForBit) {
    std::vector<shared::Light> dark = lights();
    for (shared::Light& light : dark) light.intensity_cd = light.bounce_cd = glm::vec3(0.0f);
    const Pictures both = pictures(190, 94, dark);
    EXPECT_EQ(both.whole.samples, both.coarse.samples);
}

} // namespace
} // namespace ghost::render
