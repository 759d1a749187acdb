// SPDX-License-Identifier: Apache-2.0
// The ten real MVR files of ../shared/fixtures opened as shows: counts as oracle_mvr.json has them, places
// and addresses as in the Plot, lights where a designer expects them.
#include "support/mvr_files.h"

#include "fixture/decode.h"
#include "light/bodies.h"
#include "light/rig.h"
#include "plots/plot_show.h"
#include "show_folder/load_show.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>

namespace ghost::scene {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(GHOST_SOURCE_DIR) / ".." / "shared" / "fixtures";

bool is_there() {
    return std::filesystem::exists(kFolder / "mvr");
}

Show opened_real(const std::string& file, Report& report) {
    auto show = load_show(kFolder / "mvr" / file, true, report);
    EXPECT_TRUE(show.ok()) << show.error().text();
    return show.ok() ? std::move(*show) : Show{};
}

TEST(plot_real_files, open_as_shows) {
    if (!is_there()) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    const auto oracle = nlohmann::json::parse(std::ifstream(kFolder / "oracle_mvr.json"));
    std::size_t fixtures = 0;
    for (const auto& [file, readings] : oracle.items()) {
        SCOPED_TRACE(file);
        const auto start = std::chrono::steady_clock::now();
        Report report;
        const Show show = opened_real(file, report);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::cout << file << ": " << show.fixtures.size() << " fixtures, " << show.stage.instances.size()
                  << " objects, " << show.stage.meshes.size() << " meshes, " << show.stage.drawn_triangles()
                  << " triangles, " << seconds << " s\n";
        const auto& expected = readings["xml"]["fixtures"];
        ASSERT_EQ(show.fixtures.size(), expected.size());
        fixtures += expected.size();
        std::set<std::string> names;
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const PatchedFixture& fixture = show.fixtures[k];
            EXPECT_TRUE(names.insert(fixture.name).second) << fixture.name;
            EXPECT_EQ(fixture.uuid, expected[k]["uuid"].get<std::string>());
            EXPECT_EQ(fixture.fixture_id, expected[k]["id"].get<std::string>());
            // "Cluster S2" is found by the part behind the @, which the oracle does not look at.
            EXPECT_EQ(fixture.type != nullptr,
                      !expected[k]["resolved"].is_null() ||
                          (expected[k]["gdtf"] == "Cluster S2" && file == "bauke_basic_festival.mvr"))
                << fixture.name;
            if (fixture.type && !expected[k]["mode"].get<std::string>().empty() &&
                !says(report, {"no mode '" + expected[k]["mode"].get<std::string>()})) {
                EXPECT_EQ(fixture.type->modes[static_cast<std::size_t>(fixture.mode)].name,
                          expected[k]["mode"].get<std::string>());
            }
            const auto& world = expected[k]["world_mm"];
            const glm::mat4 to_world = fixture_to_world(fixture, 0);
            for (int i = 0; i < 12; ++i) {
                const double number = static_cast<double>(to_world[i / 3][i % 3]);
                const double wanted = world[static_cast<std::size_t>(i)].get<double>();
                // Turned lanterns point at their focus.
                if (i >= 9) {
                    EXPECT_NEAR(number * 1000.0, wanted, 0.5) << fixture.name;
                } else if (fixture.type &&
                           fixture.type->modes[static_cast<std::size_t>(fixture.mode)].axes.size()) {
                    EXPECT_NEAR(number, wanted, 1e-3) << fixture.name;
                }
            }
            int expected_address = 0;
            for (const auto& address : expected[k]["addresses"])
                if (address[0] == 0) expected_address = address[1].get<int>();
            EXPECT_EQ(fixture.address > 0 ? (fixture.universe - 1) * 512 + fixture.address : 0,
                      expected_address);
        }
        for (const Camera& camera : show.cameras) {
            EXPECT_LT(glm::length(camera.position_m), 1000.0f) << camera.name;
            EXPECT_GT(glm::distance(camera.position_m, camera.target_m), 0.5f) << camera.name;
        }
        Rig rig(show);
        rig.step({}, 0.0);
        Report of_bodies;
        const Stage with_bodies = stage_with_bodies(show, of_bodies);
        EXPECT_GE(with_bodies.instances.size(), show.stage.instances.size());
    }
    EXPECT_EQ(fixtures, 477u);
}

TEST(plot_real_files, capture_and_festival) {
    if (!is_there()) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    Report report;
    const Show capture = opened_real("pymvr_capture_demo_show.mvr", report);
    EXPECT_GT(capture.stage.instances.size(), 2000u);
    EXPECT_LE(capture.stage.meshes.size(), 1800u);
    EXPECT_LT(capture.stage.materials.size(), 200u) << "materials that say the same are one";
    // Moving heads that hang look down: the pivot lies below where the base is.
    std::size_t hung = 0;
    std::size_t down = 0;
    for (const PatchedFixture& fixture : capture.fixtures) {
        if (!fixture.type || fixture.position_m.z < 3.0f) continue;
        ++hung;
        down += glm::vec3(fixture_to_world(fixture, 0)[2]).z > 0.5f ? 1u : 0u;
    }
    EXPECT_GT(hung, 30u);
    EXPECT_GT(down * 10, hung * 5) << down << " of " << hung;
    // Meshes are millimetres: a stage of tens of metres.
    glm::vec3 low(1e9f), high(-1e9f);
    for (const Instance& instance : capture.stage.instances) {
        low = glm::min(low, glm::vec3(instance.world[3]));
        high = glm::max(high, glm::vec3(instance.world[3]));
    }
    EXPECT_LT(glm::length(high - low), 500.0f);
    EXPECT_GT(glm::length(high - low), 5.0f);

    Report of_festival;
    const Show festival = opened_real("bauke_basic_festival.mvr", of_festival);
    EXPECT_EQ(festival.stage.instances.size() > 40, true) << festival.stage.instances.size();
    std::size_t dark = 0;
    for (const PatchedFixture& fixture : festival.fixtures) dark += fixture.type ? 0u : 1u;
    EXPECT_EQ(dark, 3u);
}

} // namespace
} // namespace ghost::scene
