// SPDX-License-Identifier: Apache-2.0
// The reference picture against independent integrators that read only a scene's JSON and its gobo: our own
// of tools/make_references.py, always, and that of ../shared/reference, whose scenes Blender made.
#include "reference/reference.h"
#include "support/reference_scene.h"

#include <cstdio>

namespace ghost::bake {
namespace {
using glm::dvec3;

struct Wanted {
    ReferenceName reference;
    int every; // pixel, so that large ones take seconds
};

class IndependentReference : public testing::TestWithParam<Wanted> {};

// The spot of the JSON as it is, not as a picture in our gate.
BeamOverride spot_of(const ReferenceScene& scene) {
    return [&](const dvec3& gate_m) {
        if (gate_m.z <= 0) return dvec3(0);
        return dvec3(scene.light.intensity_cd) *
               scene.gate->at(glm::dvec2(gate_m) / gate_m.z / scene.gate->tan_half());
    };
}

TEST_P(IndependentReference, Reproduced) {
    const auto& [reference, every] = GetParam();
    if (reference.is_missing()) GTEST_SKIP() << kNoShared;
    ReferenceScene scene;
    ASSERT_NO_FATAL_FAILURE(read_reference(reference, scene));
    ReferenceOptions options;
    options.beam = spot_of(scene);
    options.air_samples = 1024; // times 4 x 4 positions in the pixel
    options.pixel_samples = 4;  // as theirs: with 2 x 2 the silhouettes alone leave 42 dB
    options.every = every;
    options.far_m = 30;
    const Tracer tracer(scene.stage);
    const auto ours = reference_picture(&tracer, scene.camera, {scene.light}, {}, scene.haze, 0, options);
    ASSERT_TRUE(ours.ok()) << ours.error().text();

    image::ImageF theirs(ours->width, ours->height, 3);
    for (int y = 0; y < theirs.height; ++y)
        for (int x = 0; x < theirs.width; ++x)
            std::copy_n(scene.theirs.at(x * every, y * every), 3, theirs.at(x, y));
    scene.theirs = std::move(theirs);
    // The middle of our pixel is that of the one of theirs that we take.
    for (image::Circle& circle : scene.left_out) {
        const auto step = static_cast<float>(every);
        circle = {(circle.x - 0.5f) / step + 0.5f, (circle.y - 0.5f) / step + 0.5f, circle.radius / step};
    }
    const DisplayFigures found = compare_displayed(scene, *ours);
    std::printf("%s: display PSNR %.1f dB, mean ratio %.4f\n", reference.name, found.psnr_db,
                found.mean_ratio);
    EXPECT_GT(found.psnr_db, 70);
    EXPECT_NEAR(found.mean_ratio, 1, 0.001);
}

std::string name_of(const testing::TestParamInfo<Wanted>& wanted) {
    return wanted.param.reference.name;
}

INSTANTIATE_TEST_SUITE_P(Own, IndependentReference,
                         testing::Values(Wanted{{kOwnReferences, "across"}, 1},
                                         Wanted{{kOwnReferences, "towards"}, 1}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, IndependentReference,
                         testing::Values(Wanted{{kSharedReferences, "A_side_plain"}, 4},
                                         Wanted{{kSharedReferences, "A_side_gobo"}, 4},
                                         Wanted{{kSharedReferences, "B_back_plain"}, 4},
                                         Wanted{{kSharedReferences, "B_back_gobo"}, 4}),
                         name_of);

} // namespace
} // namespace ghost::bake
