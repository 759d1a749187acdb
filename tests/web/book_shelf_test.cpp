// SPDX-License-Identifier: Apache-2.0
#include "web/private/book_shelf.h"

#include "book/book_json.h"
#include "disk/files.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <chrono>

namespace ghost::web {
namespace {

class Shelf : public ::testing::Test {
protected:
    void put(const std::string& file, const std::string& text) {
        std::filesystem::create_directories((folder.path / file).parent_path());
        ASSERT_TRUE(write_file_atomic(folder.path / file, text).ok());
    }
    void put_book() {
        scene::Book book;
        book.show = "tour";
        scene::BookEntry entry;
        entry.name = "Verse";
        entry.pictures = {{"house", "pictures/0001-1.png"}};
        book.entries.push_back(entry);
        put("book.json", scene::text_of(book));
        put("pictures/0001-1.png", "first");
        put("pictures/0002-1.png", "of no entry");
        put("secret.txt", "secret");
    }

    TestFolder folder;
    BookShelf shelf{folder.path};
};

TEST_F(Shelf, has_what_the_book_names_and_nothing_else) {
    put_book();
    ASSERT_TRUE(shelf.file("book.json").ok());
    EXPECT_EQ(shelf.file("book.json")->type, "application/json");
    ASSERT_TRUE(shelf.file("pictures/0001-1.png").ok());
    EXPECT_EQ(*shelf.file("pictures/0001-1.png")->bytes, "first");
    for (const char* name : {"", "secret.txt", "pictures/0002-1.png", "pictures/../secret.txt",
                             "../book.json", "/etc/passwd", "pictures/", "pictures/0001-1.png/"})
        EXPECT_FALSE(shelf.file(name).ok()) << name;
    ASSERT_TRUE(shelf.file("difference.json").ok());
    EXPECT_EQ(*shelf.file("difference.json")->bytes, "null") << "it was compared with none";
    EXPECT_EQ(shelf.file("book.json")->bytes, shelf.file("book.json")->bytes) << "one for all who read it";
}

TEST_F(Shelf, a_link_in_the_place_of_a_picture_is_not_followed) {
    put_book();
    std::filesystem::remove(folder.path / "pictures/0001-1.png");
    std::filesystem::create_symlink(folder.path / "secret.txt", folder.path / "pictures/0001-1.png");
    EXPECT_FALSE(shelf.file("pictures/0001-1.png").ok());
}

TEST_F(Shelf, a_difference_brings_its_pictures) {
    put_book();
    scene::BookDifference difference;
    difference.old_name = "yesterday";
    scene::ComparedPicture picture;
    picture.file = "pictures/0001-1.png";
    picture.old_file = "old/0001-1.png";
    picture.map_file = "differences/0001-1.png";
    difference.pictures.push_back(picture);
    put("difference.json", scene::text_of(difference));
    put("old/0001-1.png", "before");
    EXPECT_TRUE(shelf.file("difference.json").ok());
    ASSERT_TRUE(shelf.file("old/0001-1.png").ok());
    EXPECT_EQ(*shelf.file("old/0001-1.png")->bytes, "before");
    EXPECT_FALSE(shelf.file("differences/0001-1.png").ok()) << "it is not there";
}

TEST_F(Shelf, what_is_no_book_is_said) {
    EXPECT_FALSE(shelf.file("book.json").ok()) << "not made yet";
    put("book.json", "{]");
    EXPECT_FALSE(shelf.file("book.json").ok());
    put_book();
    EXPECT_TRUE(shelf.file("book.json").ok()) << "it was made meanwhile";
    put("difference.json", R"({"ghostlight_difference":1,"pictures":[{"file":"../../etc/passwd"}]})");
    EXPECT_TRUE(shelf.file("book.json").ok()) << "what was compared is damaged, not the book";
    ASSERT_FALSE(shelf.file("difference.json").ok());
    EXPECT_EQ(shelf.file("difference.json").error().what, "is damaged: key 'old_name' not found");
    EXPECT_TRUE(shelf.file("pictures/0001-1.png").ok());
}

TEST_F(Shelf, a_damaged_book_is_read_again_when_it_is_another_one) {
    put_book();
    const std::string good = *read_text_file(folder.path / "book.json", kMostShelfBytes);
    const std::string bad(good.size(), '{');
    put("book.json", bad);
    const auto written = std::filesystem::last_write_time(folder.path / "book.json");
    const auto first = shelf.file("book.json");
    ASSERT_FALSE(first.ok());
    // The same time and size: nothing is read, so what is there now cannot be known.
    put("book.json", good);
    std::filesystem::last_write_time(folder.path / "book.json", written);
    const auto second = shelf.file("book.json");
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().what, first.error().what);
    std::filesystem::last_write_time(folder.path / "book.json", written + std::chrono::seconds(1));
    EXPECT_TRUE(shelf.file("book.json").ok());
}

TEST_F(Shelf, a_book_that_is_a_link_is_not_followed) {
    put_book();
    const std::filesystem::path elsewhere = folder.path / "elsewhere.json";
    for (const char* const name : {"book.json", "difference.json"}) {
        put("difference.json", scene::text_of(scene::BookDifference{}));
        std::filesystem::rename(folder.path / name, elsewhere);
        std::filesystem::create_symlink(elsewhere, folder.path / name);
        const auto file = shelf.file(name);
        ASSERT_FALSE(file.ok()) << name;
        EXPECT_NE(file.error().what.find("is not followed"), std::string::npos) << file.error().what;
        std::filesystem::remove(folder.path / name);
        std::filesystem::rename(elsewhere, folder.path / name);
        EXPECT_TRUE(shelf.file(name).ok()) << name;
    }
}

TEST_F(Shelf, what_is_too_large_is_not_read) {
    put_book();
    std::filesystem::resize_file(folder.path / "pictures/0001-1.png", kMostBookPictureBytes + 1);
    EXPECT_FALSE(shelf.file("pictures/0001-1.png").ok());
    std::filesystem::resize_file(folder.path / "book.json", kMostShelfBytes + 1);
    EXPECT_FALSE(shelf.file("book.json").ok());
}

TEST(BookShelfWithout, a_folder_says_so_as_an_answer) {
    BookShelf shelf{std::filesystem::path()};
    const auto book = shelf.file("book.json");
    ASSERT_TRUE(book.ok());
    EXPECT_TRUE(book->bytes->starts_with("{\"none\":\"no cue book is given")) << *book->bytes;
    EXPECT_FALSE(shelf.file("difference.json").ok());
}

} // namespace
} // namespace ghost::web
