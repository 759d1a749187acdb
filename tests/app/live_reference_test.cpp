// SPDX-License-Identifier: Apache-2.0
// The live renderer against ../shared/reference: beams in dense haze with gobos, shadows on surfaces and in
// the air, from an integrator that shares nothing with us. Drawn as for a still: four times the size, the
// largest distance maps. Figures of smaller ones: docs/live-accuracy.md.
#include "blender_scene.h"
#include "live_picture.h"

#include <cstdio>
#include <filesystem>

namespace ghost::app {
namespace {

const std::filesystem::path kShared = "../shared/reference";
constexpr int kFactor = 4;

class LiveReference : public testing::TestWithParam<const char*> {};

TEST_P(LiveReference, Reproduced) {
    const std::string name = GetParam();
    if (!std::filesystem::exists(kShared / (name + ".json")))
        GTEST_SKIP() << "no ../shared beside the checkout: nothing to compare with";
    BlenderScene scene;
    ASSERT_NO_FATAL_FAILURE(read_blender_scene(kShared, name, scene));
    const bake::Tracer tracer(scene.stage);
    std::vector<shared::Light> lights{scene.light};
    const scene::DistanceMaps maps = trace_maps(tracer, lights, scene::kMaxDistanceMapSize);
    scene::Report report;
    const render::StageModel model(live_device(), scene.stage, report);
    ASSERT_FALSE(report.lost_anything());
    LiveScene live{model, scene.camera, lights, scene.gobos, maps, {}};
    live.settings.haze = scene.haze;
    const DisplayFigures found = compare_displayed(scene, live_picture(live, kFactor));
    std::printf("%s: display PSNR %.1f dB, mean ratio %.4f (20 px round the lamp left out)\n", name.c_str(),
                found.psnr_db, found.mean_ratio);
    EXPECT_GE(found.psnr_db, 45.0);
    EXPECT_NEAR(found.mean_ratio, 1.0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Scenes, LiveReference,
                         testing::Values("A_side_plain", "A_side_gobo", "B_back_plain", "B_back_gobo"),
                         [](const auto& picture) { return std::string(picture.param); });

} // namespace
} // namespace ghost::app
