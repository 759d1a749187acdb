// SPDX-License-Identifier: Apache-2.0
// Haze as it is drawn while something moves, from a grid that tests itself (render/haze/grid_pass.h), against
// every ray, which other tests hold to a march in double (tests/render/relight/haze_test.cpp): the views of
// `bench integrators`, with their shadows.
#include "bench/bench_views.h"
#include "render/relight/relighter.h"
#include "support/live_picture.h"

#include <cstdio>

namespace ghost::app {
namespace {

constexpr int kViewMapSide = 512;

// Turned about its own lens.
shared::Light turned(shared::Light light, float degrees) {
    const glm::vec3 u = light.axis_u, w = light.axis_w;
    const float turn = glm::radians(degrees);
    light.axis_w = w * std::cos(turn) + u * std::sin(turn);
    light.axis_u = u * std::cos(turn) - w * std::sin(turn);
    return light;
}

class HazeOnly {
public:
    HazeOnly(const BenchStages& stages, bool grid) {
        render::Settings settings = bench_settings();
        settings.surfaces = false;
        settings.beams.grid = grid;
        relighter_ = std::make_unique<render::Relighter>(device(), stages.g_buffer(), &stages.distances(),
                                                         bench_gobos(), 1, settings);
        render::HazeQuality quality;
        quality.grid = grid;
        relighter_->set_quality(quality);
    }
    image::ImageF drawn(const shared::Light& light) {
        const render::FrameStatistics statistics = relighter_->draw({light});
        from_grid = std::ranges::any_of(statistics.spans,
                                        [](const gpu::Span& span) { return span.name == "haze look-up"; });
        return relighter_->frame();
    }
    bool from_grid = false; // what was drawn last

private:
    std::unique_ptr<render::Relighter> relighter_;
};

TEST(HazeGrid, IsEveryRayWithin45dBAndSixTenthsOfAPercentInEveryView) {
    BenchStages stages(device(), bench_views(), kViewMapSide);
    const std::vector<std::uint8_t> all(
        static_cast<std::size_t>(stages.views()[0].camera.width * stages.views()[0].camera.height), 1);
    int from_grid = 0;
    for (std::size_t k = 0; k < stages.views().size(); ++k) {
        const BenchView& view = stages.views()[k];
        SCOPED_TRACE(view.name);
        stages.look(k);
        HazeOnly every_ray(stages, false), grid(stages, true);
        const image::ImageF before = every_ray.drawn(turned(view.light, 5));
        grid.drawn(turned(view.light, 5));
        // It has turned: what was filled for where it was is of no use.
        const image::ImageF wanted = every_ray.drawn(view.light), got = grid.drawn(view.light);
        EXPECT_FALSE(every_ray.from_grid);
        const Accuracy accuracy = must(accuracy_of(got, wanted, all));
        const Accuracy stale = must(accuracy_of(before, wanted, all));
        std::printf("%-30s %s: %5.1f dB, bias %6.3f %%; where it was %5.1f dB\n", view.name.c_str(),
                    grid.from_grid ? "grid" : "rays", accuracy.psnr_db, accuracy.bias_percent, stale.psnr_db);
        EXPECT_GE(accuracy.psnr_db, 45);
        EXPECT_LT(std::abs(accuracy.bias_percent), 0.6);
        EXPECT_LT(stale.psnr_db, accuracy.psnr_db - 3) << "such a fault would be seen";
        from_grid += grid.from_grid ? 1 : 0;
    }
    EXPECT_GE(from_grid, 8) << "most of these beams are wide enough in the picture";
    EXPECT_EQ(device().validation_errors(), 0u);
}

} // namespace
} // namespace ghost::app
