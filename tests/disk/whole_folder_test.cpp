// SPDX-License-Identifier: Apache-2.0
// A folder is put into its place whole, or not at all.
#include "disk/whole_folder.h"

#include "disk/files.h"
#include "support/must.h"
#include "support/test_folder.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

namespace ghost {
namespace {

namespace fs = std::filesystem;

std::size_t entries_of(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void write(const fs::path& file, const std::string& text) {
    ASSERT_TRUE(write_file_atomic(file, text).ok());
}

TEST(WholeFolder, is_there_when_it_is_committed) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    {
        WholeFolder folder = must(WholeFolder::open(out.string() + "/", "book.json"));
        ASSERT_TRUE(folder.make_folder("pictures/small").ok());
        write(folder.written_to() / "book.json", "1");
        EXPECT_FALSE(fs::exists(out));
        ASSERT_TRUE(folder.commit().ok());
    }
    EXPECT_TRUE(fs::exists(out / "book.json"));
    EXPECT_TRUE(fs::is_directory(out / "pictures/small"));
    EXPECT_EQ(entries_of(home.path), 1u);
}

TEST(WholeFolder, replaces_one_of_its_own_and_nothing_else) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    fs::create_directory(out);
    write(out / "holiday.jpg", "x");
    const auto foreign = WholeFolder::open(out, "book.json");
    ASSERT_FALSE(foreign.ok());
    EXPECT_NE(foreign.error().what.find("book.json"), std::string::npos);
    write(out / "book.json", "1");
    {
        WholeFolder folder = must(WholeFolder::open(out, "book.json"));
        write(folder.written_to() / "book.json", "2");
        ASSERT_TRUE(folder.commit().ok());
    }
    EXPECT_EQ(must(read_text_file(out / "book.json", 10)), "2");
    EXPECT_FALSE(fs::exists(out / "holiday.jpg"));
    EXPECT_EQ(entries_of(home.path), 1u);
    write(home.path / "file", "x");
    EXPECT_FALSE(WholeFolder::open(home.path / "file", "book.json").ok());
    EXPECT_FALSE(WholeFolder::open(home.path / "nowhere/book", "book.json").ok());
    EXPECT_FALSE(WholeFolder::open("/", "book.json").ok());
}

TEST(WholeFolder, leaves_what_was_there_when_it_is_given_up) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    fs::create_directory(out);
    write(out / "book.json", "1");
    {
        const WholeFolder folder = must(WholeFolder::open(out, "book.json"));
        write(folder.written_to() / "book.json", "2");
    }
    EXPECT_EQ(must(read_text_file(out / "book.json", 10)), "1");
    EXPECT_EQ(entries_of(home.path), 1u);
}

TEST(WholeFolder, takes_away_what_a_killed_program_left) {
    const TestFolder home;
    fs::create_directories(home.path / ".book.part999999999_1/pictures");
    fs::create_directories(home.path / ".other.part999999999_1");
    const WholeFolder folder = must(WholeFolder::open(home.path / "book", "book.json"));
    EXPECT_FALSE(fs::exists(home.path / ".book.part999999999_1"));
    EXPECT_TRUE(fs::exists(home.path / ".other.part999999999_1"));
}

} // namespace
} // namespace ghost
