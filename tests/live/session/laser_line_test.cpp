// SPDX-License-Identifier: Apache-2.0
// The curves of a laser on a wall, thinner than a pixel.
#include "support/thesis_scene.h"

#include "shared/figure.h"
#include "support/test_view.h"

namespace ghost::app {
namespace {

using glm::vec3;

// A wall that fills the picture; a laser before it sweeps a level line or wave across.
double light_on_wall(std::uint32_t kind, float height_m, float deviation_deg) {
    scene::Stage stage = empty_stage();
    add_box(stage, {-30, 9, -30}, {30, 9.2f, 30});
    shared::Light light = render::aimed_light({0, 0, height_m}, {0, 9, height_m}, 40, 1000);
    render::put_figure(light, kind, deviation_deg);
    light.figure.half_size = {0.5f, 0.0f};
    light.figure.cosine = 1.0f;
    light.figure.sine = 0.0f;
    render::Settings settings = bench_settings();
    settings.air = false;
    LiveStage live(std::move(stage), {light}, 96, 54, settings);
    live.look({{0, -12, 3}, {0, 9, 3}, 40});
    return mean_of(live.draw());
}

// However it lies to the rows of pixels, it has the light that one of three pixels' width has.
TEST(LaserLine, HasItsLightInWhicheverRowItFalls) {
    constexpr float kPixel_m = 21.0f * 2.0f * 0.36397f / 54.0f;
    for (const std::uint32_t kind : {shared::kLineFigure, shared::kWaveFigure}) {
        const double wide = light_on_wall(kind, 3, 1.5f);
        ASSERT_GT(wide, 0);
        double least = 1e9, most = 0;
        for (int k = 0; k < 8; ++k) {
            const double share = light_on_wall(kind, 3 + static_cast<float>(k) / 8 * kPixel_m, 0.02f) / wide;
            least = std::min(least, share);
            most = std::max(most, share);
        }
        std::printf("figure %u: %.3f to %.3f of its light\n", kind, least, most);
        EXPECT_GT(least, 0.96);
        EXPECT_LT(most, 1.04);
    }
}

} // namespace
} // namespace ghost::app
