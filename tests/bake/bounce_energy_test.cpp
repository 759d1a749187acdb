// SPDX-License-Identifier: Apache-2.0
// Light is never made from nothing, whatever the stage. Some stages by number; GHOST_TEST_STAGES=200 is more
// of them.
#include "support/bounce_trial.h"
#include "support/random_stage.h"

#include <cstdio>
#include <cstdlib>

namespace ghost::bake {
namespace {

constexpr int kUsual = 20;

void solve_stage(int number) {
    const RandomStage made = random_stage(static_cast<std::uint32_t>(number));
    SCOPED_TRACE("stage " + std::to_string(number) + ", " + made.kind);
    BounceTrial trial(made.stage, made.lights);
    std::printf("%3d %s, %zu cells, %zu surfels: kept", number, made.kind.c_str(),
                trial.bounce().fine.cells.size(), trial.bounce().fine.surfels.size());
    if (trial.is_made())
        for (const shared::Haze& haze : made.hazes) // jumps from one to the next
            for (const int passes : {2, 3}) std::printf(" %.4f", trial.solve(made.lights, {}, haze, passes));
    std::printf("\n");
}

TEST(BounceEnergy, LightIsNeverMadeFromNothing) {
    const char* const more = std::getenv("GHOST_TEST_STAGES");
    for (int number = 0; number < (more ? std::atoi(more) : kUsual); ++number) solve_stage(number);
}

} // namespace
} // namespace ghost::bake
