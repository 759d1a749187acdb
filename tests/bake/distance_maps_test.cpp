// SPDX-License-Identifier: Apache-2.0
// Distance maps: known distances, what is made again and what is kept, interruptions, threads, bad stages.
#include "bake/distance_maps.h"
#include "passes/distance_maps_file.h"
#include "shared/octahedral.h"
#include "support/test_show.h"

#include <atomic>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace ghost::bake {
namespace {

constexpr int kSize = 64;
using Names = std::vector<std::string>;

struct Outcome {
    DistanceMapStats stats;
    scene::DistanceMaps maps;
    Report report;
    Names made; // fixtures
};

Outcome update(const scene::Show& show, DistanceMapOptions options = {}) {
    Outcome run;
    options.size = options.size == scene::kDistanceMapSize ? kSize : options.size;
    std::map<std::size_t, std::string> made;
    options.on_map = [&](std::size_t index, const scene::DistanceMap& map) { made[index] = map.fixture; };
    const auto stats = update_distance_maps(show, show.stage, options, run.maps, run.report);
    EXPECT_TRUE(stats.ok());
    if (stats.ok()) run.stats = *stats;
    for (const auto& [index, fixture] : made) run.made.push_back(fixture);
    EXPECT_EQ(static_cast<std::size_t>(run.stats.made), made.size());
    return run;
}

glm::mat4 at(const glm::vec3& place) {
    return glm::translate(glm::mat4(1.0f), place);
}

// A closed room, 8 x 6 x 4 m, parted by a wall at x = 0; a lamp in the middle of each half, and a crate by
// the floor of the right half (the last instance).
scene::Show two_rooms(const std::filesystem::path& folder) {
    scene::Show show;
    show.folder = folder;
    const int grey = add_material(show.stage, {0.5f, 0.5f, 0.5f});
    place(show.stage, add_mesh(show.stage, box_mesh({4, 3, 2}), grey), at({0, 0, 2}));
    place(show.stage, add_mesh(show.stage, box_mesh({0.05f, 3, 2}), grey), at({0, 0, 2}));
    place(show.stage, add_mesh(show.stage, box_mesh({0.3f, 0.3f, 0.3f}), grey), at({3, 1, 0.5f}));
    add_fixture(show, "left", {-2, 0.2f, 2.1f});
    add_fixture(show, "right", {2, 0.2f, 2.1f});
    return show;
}

// The maps must be those of an update from nothing.
void expect_as_from_scratch(const Outcome& run, scene::Show show) {
    const TestFolder fresh;
    show.folder = fresh.path;
    const Outcome scratch = update(show);
    ASSERT_EQ(run.maps.maps.size(), scratch.maps.maps.size());
    for (std::size_t k = 0; k < run.maps.maps.size(); ++k) {
        EXPECT_EQ(run.maps.maps[k].fixture, scratch.maps.maps[k].fixture);
        EXPECT_TRUE(run.maps.maps[k].distance == scratch.maps.maps[k].distance) << k;
    }
}

TEST(DistanceMaps, KnownDistancesInARoom) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    show.stage.instances.pop_back();
    show.stage.instances.pop_back();
    show.fixtures.pop_back();
    for (const int size : {64, 75}) { // 75: packets at the border are not full
        DistanceMapOptions options;
        options.size = size;
        const Outcome run = update(show, options);
        ASSERT_EQ(run.maps.maps.size(), 1u);
        const scene::DistanceMap& map = run.maps.maps[0];
        EXPECT_EQ(map.position_m, glm::vec3(-2, 0.2f, 2.1f));
        float worst = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::vec3 way =
                    shared::direction_from_octahedral((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
                float expected = 1e9f;
                for (int axis = 0; axis < 3; ++axis) {
                    const float half[3] = {4, 3, 2};
                    const float middle = axis == 2 ? 2.0f : 0.0f;
                    const float wall = middle + (way[axis] < 0 ? -half[axis] : half[axis]);
                    if (way[axis] != 0.0f)
                        expected = std::min(expected, (wall - map.position_m[axis]) / way[axis]);
                }
                const float distance =
                    glm::unpackHalf1x16(map.distance[static_cast<std::size_t>(y * size + x)]);
                worst = std::max(worst, std::abs(distance / expected - 1));
            }
        EXPECT_LT(worst, 5.0e-4f); // half floats: 2^-11
        EXPECT_NEAR(map.nearest_m, 1.9f, 0.002f);
        EXPECT_GT(map.farthest_m, 6.0f);
        EXPECT_LT(map.farthest_m, glm::length(glm::vec3(6, 3.2f, 2.1f)));
        EXPECT_EQ(run.stats.rays, static_cast<std::uint64_t>(size * size));
    }
}

TEST(DistanceMaps, OpenAirHolesGlassAndBodies) {
    const TestFolder folder;
    scene::Show show;
    show.folder = folder.path;
    add_fixture(show, "lamp", {0, 0, 0});
    const auto sheet = [&](float z, float size, scene::Material material, int fixture) {
        show.stage.materials.push_back(material);
        const float half = size / 2;
        place(show.stage,
              add_mesh(show.stage, quad_mesh({-half, -half, z}, {size, 0, 0}, {0, size, 0}),
                       static_cast<int>(show.stage.materials.size()) - 1),
              glm::mat4(1.0f), fixture);
    };
    scene::Material thin;
    thin.alpha_mode = scene::AlphaMode::blend;
    thin.alpha = 0.4f;
    scene::Material dense = thin;
    dense.alpha = 0.6f;
    scene::Material net;
    net.alpha_mode = scene::AlphaMode::mask;
    net.base_texture = 0;
    image::Image8 pixels(2, 1, 4);
    pixels.samples = {255, 255, 255, 255, 255, 255, 255, 0}; // a hole in the right half
    show.stage.textures.push_back({"net", pixels, true});
    sheet(-1, 50, {}, 0); // its own body
    sheet(-2, 50, thin, scene::kNone);
    sheet(-3, 4, net, scene::kNone);
    sheet(-5, 50, dense, scene::kNone);
    const Outcome run = update(show);
    ASSERT_EQ(run.maps.maps.size(), 1u);
    const auto along = [&](const glm::vec3& way) {
        const glm::ivec2 texel(shared::octahedral_from(way) * static_cast<float>(kSize));
        const glm::vec3 centre =
            shared::direction_from_octahedral((glm::vec2(texel) + 0.5f) / static_cast<float>(kSize));
        const std::uint16_t half =
            run.maps.maps[0].distance[static_cast<std::size_t>(texel.y * kSize + texel.x)];
        if (half == scene::kNoSurface) return 0.0f;
        return glm::unpackHalf1x16(half) * -centre.z; // depth of the sheet
    };
    EXPECT_NEAR(along({-0.3f, 0, -1}), 3.0f, 0.003f);
    EXPECT_NEAR(along({0.3f, 0, -1}), 5.0f, 0.005f);
    EXPECT_EQ(along({0.1f, 0.1f, 1}), 0.0f);
    EXPECT_EQ(along({1, 0, -0.01f}), 0.0f);

    // What is not seen may go; the alpha of what is seen counts, its colour does not.
    show.stage.materials[2].base_colour = {1, 0, 0};
    show.stage.instances.erase(show.stage.instances.begin() + 1);
    show.stage.instances.erase(show.stage.instances.begin());
    EXPECT_EQ(update(show).made, Names{});
    show.stage.textures[0].pixels.samples[7] = 255;
    EXPECT_EQ(update(show).made, Names{"lamp"});
    show.stage.materials[3].alpha = 0.3f;
    EXPECT_EQ(update(show).made, Names{"lamp"});
}

TEST(DistanceMaps, SecondTimeNothingIsDone) {
    const TestFolder folder;
    const scene::Show show = two_rooms(folder.path);
    const Outcome first = update(show);
    EXPECT_EQ(first.made, (Names{"left", "right"}));
    const auto before = contents(folder.path);
    EXPECT_EQ(before.size(), 3u);
    const Outcome second = update(show);
    EXPECT_EQ(second.made, Names{});
    EXPECT_EQ(second.stats.kept, 2);
    EXPECT_EQ(second.stats.rays, 0u);
    EXPECT_TRUE(contents(folder.path) == before);
    Report report;
    const auto loaded = scene::load_distance_maps(show, kSize, report);
    ASSERT_TRUE(loaded.ok());
    ASSERT_EQ(loaded->maps.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(loaded->maps[k].distance == first.maps.maps[k].distance);
        EXPECT_TRUE(loaded->maps[k].distance == second.maps.maps[k].distance);
        EXPECT_EQ(loaded->maps[k].nearest_m, first.maps.maps[k].nearest_m);
        EXPECT_EQ(second.maps.maps[k].farthest_m, first.maps.maps[k].farthest_m);
    }
    EXPECT_TRUE(report.messages.empty());
}

TEST(DistanceMaps, AnObjectConcernsOnlyTheLightsThatSeeIt) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    update(show);
    show.stage.instances[2].world = at({2.5f, -1, 0.5f}); // moved, behind the wall for the left lamp
    Outcome run = update(show);
    EXPECT_EQ(run.made, Names{"right"});
    EXPECT_EQ(run.stats.kept, 1);
    expect_as_from_scratch(run, show);
    show.stage.instances[2].world = at({-2.5f, -1, 0.5f}); // into the other room
    run = update(show);
    EXPECT_EQ(run.made, (Names{"left", "right"}));
    expect_as_from_scratch(run, show);
    const scene::Instance crate = show.stage.instances.back();
    show.stage.instances.pop_back(); // hidden
    run = update(show);
    EXPECT_EQ(run.made, Names{"left"});
    expect_as_from_scratch(run, show);
    EXPECT_EQ(update(show).made, Names{});
    show.stage.instances.insert(show.stage.instances.begin(), crate); // shown, and the order does not matter
    run = update(show);
    EXPECT_EQ(run.made, Names{"left"});
    expect_as_from_scratch(run, show);
    show.stage.instances[2].world = at({0, 0, -50}); // the wall goes
    run = update(show);
    EXPECT_EQ(run.made, (Names{"left", "right"}));
    expect_as_from_scratch(run, show);
}

TEST(DistanceMaps, SmallAndThinThingsAreNoticedOrChangeNothing) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    update(show);
    const int grain = add_mesh(show.stage, box_mesh({0.02f, 0.02f, 0.02f}), 0);
    int remade = 0;
    for (int k = 0; k < 30; ++k) {
        const float t = static_cast<float>(k);
        place(show.stage, grain, at({1.0f + 0.09f * t, 2.0f * std::sin(t), 1 + 0.09f * t}));
        const Outcome run = update(show);
        EXPECT_FALSE(std::find(run.made.begin(), run.made.end(), "left") != run.made.end());
        remade += run.stats.made;
        expect_as_from_scratch(run, show);
    }
    EXPECT_GT(remade, 3);
    EXPECT_LT(remade, 30);
}

TEST(DistanceMaps, AMovedLightIsMadeAndARemovedOneLeavesNoFile) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    update(show);
    show.fixtures[1].position_m.z -= 0.001f;
    EXPECT_EQ(update(show).made, Names{"right"});
    show.fixtures[0].track = scene::Track{{show.fixtures[0].position_m, {-1, 0, 3}, {-3, 0, 3}}, 1, 1};
    const Outcome run = update(show);
    EXPECT_EQ(run.made, (Names{"left", "left"}));
    EXPECT_EQ(run.maps.find("left", 2), 2);
    EXPECT_EQ(run.maps.find("right", 0), 3);
    show.fixtures.erase(show.fixtures.begin());
    EXPECT_EQ(update(show).made, Names{});
    EXPECT_EQ(contents(folder.path).size(), 2u);
    show.fixtures[0].type = nullptr;
    EXPECT_TRUE(update(show).maps.maps.empty());
}

TEST(DistanceMaps, DamagedFilesAreReportedAndMadeAgain) {
    const TestFolder folder;
    const scene::Show show = two_rooms(folder.path);
    update(show);
    const auto before = contents(folder.path);
    const auto path = scene::distance_places(show, kSize)[1].file;
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    Outcome run = update(show);
    EXPECT_EQ(run.made, Names{"right"});
    ASSERT_EQ(run.report.messages.size(), 1u);
    EXPECT_EQ(run.report.messages[0].where, path.string());
    EXPECT_TRUE(contents(folder.path) == before);
    // The maps say themselves which stage they show.
    std::ofstream(scene::distance_folder(show, kSize) / "stage.json") << "{";
    run = update(show);
    EXPECT_EQ(run.made, Names{});
    EXPECT_EQ(run.report.messages.size(), 1u);
    EXPECT_TRUE(contents(folder.path) == before);
    DistanceMapOptions options;
    options.size = 80;
    EXPECT_EQ(update(show, options).made.size(), 2u);
    // Each size keeps its own.
    run = update(show);
    EXPECT_EQ(run.made, Names{});
    EXPECT_TRUE(run.report.messages.empty());
    options.size = 32;
    scene::DistanceMaps maps;
    Report report;
    EXPECT_FALSE(update_distance_maps(show, show.stage, options, maps, report).ok());
}

TEST(DistanceMaps, InterruptedUpdateGoesOnAndNeverMixesStages) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    for (int k = 0; k < 6; ++k)
        add_fixture(show, "more " + std::to_string(k), {1 + 0.3f * static_cast<float>(k), -1, 3});
    update(show);
    const scene::Show before = show;
    show.stage.instances[2].world = at({2.5f, -1, 0.5f}); // seen by seven
    std::atomic<bool> stop{false};
    DistanceMapOptions options;
    options.threads = 1;
    options.stop = [&] { return stop.load(); };
    options.progress = [&](double fraction, const std::string&) {
        if (fraction > 0.4) stop = true;
    };
    Outcome run = update(show, options);
    EXPECT_TRUE(run.stats.interrupted);
    EXPECT_EQ(run.stats.kept, 1);
    EXPECT_EQ(run.stats.made, 3);
    EXPECT_EQ(run.maps.maps.size(), 4u);
    Report report;
    const auto loaded = scene::load_distance_maps(show, kSize, report);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->maps.size(), 4u); // those of the old stage do not count

    // Back to the old stage: only what was made for the new one is made again.
    run = update(before, {});
    EXPECT_EQ(run.stats.made, 3);
    expect_as_from_scratch(run, before);
    stop = false;
    EXPECT_TRUE(update(show, options).stats.interrupted);
    run = update(show);
    EXPECT_EQ(run.stats.made, 4);
    EXPECT_EQ(run.stats.kept, 4);
    EXPECT_FALSE(run.stats.interrupted);
    expect_as_from_scratch(run, show);
}

TEST(DistanceMaps, SameBytesWhateverTheThreads) {
    const TestFolder one;
    const TestFolder two;
    DistanceMapOptions options;
    for (const auto& [folder, threads] : {std::pair{&one, 1}, {&two, 2}}) {
        scene::Show show = two_rooms(folder->path);
        show.stage = edgy_stage();
        options.threads = threads;
        options.size = 128;
        update(show, options);
    }
    EXPECT_EQ(contents(one.path).size(), 3u);
    EXPECT_TRUE(contents(one.path) == contents(two.path));
}

TEST(DistanceMaps, AFolderThatCannotBeWrittenCostsAWarning) {
    const TestFolder folder;
    const scene::Show show = two_rooms(folder.path);
    std::ofstream(folder.path / ".ghost") << "a file where the folder belongs";
    const Outcome run = update(show);
    EXPECT_EQ(run.stats.made, 2);
    EXPECT_EQ(run.maps.maps.size(), 2u);
    ASSERT_EQ(run.report.messages.size(), 1u);
    EXPECT_NE(run.report.messages[0].what.find("not kept"), std::string::npos);
    expect_as_from_scratch(run, show);
}

TEST(DistanceMaps, ALightInsideSomethingIsNamed) {
    const TestFolder folder;
    scene::Show show = two_rooms(folder.path);
    const int tight = add_mesh(show.stage, box_mesh({0.02f, 0.02f, 0.02f}), 0);
    place(show.stage, tight, at(show.fixtures[1].position_m));
    for (int k = 0; k < 2; ++k) { // made, then kept
        const Outcome run = update(show);
        ASSERT_EQ(run.report.messages.size(), 1u);
        EXPECT_NE(run.report.messages[0].what.find("'right' hangs inside"), std::string::npos);
    }
}

TEST(DistanceMaps, BadGeometryDoesNoHarm) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const TestFolder folder;
    const TestFolder clean;
    scene::Show show = two_rooms(folder.path);
    scene::Stage& stage = show.stage;
    const Outcome good = update(two_rooms(clean.path));
    place(stage, 2, at({kNan, 0, 0}));
    place(stage, 2, at({1, kInfinite, 0}));
    place(stage, 0, glm::scale(glm::mat4(1.0f), glm::vec3(3e38f))); // overflows
    for (std::size_t k = 3; k < 6; ++k) stage.instances[k].name = "bad " + std::to_string(k);
    place(stage, 2, glm::scale(glm::mat4(1.0f), glm::vec3(0.0f)));
    place(stage, 2, glm::scale(at({0, 0, -30}), glm::vec3(1, 0, 1)));
    for (const float scale : {1e8f, 1e15f, 1e19f, 1e25f, 1e37f}) // below, far away, or round everything
        for (const glm::vec3& where : {glm::vec3(0, 0, -scale), glm::vec3(0, 0, 0)})
            place(stage, 0, glm::scale(at(where), glm::vec3(scale)));
    for (const float scale : {1e-5f, 1e-15f, 1e-30f, 1e-44f})
        place(stage, 0, glm::scale(at({0, 0, -30}), glm::vec3(scale)));
    place(stage, 99);
    place(stage, -1);
    scene::Mesh mesh = quad_mesh({-1, -1, -20}, {2, 0, 0}, {0, 2, 0});
    mesh.indices = {0, 0, 0, 0, 1, 1, 0, 1, 2, 1, 0, 2, 0, 1, 2, 2, 3, 0, 1};
    place(stage, add_mesh(stage, mesh, 0), glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1)));
    mesh.positions[1].x = kNan;
    mesh.positions[2].y = kInfinite;
    place(stage, add_mesh(stage, mesh, 99));
    mesh.positions.assign(4, glm::vec3(kNan));
    place(stage, add_mesh(stage, mesh, -5));
    mesh.positions.assign(4, glm::vec3(0, 0, -20));
    place(stage, add_mesh(stage, mesh, 0));
    mesh.indices = {0, 1, 77};
    place(stage, add_mesh(stage, mesh, 0));
    place(stage, add_mesh(stage, scene::Mesh{}, 0));
    add_fixture(show, "nowhere", {kNan, 0, 0});
    add_fixture(show, "far", {1e30f, 0, 0});

    const Outcome run = update(show);
    ASSERT_EQ(run.maps.maps.size(), 4u);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_TRUE(run.maps.maps[k].distance == good.maps.maps[k].distance) << k;
    EXPECT_EQ(run.maps.maps[2].nearest_m, scene::kNoSurface_m);
    EXPECT_EQ(run.maps.maps[3].nearest_m, scene::kNoSurface_m);
    Names named;
    for (const Message& message : run.report.messages) named.push_back(message.what.substr(0, 17));
    EXPECT_EQ(named, (Names{"object 'bad 3' ha", "object 'bad 4' ha", "object 'bad 5' ha",
                            "fixture 'nowhere'", "fixture 'far' han"}));
    EXPECT_EQ(update(show).stats.made, 0);
    const TestFolder bare;
    show.folder = bare.path;
    show.stage = {};
    EXPECT_EQ(update(show).maps.maps[0].farthest_m, scene::kNoSurface_m);
}

} // namespace
} // namespace ghost::bake
