// SPDX-License-Identifier: Apache-2.0
#include "disk/leftovers.h"

#include "disk/files.h"

#include <chrono>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace ghost {
namespace {

namespace fs = std::filesystem;

class Leftovers : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(root_); }
    void TearDown() override { fs::remove_all(root_); }
    // minutes: since it was written.
    fs::path write(const std::string& name, int minutes) const {
        const fs::path path = root_ / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path) << "x";
        fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(minutes));
        return path;
    }
    fs::path root_ = fs::path(testing::TempDir()) / "ghost_leftovers";
};

constexpr const char* kGone = "999999999"; // no process has such a number

TEST_F(Leftovers, those_of_killed_programs_go_and_nothing_else_does) {
    const fs::path gone = write(std::string(".show.part") + kGone + "_0.toml", 5),
                   bare = write(std::string(".looks.part") + kGone + "_12", 5),
                   fresh = write(std::string(".fresh.part") + kGone + "_0.toml", 0),
                   elsewhere = write(std::string(".far.part") + kGone + "_4294967303.exr", 25 * 60),
                   at_work = write(std::string(".far.part") + kGone + "_4294967304.exr", 90),
                   below = write(std::string("sub/.a.part") + kGone + "_1.png", 5),
                   alive = temporary_beside(root_ / "mine.toml");
    std::vector<fs::path> others;
    for (const char* const name : {"show.toml", ".part", "tour.ghostdmx.part", ".a.partx_0", ".a.part12",
                                   ".a.part12_", "a.part999999999_0", ".a.part999999999_0x", ".git"})
        others.push_back(write(name, 5));
    write(alive.filename().string(), 5);
    EXPECT_EQ(remove_leftovers(root_, root_, Below::left_alone), 3u);
    EXPECT_FALSE(fs::exists(gone));
    EXPECT_FALSE(fs::exists(bare));
    EXPECT_FALSE(fs::exists(elsewhere)); // rested long enough
    EXPECT_TRUE(fs::exists(at_work));    // of a machine whose clock is an hour behind
    for (const fs::path& path : others) EXPECT_TRUE(fs::exists(path)) << path;
    EXPECT_TRUE(fs::exists(fresh));
    EXPECT_TRUE(fs::exists(alive));
    EXPECT_TRUE(fs::exists(below));
    EXPECT_EQ(remove_leftovers(root_, root_, Below::included), 1u);
    EXPECT_FALSE(fs::exists(below));
    EXPECT_EQ(remove_leftovers(root_ / "nowhere", root_, Below::included), 0u);
}

TEST_F(Leftovers, eight_folders_deep_and_no_deeper) {
    std::string folder;
    std::vector<fs::path> left;
    for (int level = 0; level < 11; ++level, folder += "sub/")
        left.push_back(write(folder + ".a.part" + kGone + "_1.png", 5));
    EXPECT_EQ(remove_leftovers(root_, root_, Below::included), 9u);
    for (std::size_t level = 0; level < left.size(); ++level)
        EXPECT_EQ(fs::exists(left[level]), level > 8) << level;
}

} // namespace
} // namespace ghost
