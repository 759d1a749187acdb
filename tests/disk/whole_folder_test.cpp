// SPDX-License-Identifier: Apache-2.0
// A folder is put into its place whole, or not at all.
#include "disk/whole_folder.h"

#include "disk/files.h"
#include "support/make_link.h"
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
        WholeFolder folder = must(WholeFolder::open(out.string() + "/", "cue book"));
        ASSERT_TRUE(folder.make_folder("pictures/small").ok());
        write(folder.written_to() / "book.json", "1");
        EXPECT_FALSE(fs::exists(out));
        ASSERT_TRUE(folder.commit().ok());
    }
    EXPECT_TRUE(fs::exists(out / "book.json"));
    EXPECT_TRUE(fs::is_directory(out / "pictures/small"));
    EXPECT_EQ(entries_of(home.path), 1u);
}

void make(const fs::path& out, const std::string& kind, const std::string& text) {
    WholeFolder folder = must(WholeFolder::open(out, kind));
    ASSERT_TRUE(folder.make_folder("pictures").ok());
    write(folder.written_to() / "book.json", text);
    write(folder.written_to() / "pictures/1.png", text);
    ASSERT_TRUE(folder.commit().ok());
}

TEST(WholeFolder, replaces_one_of_its_own_and_nothing_else) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    make(out, "cue book", "1");
    make(out, "cue book", "2");
    EXPECT_EQ(must(read_text_file(out / "book.json", 10)), "2");
    EXPECT_EQ(must(read_text_file(out / ".ghostlight", 100)),
              "Ghostlight cue book\n1ad5be0d book.json\n1ad5be0d pictures/1.png\n");
    EXPECT_EQ(entries_of(home.path), 1u);
    EXPECT_FALSE(WholeFolder::open(out, "tour").ok()) << "another kind";
    for (const char* own : {"thesis.txt", "pictures/holiday.jpg"}) {
        write(out / own, "x");
        const auto refused = WholeFolder::open(out, "cue book");
        ASSERT_FALSE(refused.ok()) << own;
        EXPECT_NE(refused.error().what.find(own), std::string::npos) << refused.error().what;
        fs::remove(out / own);
    }
    if (!make_link("/etc/hosts", out / "link")) GTEST_SKIP() << kNoLinks;
    EXPECT_FALSE(WholeFolder::open(out, "cue book").ok());
    write(home.path / "file", "x");
    EXPECT_FALSE(WholeFolder::open(home.path / "file", "cue book").ok());
    EXPECT_FALSE(WholeFolder::open(home.path / "nowhere/book", "cue book").ok());
    EXPECT_FALSE(WholeFolder::open("/", "cue book").ok());
}

TEST(WholeFolder, never_replaces_a_folder_with_a_file_of_the_same_name) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    fs::create_directory(out);
    EXPECT_TRUE(WholeFolder::open(out, "cue book").ok()) << "an empty one is anybody's";
    write(out / "book.json", "{}");
    EXPECT_FALSE(WholeFolder::open(out, "cue book").ok());
    for (const char* list :
         {"", "Ghostlight tour\nbook.json\n", "Ghostlight cue book", "Ghostlight cue book\n"}) {
        write(out / ".ghostlight", list);
        EXPECT_FALSE(WholeFolder::open(out, "cue book").ok()) << list;
    }
    EXPECT_EQ(must(read_text_file(out / "book.json", 10)), "{}");
}

TEST(WholeFolder, leaves_what_somebody_changed) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    make(out, "cue book", "1");
    const auto refusal = [&] {
        const auto folder = WholeFolder::open(out, "cue book");
        return folder.ok() ? "" : folder.error().what;
    };
    write(out / "pictures/1.png", "2"); // as long as before
    EXPECT_EQ(refusal(),
              "has 'pictures/1.png', which somebody changed: it is not replaced before that is elsewhere");
    fs::remove(out / "pictures/1.png");
    EXPECT_EQ(refusal(), "") << "what is gone cannot be lost";
    if (!make_link(out / "book.json", out / "pictures/1.png")) GTEST_SKIP() << kNoLinks;
    EXPECT_NE(refusal(), "") << "it is a file no more";
    fs::remove(out / "pictures/1.png");
    {
        WholeFolder folder = must(WholeFolder::open(out, "cue book"));
        write(folder.written_to() / "book.json", "2");
        write(out / "book.json", "with a remark");
        EXPECT_FALSE(folder.commit().ok()) << "meanwhile";
    }
    EXPECT_EQ(must(read_text_file(out / "book.json", 20)), "with a remark");
    write(out / ".ghostlight", "Ghostlight cue book\nbook.json\npictures/1.png\n");
    EXPECT_EQ(refusal(), "") << "lists of older versions have no sums";
}

TEST(WholeFolder, leaves_what_somebody_put_there_meanwhile) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    for (const bool was_there : {false, true}) {
        if (was_there) make(out, "cue book", "1");
        WholeFolder folder = must(WholeFolder::open(out, "cue book"));
        write(folder.written_to() / "book.json", "2");
        fs::create_directories(out);
        write(out / "thesis.txt", "mine");
        const Result<void> refused = folder.commit();
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().what.find("thesis.txt"), std::string::npos) << refused.error().what;
        EXPECT_EQ(refused.error().where, out.string());
        EXPECT_EQ(must(read_text_file(out / "thesis.txt", 10)), "mine");
        EXPECT_EQ(fs::exists(out / "book.json"), was_there);
        { const WholeFolder gone = std::move(folder); }
        EXPECT_EQ(entries_of(home.path), 1u) << "what we made goes";
        fs::remove_all(out);
    }
    WholeFolder folder = must(WholeFolder::open(out, "cue book"));
    write(out, "a file");
    EXPECT_FALSE(folder.commit().ok());
    EXPECT_EQ(must(read_text_file(out, 10)), "a file");
}

TEST(WholeFolder, leaves_folders_of_somebody_else) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    fs::create_directories(out / "Photos/2026");
    EXPECT_FALSE(WholeFolder::open(out, "cue book").ok());
    EXPECT_TRUE(fs::exists(out / "Photos/2026"));
    fs::remove_all(out);
    {
        WholeFolder folder = must(WholeFolder::open(out, "cue book"));
        ASSERT_TRUE(folder.make_folder("old").ok());
        ASSERT_TRUE(folder.make_folder("pictures").ok());
        write(folder.written_to() / "pictures/1.png", "1");
        ASSERT_TRUE(folder.commit().ok());
    }
    fs::remove(out / "pictures/1.png");
    EXPECT_TRUE(WholeFolder::open(out, "cue book").ok()) << "empty ones of ours";
    fs::create_directory(out / "mine");
    EXPECT_FALSE(WholeFolder::open(out, "cue book").ok());
}

TEST(WholeFolder, replaces_none_whose_list_is_above_64_MiB) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    make(out, "cue book", "1");
    fs::resize_file(out / ".ghostlight", (std::uintmax_t{64} << 20) + 1);
    EXPECT_FALSE(WholeFolder::open(out, "cue book").ok());
    EXPECT_TRUE(fs::exists(out / "book.json"));
}

TEST(WholeFolder, leaves_what_was_there_when_it_is_given_up) {
    const TestFolder home;
    const fs::path out = home.path / "book";
    make(out, "cue book", "1");
    {
        const WholeFolder folder = must(WholeFolder::open(out, "cue book"));
        write(folder.written_to() / "book.json", "2");
    }
    EXPECT_EQ(must(read_text_file(out / "book.json", 10)), "1");
    EXPECT_EQ(entries_of(home.path), 1u);
}

TEST(WholeFolder, takes_away_what_a_killed_program_left) {
    const TestFolder home;
    fs::create_directories(home.path / ".book.part999999999_1/pictures");
    fs::create_directories(home.path / ".other.part999999999_1");
    const WholeFolder folder = must(WholeFolder::open(home.path / "book", "cue book"));
    EXPECT_FALSE(fs::exists(home.path / ".book.part999999999_1"));
    EXPECT_TRUE(fs::exists(home.path / ".other.part999999999_1"));
}

} // namespace
} // namespace ghost
