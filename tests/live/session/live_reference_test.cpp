// SPDX-License-Identifier: Apache-2.0
// The live renderer against tests/references and ../shared/reference: beams in dense haze with gobos, shadows
// on surfaces and in the air, from integrators that share nothing with us. Drawn as for a still (render
// --supersample 4 --map-size 4096) and as a picture that moves is, at its own size.
#include "support/live_picture.h"
#include "support/reference_scene.h"

#include <cstdio>

namespace ghost::app {
namespace {

struct Wanted {
    ReferenceName reference;
    int supersample;
    double least_db;
    double ratio_off; // at most
};

class LiveReference : public testing::TestWithParam<Wanted> {};

TEST_P(LiveReference, Reproduced) {
    const auto& [reference, supersample, least_db, ratio_off] = GetParam();
    if (reference.is_missing()) GTEST_SKIP() << kNoShared;
    ReferenceScene scene;
    ASSERT_NO_FATAL_FAILURE(read_reference(reference, scene));
    const bake::Tracer tracer(scene.stage);
    std::vector<shared::Light> lights{scene.light};
    const scene::DistanceMaps maps = trace_maps(tracer, lights, scene::kMaxDistanceMapSize);
    Report report;
    const render::StageModel model(device(), scene.stage, report);
    ASSERT_FALSE(report.lost_anything());
    LiveScene live{model, scene.camera, lights, scene.gobos, maps, {}};
    live.settings.haze = scene.haze;
    const DisplayFigures found = compare_displayed(scene, live_picture(live, supersample));
    std::printf("%s x%d: display PSNR %.1f dB, mean ratio %.4f\n", reference.name, supersample, found.psnr_db,
                found.mean_ratio);
    EXPECT_GE(found.psnr_db, least_db);
    EXPECT_NEAR(found.mean_ratio, 1.0, ratio_off);
}

std::string name_of(const testing::TestParamInfo<Wanted>& wanted) {
    return std::string(wanted.param.reference.name) + "_x" + std::to_string(wanted.param.supersample);
}

// At 96 pixels across, edges of shadows and of the crate decide.
INSTANTIATE_TEST_SUITE_P(Own, LiveReference,
                         testing::Values(Wanted{{kOwnReferences, "across"}, 4, 41.0, 0.005},
                                         Wanted{{kOwnReferences, "towards"}, 4, 58.0, 0.001},
                                         Wanted{{kOwnReferences, "across"}, 1, 26.5, 0.025},
                                         Wanted{{kOwnReferences, "towards"}, 1, 41.0, 0.005}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, LiveReference,
                         testing::Values(Wanted{{kSharedReferences, "A_side_plain"}, 4, 45.0, 0.005},
                                         Wanted{{kSharedReferences, "A_side_gobo"}, 4, 45.0, 0.005},
                                         Wanted{{kSharedReferences, "B_back_plain"}, 4, 45.0, 0.005},
                                         Wanted{{kSharedReferences, "B_back_gobo"}, 4, 45.0, 0.005},
                                         Wanted{{kSharedReferences, "A_side_plain"}, 1, 37.0, 0.005},
                                         Wanted{{kSharedReferences, "A_side_gobo"}, 1, 33.0, 0.02},
                                         Wanted{{kSharedReferences, "B_back_plain"}, 1, 33.0, 0.005},
                                         Wanted{{kSharedReferences, "B_back_gobo"}, 1, 34.0, 0.005}),
                         name_of);

} // namespace
} // namespace ghost::app
