// SPDX-License-Identifier: Apache-2.0
// The live renderer against ../shared/reference: beams in dense haze with gobos, shadows on surfaces and in
// the air, from an integrator that shares nothing with us. Drawn as for a still (render --supersample 4
// --map-size 4096) and as a picture that moves is, at its own size.
#include "support/blender_scene.h"
#include "support/live_picture.h"

#include <cstdio>
#include <filesystem>

namespace ghost::app {
namespace {

const std::filesystem::path kShared = "../shared/reference";

struct Wanted {
    const char* scene;
    int supersample;
    double least_db;
    double ratio_off; // at most
};

class LiveReference : public testing::TestWithParam<Wanted> {};

TEST_P(LiveReference, Reproduced) {
    const std::string name = GetParam().scene;
    const int supersample = GetParam().supersample;
    if (!std::filesystem::exists(kShared / (name + ".json")))
        GTEST_SKIP() << "no ../shared beside the checkout: nothing to compare with";
    BlenderScene scene;
    ASSERT_NO_FATAL_FAILURE(read_blender_scene(kShared, name, scene));
    const bake::Tracer tracer(scene.stage);
    std::vector<shared::Light> lights{scene.light};
    const scene::DistanceMaps maps = trace_maps(tracer, lights, scene::kMaxDistanceMapSize);
    Report report;
    const render::StageModel model(live_device(), scene.stage, report);
    ASSERT_FALSE(report.lost_anything());
    LiveScene live{model, scene.camera, lights, scene.gobos, maps, {}};
    live.settings.haze = scene.haze;
    const DisplayFigures found = compare_displayed(scene, live_picture(live, supersample));
    std::printf("%s x%d: display PSNR %.1f dB, mean ratio %.4f (20 px round the lamp left out)\n",
                name.c_str(), supersample, found.psnr_db, found.mean_ratio);
    EXPECT_GE(found.psnr_db, GetParam().least_db);
    EXPECT_NEAR(found.mean_ratio, 1.0, GetParam().ratio_off);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LiveReference,
    testing::Values(Wanted{"A_side_plain", 4, 45.0, 0.005}, Wanted{"A_side_gobo", 4, 45.0, 0.005},
                    Wanted{"B_back_plain", 4, 45.0, 0.005}, Wanted{"B_back_gobo", 4, 45.0, 0.005},
                    Wanted{"A_side_plain", 1, 37.0, 0.005}, Wanted{"A_side_gobo", 1, 33.0, 0.02},
                    Wanted{"B_back_plain", 1, 33.0, 0.005}, Wanted{"B_back_gobo", 1, 34.0, 0.005}),
    [](const auto& wanted) {
        return std::string(wanted.param.scene) + "_x" + std::to_string(wanted.param.supersample);
    });

} // namespace
} // namespace ghost::app
