// SPDX-License-Identifier: Apache-2.0
// Light is never made from nothing, whatever the makers' files: each fixture of ../shared/fixtures in a room,
// and each plot with all that it draws, with every lamp on.
#include "light/bodies.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "live/session/atmosphere.h"
#include "live/session/session.h"
#include "support/bounce_trial.h"
#include "support/must.h"
#include "support/test_folder.h"
#include "support/test_stage.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(GHOST_SOURCE_DIR) / "../shared/fixtures";

std::set<fs::path> files_of(const char* folder) {
    std::set<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kFolder / folder)) files.insert(entry.path());
    return files;
}

// Everything on, and half of the heads up.
std::vector<shared::Light> lit(const scene::Show& show, const scene::GoboStack& gobos) {
    scene::Rig rig(show);
    std::map<std::size_t, fixture::Programmer> programmer;
    for (std::size_t k = 0; k < show.fixtures.size(); ++k)
        programmer[k] = {.intensity = 1.0f, .tilt_deg = k % 2 == 0 ? 30.0f : 120.0f};
    rig.step({}, 0, programmer);
    return rig.lit(gobos, scene::DistanceMaps{}, scene::Cells::apart).lights;
}

TEST(BounceFixtures, LightOfEveryFixtureIsNeverMadeFromNothing) {
    if (!fs::exists(kFolder)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    scene::Stage room;
    bake::place(room,
                bake::add_mesh(room, bake::box_mesh({5, 6, 3}), bake::add_material(room, glm::vec3(0.8f))),
                glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 3)));
    bake::BounceTrial trial(room, {bake::spot({0, 0, 3}, {0, 0, 0}, 20, 0)});
    ASSERT_TRUE(trial.is_made());
    int shining = 0;
    for (const fs::path& file : files_of("gdtf")) {
        SCOPED_TRACE(file.filename().string());
        const TestFolder folder;
        fs::create_symlink(fs::absolute(file), folder.path / "it.gdtf");
        std::ofstream(folder.path / "show.toml")
            << "[show]\nstage = \"none.glb\"\n[[camera]]\nname = \"c\"\nposition_m = [0, -4, 3]\n"
               "target_m = [0, 0, 3]\n[[fixture]]\nname = \"it\"\ngdtf = \"it.gdtf\"\n"
               "position_m = [0, 0, 3]\n";
        Report report;
        const scene::Show show = must(open_show(folder.path.string(), false, true, report));
        const scene::GoboStack gobos = scene::build_gobos(show, report);
        const std::vector<shared::Light> lights = lit(show, gobos);
        if (lights.empty()) continue;
        const double kept = trial.solve(lights, gobos.images, {0.05f, 0.05f, 0.5f, 0, 0}, 2);
        shining += kept > 0;
        std::printf("%s: %zu lights, kept %.4f\n", file.filename().c_str(), lights.size(), kept);
    }
    EXPECT_GT(shining, 50);
}

TEST(BounceFixtures, LightOfEveryPlotIsNeverMadeFromNothing) {
    if (!fs::exists(kFolder)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    for (const fs::path& file : files_of("mvr")) {
        SCOPED_TRACE(file.filename().string());
        Report report;
        scene::Show show = must(open_show(file.string(), false, true, report));
        load_stage(show, report);
        const scene::GoboStack gobos = scene::build_gobos(show, report);
        const scene::Stage stage = scene::stage_with_bodies(show, report);
        const std::vector<shared::Light> lights = lit(show, gobos);
        bake::BounceTrial trial(stage, lights);
        std::printf("%s: %zu lights, %zu instances, %zu cells: kept ", file.filename().c_str(), lights.size(),
                    stage.instances.size(), trial.bounce().fine.cells.size());
        for (const shared::Haze& haze : {atmosphere_of(show).medium(), shared::Haze{}})
            if (trial.is_made()) std::printf("%.4f ", trial.solve(lights, gobos.images, haze, 2));
        std::printf("\n");
    }
}

} // namespace
} // namespace ghost::app
