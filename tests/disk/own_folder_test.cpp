// SPDX-License-Identifier: Apache-2.0
#include "disk/own_folder.h"

#include "disk/files.h"
#include "disk/leftovers.h"
#include "support/make_link.h"

#include <fstream>
#include <gtest/gtest.h>

namespace ghost {
namespace {

namespace fs = std::filesystem;

// A show's folder, and somebody else's beside it.
class OwnFolders : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(root_);
        fs::create_directories(show_);
        fs::create_directories(other_ / "passes" / "front");
    }
    void TearDown() override { fs::remove_all(root_); }

    fs::path root_ = fs::path(testing::TempDir()) / "ghost_own_folder", show_ = root_ / "show",
             other_ = root_ / "other";
};

TEST_F(OwnFolders, are_made_below_the_show_and_hold_files_and_folders) {
    ASSERT_TRUE(make_folders(show_ / ".ghost" / "passes", show_).ok());
    std::ofstream(show_ / ".ghost" / "draft.toml") << "x";
    if (!make_link(other_, show_ / ".ghost" / "link")) GTEST_SKIP() << kNoLinks;
    const auto ghost = OwnFolder::open(show_ / ".ghost", show_);
    ASSERT_TRUE(ghost.ok());
    const OwnFolder::Entries entries = ghost->entries();
    ASSERT_EQ(entries.files.size(), 1u);
    EXPECT_EQ(entries.files[0].name, "draft.toml");
    EXPECT_EQ(entries.folders, std::vector<std::string>{"passes"});
    EXPECT_EQ(ghost->entries().files.size(), 1u); // once more
    EXPECT_TRUE(ghost->remove_file("draft.toml"));
    EXPECT_TRUE(ghost->remove_empty_folder("passes"));
    EXPECT_FALSE(fs::exists(show_ / ".ghost" / "passes"));
}

TEST_F(OwnFolders, are_reached_through_no_link_at_any_step) {
    const fs::path wanted = show_ / ".ghost" / "passes" / "front";
    for (const fs::path& step : {show_ / ".ghost", show_ / ".ghost" / "passes", wanted}) {
        fs::remove_all(show_ / ".ghost");
        fs::create_directories(step.parent_path());
        if (!make_link(other_, step)) GTEST_SKIP() << kNoLinks;
        const Result<void> made = make_folders(wanted, show_);
        ASSERT_FALSE(made.ok()) << step;
        EXPECT_EQ(made.error().where, step.string());
        EXPECT_NE(made.error().what.find("is a link"), std::string::npos) << made.error().text();
    }
    EXPECT_FALSE(OwnFolder::open(show_ / ".." / "other", show_).ok());
    if (!make_link(show_, root_ / "here")) GTEST_SKIP() << kNoLinks; // the show's own folder may be one
    EXPECT_FALSE(OwnFolder::open(root_ / "here" / "none", root_ / "here").ok());
    fs::remove(wanted);
    EXPECT_TRUE(make_folders(root_ / "here" / ".ghost" / "passes" / "front", root_ / "here").ok());
}

TEST_F(OwnFolders, leftovers_behind_a_link_stay) {
    const fs::path left = other_ / ".show.part999999999_0.toml";
    std::ofstream(left) << "x";
    fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::minutes(5));
    if (!make_link(other_, show_ / ".ghost")) GTEST_SKIP() << kNoLinks;
    EXPECT_EQ(remove_leftovers(show_ / ".ghost", show_, Below::included), 0u);
    EXPECT_TRUE(fs::exists(left));
}

} // namespace
} // namespace ghost
