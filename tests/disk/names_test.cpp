// SPDX-License-Identifier: Apache-2.0
// Names in UTF-8, on systems too that have them otherwise.
#include "disk/disk_sync.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "support/test_folder.h"

#include <cstdio>
#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(Names, of_any_letters_are_written_read_listed_and_removed) {
    const TestFolder folder;
    const std::string name = "Bühne \xe2\x82\xac \xf0\x9f\x94\xa6.toml";
    ASSERT_TRUE(write_file_atomic(folder.path / name, std::string_view("one")).ok());
    ASSERT_TRUE(write_file_atomic(folder.path / name, std::string_view("two")).ok());
    const auto text = read_text_file(folder.path / name, 100);
    ASSERT_TRUE(text.ok()) << text.error().text();
    EXPECT_EQ(*text, "two");
    const auto opened = OwnFolder::open(folder.path, folder.path);
    ASSERT_TRUE(opened.ok()) << opened.error().text();
    const OwnFolder::Entries entries = opened->entries();
    ASSERT_EQ(entries.files.size(), 1u);
    EXPECT_EQ(entries.files[0].name, name);
    EXPECT_TRUE(opened->remove_file(name));
    EXPECT_TRUE(opened->entries().files.empty());
}

TEST(Names, of_a_file_that_is_being_written_may_change) {
    const TestFolder folder;
    std::FILE* const file = open_stream(folder.path / "a.part", "ab");
    ASSERT_NE(file, nullptr);
    EXPECT_TRUE(lock_file(file));
    std::FILE* const other = open_stream(folder.path / "a.part", "ab");
    ASSERT_NE(other, nullptr);
    EXPECT_FALSE(lock_file(other));
    std::fclose(other);
    std::fputs("one\n", file);
    std::filesystem::rename(folder.path / "a.part", folder.path / "a");
    std::fputs("two\n", file);
    EXPECT_TRUE(std::fflush(file) == 0 && sync_to_disk(file));
    std::fclose(file);
    const auto text = read_text_file(folder.path / "a", 100);
    ASSERT_TRUE(text.ok()) << text.error().text();
    EXPECT_EQ(*text, "one\ntwo\n");
    EXPECT_EQ(open_stream(folder.path / "none" / "b", "ab"), nullptr);
}

} // namespace
} // namespace ghost
