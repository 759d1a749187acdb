// SPDX-License-Identifier: Apache-2.0
#include "disk/user_file.h"

#include "disk/files.h"
#include "support/make_link.h"

#include <gtest/gtest.h>

namespace ghost {
namespace {

namespace fs = std::filesystem;

class UserFile : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(root_);
        fs::create_directories(show_ / "files");
    }
    void TearDown() override { fs::remove_all(root_); }
    static std::string text_in(const fs::path& path) {
        const auto text = read_text_file(path, 1000);
        return text.ok() ? *text : text.error().text();
    }

    fs::path root_ = fs::path(testing::TempDir()) / "ghost_user_file", show_ = root_ / "show";
};

TEST_F(UserFile, a_link_in_the_folder_stays_one_and_permissions_stay) {
    const fs::path target = show_ / "files" / "tour.toml", link = show_ / "show.toml";
    ASSERT_TRUE(write_user_file(target, "old").ok());
    fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
    if (!make_link("files/tour.toml", link)) GTEST_SKIP() << kNoLinks;
    ASSERT_TRUE(write_user_file(link, "new").ok());
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(text_in(target), "new");
    EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(UserFile, a_link_that_leaves_the_folder_is_refused) {
    const fs::path target = root_ / "letter.txt", link = show_ / "show.toml";
    ASSERT_TRUE(write_file_atomic(target, std::string_view("dear")).ok());
    if (!make_link(target, link)) GTEST_SKIP() << kNoLinks;
    const Result<void> written = write_user_file(link, "new");
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().text().find("show.toml: is a link to "), std::string::npos)
        << written.error().text();
    EXPECT_EQ(text_in(target), "dear");
}

TEST_F(UserFile, files_keep_their_permissions_when_they_are_written_anew) {
#if defined(_WIN32)
    GTEST_SKIP() << "files of Windows have lists of who may, and no such bits";
#endif
    const fs::path file = show_ / "show.toml";
    ASSERT_TRUE(write_file_atomic(file, std::string_view("a")).ok());
    const fs::perms mine = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write;
    fs::permissions(file, mine);
    ASSERT_TRUE(write_file_atomic(file, std::string_view("b")).ok());
    EXPECT_EQ(fs::status(file).permissions(), mine);
    EXPECT_EQ(text_in(file), "b");
}

TEST_F(UserFile, what_is_new_replaces_nothing) {
    const fs::path temporary = show_ / ".new.part1_0.mvr", path = show_ / "tour.mvr";
    ASSERT_TRUE(write_file_atomic(temporary, std::string_view("new")).ok());
    ASSERT_TRUE(write_file_atomic(path, std::string_view("old")).ok());
    const auto second = commit_new(temporary, path);
    ASSERT_TRUE(second.ok());
    EXPECT_FALSE(*second);
    EXPECT_EQ(text_in(path), "old");
    const auto first = commit_new(temporary, show_ / "tour (2).mvr");
    ASSERT_TRUE(first.ok() && *first);
    EXPECT_EQ(text_in(show_ / "tour (2).mvr"), "new");
    EXPECT_FALSE(fs::exists(temporary));
    EXPECT_FALSE(commit_new(temporary, show_ / "none.mvr").ok());
}

} // namespace
} // namespace ghost
