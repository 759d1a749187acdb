// SPDX-License-Identifier: Apache-2.0
// Bounced light against ../shared/reference: pictures of Cycles with 12 scatterings in haze and 4 on
// surfaces.
#include "bake/light_walk.h"
#include "bake/reference.h"
#include "blender_scene.h"

#include <cstdio>
#include <filesystem>

namespace ghost::app {
namespace {

const std::filesystem::path kShared = "../shared/reference";
constexpr int kEvery = 8; // the judge's pictures are so much smaller

// Mean of the picture but for the lamp's 20 pixels of 512.
double mean_off_lamp(const BlenderScene& scene, const image::ImageF& picture) {
    const double scale = 512.0 / picture.width;
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (glm::distance(glm::dvec2(x + 0.5, y + 0.5) * scale, scene.lamp_px) < 20) continue;
            for (int c = 0; c < 3; ++c, ++count) sum += static_cast<double>(picture.at(x, y)[c]);
        }
    return sum / count;
}

class BounceReference : public testing::TestWithParam<const char*> {};

TEST_P(BounceReference, TheJudgeSeesWhatCyclesSees) {
    const std::string name = GetParam();
    if (!std::filesystem::exists(kShared / (name + ".json")))
        GTEST_SKIP() << "no ../shared beside the checkout: nothing to compare with";
    BlenderScene scene;
    ASSERT_NO_FATAL_FAILURE(read_blender_scene(kShared, name, scene));
    auto cycles = image::read_exr(kShared / (name + ".multi_filtered.exr"));
    ASSERT_TRUE(cycles.ok()) << cycles.error().text();
    const auto text = read_text_file(kShared / (name + ".json"), 1 << 20);
    ASSERT_TRUE(text.ok());
    const nlohmann::json medium = nlohmann::json::parse(*text)["medium"];
    const bake::Tracer tracer(scene.stage);
    scene::Camera camera = scene.camera;
    camera.width /= kEvery;
    camera.height /= kEvery;
    bake::WalkOptions options;
    options.particles = 500'000;
    options.camera = &camera;
    options.first_order = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        options.air_low_m[static_cast<int>(axis)] = medium["domain_min"][axis];
        options.air_high_m[static_cast<int>(axis)] = medium["domain_max"][axis];
    }
    auto walk = bake::walk_light(tracer, {scene.light}, scene.gobos, scene.haze, options);
    ASSERT_TRUE(walk.ok()) << walk.error().text();
    const double ratio = mean_off_lamp(scene, walk->picture) / mean_off_lamp(scene, cycles->pixels);
    std::printf("%s: judge / Cycles %.3f\n", name.c_str(), ratio);
    EXPECT_NEAR(ratio, 1.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BounceReference,
                         testing::Values("A_side_plain", "A_side_gobo", "B_back_plain", "B_back_gobo"),
                         [](const auto& name) { return std::string(name.param); });

} // namespace
} // namespace ghost::app
