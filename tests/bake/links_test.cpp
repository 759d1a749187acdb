// SPDX-License-Identifier: Apache-2.0
// A show folder from elsewhere, whose .ghost holds links: nothing behind them is written or removed.
#include "bake/distance_maps.h"
#include "passes/passes_file.h"
#include "support/test_show.h"

namespace ghost::bake {
namespace {

namespace fs = std::filesystem;

constexpr int kLinkedMapSize = 64;

scene::Show lit_show(const fs::path& folder) {
    scene::Show show;
    show.folder = folder;
    show.stage = edgy_stage();
    show.cameras = {edgy_camera(16, 9)};
    add_fixture(show, "Lamp", {0, 1, 3.2f});
    return show;
}

// Whatever the names may be that a cleaner looks for.
void fill(const fs::path& folder) {
    for (const char* const name : {"holiday.exr", "letter.txt", "stage.json", "manifest.json", "Lamp_0.exr",
                                   "0123456789ab/light_old_0.exr", "old/picture.exr"}) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << name;
    }
}

// Each folder on the way from the show's to `deepest` in turn is a link to somebody else's files.
template <class Run>
void expect_untouched(const std::string& deepest, const Run& run) {
    fs::path step;
    for (const fs::path& name : fs::path(deepest)) {
        step /= name;
        const TestFolder folder;
        const fs::path home = folder.path / "show", other = folder.path / "other";
        fs::create_directories((home / step).parent_path());
        fill(other);
        fs::path below = other; // as deep as the link leads
        for (const fs::path& rest : fs::path(deepest).lexically_relative(step)) fill(below /= rest);
        const auto before = contents(other);
        fs::create_directory_symlink(other, home / step);
        const std::string said = run(lit_show(home));
        EXPECT_TRUE(contents(other) == before) << step;
        EXPECT_NE(said.find((home / step).string() + ": is a link"), std::string::npos) << said;
    }
}

TEST(Links, CleaningDistanceMapsRemovesNothingBehindThem) {
    expect_untouched(".ghost/distances/64", [](const scene::Show& show) {
        DistanceMapOptions options;
        options.size = kLinkedMapSize;
        scene::DistanceMaps maps;
        Report report;
        EXPECT_TRUE(update_distance_maps(show, show.stage, options, maps, report).ok());
        EXPECT_EQ(maps.maps.size(), 1u); // drawn all the same
        std::string said;
        for (const Message& message : report.messages) said += message.where + ": " + message.what + "\n";
        return said;
    });
}

TEST(Links, CleaningPassesRemovesNothingBehindThem) {
    expect_untouched(".ghost/passes/front", [](const scene::Show& show) {
        Report report;
        const auto stats = bake_show(show, {}, report);
        return stats.ok() ? std::string() : stats.error().text();
    });
}

TEST(Links, OnlyWhatTheBakerWritesIsCleaned) {
    const TestFolder folder;
    scene::Show show = lit_show(folder.path / "show");
    fs::create_directories(show.folder);
    Report report;
    ASSERT_TRUE(bake_show(show, {}, report).ok());
    const fs::path passes = scene::passes_folder(show, "front"), other = folder.path / "other";
    fill(other);
    const auto before = contents(other);
    const auto manifest = scene::read_manifest(passes);
    ASSERT_TRUE(manifest.ok());
    fs::create_directory_symlink(other, passes / "abcdefabcdef");
    fs::create_symlink(other / "holiday.exr", passes / manifest->folder / "old.exr");
    fs::create_directories(passes / "notes");
    std::ofstream(passes / "notes" / "mine.txt") << "mine";
    std::ofstream(passes / manifest->folder / "mine.txt") << "mine";
    std::ofstream(passes / manifest->folder / "light_gone_0.exr") << "old";
    fs::create_directories(passes / "0123456789ab");
    std::ofstream(passes / "0123456789ab" / "ambient.exr") << "old";
    show.fixtures[0].position_m.x += 0.5f;
    ASSERT_TRUE(bake_show(show, {}, report).ok());
    EXPECT_TRUE(contents(other) == before);
    EXPECT_TRUE(fs::exists(passes / "notes" / "mine.txt"));
    EXPECT_TRUE(fs::exists(passes / manifest->folder / "mine.txt"));
    EXPECT_FALSE(fs::exists(passes / manifest->folder / "light_gone_0.exr"));
    EXPECT_FALSE(fs::exists(passes / "0123456789ab"));
}

} // namespace
} // namespace ghost::bake
