// SPDX-License-Identifier: Apache-2.0
// What is baked again and what is kept; interruptions, threads, full disks.
#include "passes/passes_file.h"
#include "support/test_show.h"

#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace ghost::bake {
namespace {

// One camera, lamps in a row with a small body each.
scene::Show small_show(const std::filesystem::path& folder, int lamps) {
    scene::Show show;
    show.folder = folder;
    show.stage = edgy_stage();
    const int body = add_mesh(show.stage, box_mesh({0.15f, 0.15f, 0.25f}), 1);
    show.cameras = {edgy_camera(96, 54)};
    for (int k = 0; k < lamps; ++k) {
        const glm::vec3 at(-2.0f + 1.3f * static_cast<float>(k), 1.0f, 3.2f);
        add_fixture(show, "Lamp " + std::to_string(k + 1), at);
        place(show.stage, body, glm::translate(glm::mat4(1.0f), at), k);
    }
    return show;
}

void move_fixture(scene::Show& show, int fixture, const glm::vec3& by) {
    show.fixtures[static_cast<std::size_t>(fixture)].position_m += by;
    for (scene::Instance& instance : show.stage.instances)
        if (instance.fixture == fixture)
            instance.world = glm::translate(glm::mat4(1.0f), by) * instance.world;
}

BakeStats bake_or_fail(const scene::Show& show, const BakeOptions& options = {}) {
    Report report;
    auto stats = bake_show(show, options, report);
    EXPECT_TRUE(stats.ok()) << stats.error().text();
    return stats.ok() ? *stats : BakeStats{};
}

std::vector<std::string> baked(const BakeStats& stats) {
    std::vector<std::string> names;
    for (const BakedPass& pass : stats.passes) names.push_back(pass.camera + "/" + pass.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(ShowBake, SecondTimeNothingIsDone) {
    const TestFolder folder;
    const scene::Show show = small_show(folder.path, 3);
    EXPECT_EQ(baked(bake_or_fail(show)),
              (Names{"front/surroundings", "front/Lamp 1", "front/Lamp 2", "front/Lamp 3"}));
    const auto before = contents(folder.path);
    EXPECT_EQ(before.size(), 1 + 1 + 4 + 2 + 3 * 2u); // manifest, fragments, centres, ambient, lights
    const BakeStats again = bake_or_fail(show);
    EXPECT_EQ(baked(again), Names{});
    EXPECT_EQ(again.kept, 3);
    EXPECT_EQ(contents(folder.path), before);
}

TEST(ShowBake, SameBytesWhateverTheThreads) {
    const TestFolder one;
    const TestFolder many;
    BakeOptions options;
    options.bounces = 1;
    options.threads = 1;
    bake_or_fail(small_show(one.path, 2), options);
    options.threads = 2;
    bake_or_fail(small_show(many.path, 2), options);
    EXPECT_TRUE(contents(one.path) == contents(many.path));
}

TEST(ShowBake, MovedFixtureBakesOnePass) {
    const TestFolder folder;
    const TestFolder fresh;
    scene::Show show = small_show(folder.path, 3);
    bake_or_fail(show);
    move_fixture(show, 1, {0.4f, 0.3f, 0.2f});
    const BakeStats stats = bake_or_fail(show);
    EXPECT_EQ(baked(stats), (Names{"front/Lamp 2"}));
    EXPECT_EQ(stats.patched, 2);
    show.folder = fresh.path;
    bake_or_fail(show);
    const auto now = contents(folder.path);
    const auto expected = contents(fresh.path);
    EXPECT_EQ(now.size(), expected.size());
    for (const auto& [name, bytes] : expected)
        EXPECT_TRUE(now.contains(name) && now.at(name) == bytes) << name;
}

TEST(ShowBake, MovedFixtureOutOfSightTouchesNothingElse) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 3);
    move_fixture(show, 1, {0, -15, 0}); // behind the camera
    bake_or_fail(show);
    const auto before = contents(folder.path);
    move_fixture(show, 1, {0.5f, 0, 0});
    const BakeStats stats = bake_or_fail(show);
    EXPECT_EQ(baked(stats), (Names{"front/Lamp 2"}));
    EXPECT_EQ(stats.patched, 0);
    for (const auto& [name, bytes] : contents(folder.path)) {
        if (name.find("Lamp 2") == std::string::npos && name.find("manifest") == std::string::npos) {
            EXPECT_TRUE(before.at(name) == bytes) << name;
        }
    }
}

TEST(ShowBake, ChangedCameraBakesThatCamera) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 1);
    show.cameras.push_back(edgy_camera(64, 36));
    show.cameras[1].name = "Side/../x";
    bake_or_fail(show);
    show.cameras[1].fov_y_deg += 1;
    EXPECT_EQ(baked(bake_or_fail(show)), (Names{"Side/../x/surroundings", "Side/../x/Lamp 1"}));
    for (const auto& [name, bytes] : contents(folder.path))
        EXPECT_TRUE(name.starts_with(".ghost/passes/")) << name;
    BakeOptions one;
    one.views = {"front"};
    one.spp = 8;
    EXPECT_EQ(baked(bake_or_fail(show, one)), (Names{"front/surroundings", "front/Lamp 1"}));
    one.views = {"frnt"};
    Report report;
    EXPECT_FALSE(bake_show(show, one, report).ok());
}

TEST(ShowBake, ChangedMaterialBakesAll) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 1);
    bake_or_fail(show);
    show.stage.materials[0].base_colour.x += 0.01f;
    EXPECT_EQ(baked(bake_or_fail(show)), (Names{"front/surroundings", "front/Lamp 1"}));
}

TEST(ShowBake, RemovedFixtureLeavesNoFiles) {
    const TestFolder folder;
    const TestFolder fresh;
    scene::Show show = small_show(folder.path, 2);
    bake_or_fail(show);
    show.fixtures.pop_back();
    show.stage.instances.pop_back();
    EXPECT_EQ(baked(bake_or_fail(show)), Names{});
    show.folder = fresh.path;
    bake_or_fail(show);
    EXPECT_TRUE(contents(folder.path) == contents(fresh.path));
}

TEST(ShowBake, InterruptedBakeGoesOn) {
    const TestFolder folder;
    const TestFolder fresh;
    scene::Show show = small_show(folder.path, 10);
    std::atomic<bool> stop{false};
    BakeOptions options;
    options.stop = [&] { return stop.load(); };
    options.progress = [&](double fraction, const std::string&) {
        if (fraction > 0.9) stop = true;
    };
    const BakeStats first = bake_or_fail(show, options);
    EXPECT_TRUE(first.interrupted);
    EXPECT_EQ(first.passes.size(), 9u); // the surroundings and the first eight
    Report report;
    const auto half = scene::load_passes(scene::passes_folder(show, "front"), true, report);
    ASSERT_TRUE(half.ok());
    EXPECT_EQ(half->lights.size(), 8u);
    EXPECT_FALSE(report.lost_anything());

    const BakeStats second = bake_or_fail(show);
    EXPECT_EQ(baked(second), (Names{"front/Lamp 9", "front/Lamp 10"}));
    EXPECT_EQ(second.kept, 8);
    show.folder = fresh.path;
    bake_or_fail(show);
    EXPECT_TRUE(contents(folder.path) == contents(fresh.path));
}

TEST(ShowBake, InterruptedPatchKeepsTheOldPasses) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 2);
    bake_or_fail(show);
    move_fixture(show, 0, {0.3f, 0, 0});
    BakeOptions options;
    options.stop = [] { return true; };
    EXPECT_TRUE(bake_or_fail(show, options).interrupted);
    Report report;
    const auto passes = scene::load_passes(scene::passes_folder(show, "front"), true, report);
    ASSERT_TRUE(passes.ok());
    EXPECT_EQ(passes->lights.size(), 2u);
    EXPECT_FALSE(report.lost_anything());
    EXPECT_EQ(baked(bake_or_fail(show)), (Names{"front/Lamp 1"}));
}

// Files cannot grow beyond the limit while it lives, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit old_{};
    void (*handler_)(int);
};

TEST(ShowBake, FullDiskIsAnErrorAndLeavesNoHalfFile) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 1);
    bake_or_fail(show);
    const auto before = contents(folder.path);
    show.stage.materials[0].base_colour *= 0.9f;
    {
        const FullDisk full(30000);
        Report report;
        const auto stats = bake_show(show, {}, report);
        ASSERT_FALSE(stats.ok());
        EXPECT_NE(stats.error().where.find("front"), std::string::npos) << stats.error().text();
    }
    const auto after = contents(folder.path);
    for (const auto& [name, bytes] : before)
        EXPECT_TRUE(after.contains(name) && after.at(name) == bytes) << name;
    for (const auto& [name, bytes] : after) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    EXPECT_EQ(baked(bake_or_fail(show)).size(), 2u);
}

TEST(ShowBake, DamagedManifestOrFileIsBakedAgain) {
    const TestFolder folder;
    const scene::Show show = small_show(folder.path, 2);
    bake_or_fail(show);
    const auto before = contents(folder.path);
    const std::filesystem::path passes = scene::passes_folder(show, "front");
    std::ofstream(passes / "manifest.json") << "{\"version\": 1";
    EXPECT_EQ(baked(bake_or_fail(show)).size(), 3u);
    EXPECT_TRUE(contents(folder.path) == before);
    const auto manifest = scene::read_manifest(passes);
    ASSERT_TRUE(manifest.ok());
    std::filesystem::remove(passes / manifest->folder / (manifest->lights[1].picture + ".exr"));
    EXPECT_EQ(baked(bake_or_fail(show)), (Names{"front/Lamp 2"}));
    EXPECT_TRUE(contents(folder.path) == before);
}

// Keys of another making: nothing of the show changed, and all is made again.
TEST(ShowBake, PassesOfAnEarlierVersionAreMadeAgainOnceAndThatIsSaid) {
    const TestFolder folder;
    const scene::Show show = small_show(folder.path, 2);
    bake_or_fail(show);
    const auto before = contents(folder.path);
    const std::filesystem::path passes = scene::passes_folder(show, "front");
    auto manifest = scene::read_manifest(passes);
    ASSERT_TRUE(manifest.ok());
    manifest->geometry_key = manifest->layout_key = std::string(32, '0');
    std::string text = scene::manifest_text(*manifest);
    const std::string version = "\"version\": 2";
    ASSERT_NE(text.find(version), std::string::npos);
    text.replace(text.find(version), version.size(), "\"version\": 1");
    std::ofstream(passes / "manifest.json") << text;
    EXPECT_EQ(scene::read_manifest(passes)->version, 1);
    for (const std::size_t messages : {1u, 0u}) {
        Report report;
        const auto stats = bake_show(show, {}, report);
        ASSERT_TRUE(stats.ok()) << stats.error().text();
        EXPECT_EQ(baked(*stats).size(), 3 * messages);
        ASSERT_EQ(report.messages.size(), messages);
        for (const Message& message : report.messages) {
            EXPECT_EQ(message.severity, Severity::warning); // notes are not printed
            EXPECT_EQ(message.where, passes.string());
            EXPECT_EQ(message.what,
                      "these passes are of an earlier version of Ghostlight; they are made again, once");
        }
    }
    EXPECT_TRUE(contents(folder.path) == before);
    text.replace(text.find("\"version\": 1"), version.size(), "\"version\": 3");
    EXPECT_EQ(scene::parse_manifest(text, "x").error().text(),
              "x: has version 3, this program reads up to 2; run `ghostlight bake` again");
}

// As if another kind of processor had traced the pictures that are there.
TEST(ShowBake, FragmentsThatDoNotFitAreTracedAnew) {
    const TestFolder folder;
    const scene::Show show = small_show(folder.path, 2);
    bake_or_fail(show);
    const auto before = contents(folder.path);
    const std::filesystem::path passes = scene::passes_folder(show, "front");
    auto manifest = scene::read_manifest(passes);
    ASSERT_TRUE(manifest.ok());
    auto table = scene::read_fragments(passes / manifest->folder, *manifest);
    ASSERT_TRUE(table.ok());
    table->extra_first.assign(table->extra_first.size(), 0);
    table->fragments.resize(table->extra_first.size() - 1);
    ASSERT_TRUE(scene::write_fragments(passes / manifest->folder, *table).ok());
    manifest->extra_count = 0;
    // A picture that is there counts, named or not (tasks of a farm name none): this one has to be traced.
    ASSERT_TRUE(
        std::filesystem::remove(passes / manifest->folder / (manifest->lights.back().picture + ".exr")));
    manifest->lights.pop_back();
    std::ofstream(passes / "manifest.json") << scene::manifest_text(*manifest);
    EXPECT_EQ(baked(bake_or_fail(show)), (Names{"front/surroundings", "front/Lamp 1", "front/Lamp 2"}));
    EXPECT_TRUE(contents(folder.path) == before);
}

TEST(ShowBake, TrackBouncesAndForeignCameras) {
    const TestFolder folder;
    scene::Show show = small_show(folder.path, 1);
    show.fixtures[0].track = scene::Track{{{-2, 1, 3.2f}, {0, 1, 3.2f}, {2, 1, 3.2f}}, 1, 1};
    show.cameras.push_back(edgy_camera(8, 8));
    show.cameras[1].name = "elsewhere";
    show.cameras[1].foreign_passes = "passes.toml";
    BakeOptions options;
    options.bounces = 1;
    const BakeStats stats = bake_or_fail(show, options);
    EXPECT_EQ(baked(stats),
              (Names{"front/surroundings", "front/Lamp 1", "front/Lamp 1 stop 1", "front/Lamp 1 stop 2"}));
    Report report;
    const auto passes = scene::load_passes(scene::passes_folder(show, "front"), true, report);
    ASSERT_TRUE(passes.ok());
    const int last = passes->find("Lamp 1", 2);
    ASSERT_GE(last, 0);
    const scene::LightPass& pass = passes->lights[static_cast<std::size_t>(last)];
    EXPECT_EQ(pass.position_m, glm::vec3(2, 1, 3.2f));
    EXPECT_EQ(pass.radiance.size(), 4 * passes->fragment_count());
    EXPECT_EQ(pass.indirect.size(), 4 * passes->pixel_count());
    EXPECT_EQ(passes->find("Lamp 1", 3), -1);
    // Without bounces they are other pictures.
    EXPECT_EQ(baked(bake_or_fail(show)).size(), 3u);
}

} // namespace
} // namespace ghost::bake
