// SPDX-License-Identifier: Apache-2.0
// Book and paperwork as PDF: whole, equal bytes each time, whatever names hold.
#include "book/pdf.h"

#include "image/ldr.h"
#include "support/must.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

void expect_whole(const std::string& pdf) {
    EXPECT_TRUE(pdf.starts_with("%PDF-1."));
    EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
}

Book book_of_pictures(const TestFolder& folder, std::size_t entries) {
    std::filesystem::create_directory(folder.path / "pictures");
    image::Image8 picture(64, 36, 4);
    for (std::size_t i = 0; i < picture.samples.size(); ++i)
        picture.samples[i] = static_cast<std::uint8_t>(i * 7);
    Book book;
    book.show = "Demo";
    book.width = 64;
    book.height = 36;
    for (std::size_t i = 0; i < entries; ++i) {
        const std::string file = "pictures/" + std::to_string(i) + ".png";
        EXPECT_TRUE(image::write_png(folder.path / file, picture).ok());
        BookEntry& entry = book.entries.emplace_back();
        entry.name = "Cue " + std::to_string(i);
        entry.pictures = {{"house", file}, {"close", file}, {"high", file}};
        entry.changes = {{{"Spot 1"}, "0 to 80 %"}};
    }
    return book;
}

// Not counted where cairo packs what lists them (1.18).
void expect_pages(const std::string& pdf, int pages) {
    if (pdf.find("/ObjStm") != std::string::npos) return;
    EXPECT_NE(pdf.find("/Count " + std::to_string(pages)), std::string::npos);
}

TEST(BookPdf, has_four_entries_on_a_page_and_equal_bytes) {
    const TestFolder folder;
    const Book book = book_of_pictures(folder, 5);
    const std::string pdf = must(pdf_of(book, folder.path, PaperSize::a4));
    expect_whole(pdf);
    expect_pages(pdf, 2);
    EXPECT_NE(pdf.find("/DCTDecode"), std::string::npos);
    EXPECT_EQ(must(pdf_of(book, folder.path, PaperSize::a4)), pdf);
    EXPECT_NE(must(pdf_of(book, folder.path, PaperSize::letter)), pdf);
}

TEST(BookPdf, as_a_grid_has_twelve_entries_on_a_page) {
    const TestFolder folder;
    Book book = book_of_pictures(folder, 13);
    const std::string pdf = must(pdf_of(book, folder.path, PaperSize::a4, {}, BookLayout::grid));
    expect_whole(pdf);
    expect_pages(pdf, 2);
    EXPECT_EQ(must(pdf_of(book, folder.path, PaperSize::a4, {}, BookLayout::grid)), pdf);
    book.entries[0].pictures.clear();
    book.entries[1].name = std::string(10'000, 'x');
    book.entries[2].unknown.assign(100, "not known");
    expect_whole(must(pdf_of(book, folder.path, PaperSize::a4, {}, BookLayout::grid)));
}

TEST(BookPdf, of_names_of_any_script_and_length_is_made) {
    const TestFolder folder;
    Book book = book_of_pictures(folder, 2);
    book.entries[0].name = std::string(10'000, 'x');
    book.entries[0].notes = std::string(10'000, '\xff');
    book.entries[1].name = "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \xe7\x81\xaf\n\x01";
    book.entries[1].changes.assign(500, {{"Spot"}, std::string(500, 'w')});
    book.entries[1].unknown.assign(100, "not known");
    expect_whole(must(pdf_of(book, folder.path, PaperSize::a4)));
    expect_whole(must(pdf_of(Book{}, folder.path, PaperSize::a4)));
}

TEST(BookPdf, without_a_picture_is_an_error_that_names_it) {
    const TestFolder folder;
    const Book book = book_of_pictures(folder, 1);
    std::filesystem::remove(folder.path / "pictures/0.png");
    const auto pdf = pdf_of(book, folder.path, PaperSize::a4);
    ASSERT_FALSE(pdf.ok());
    EXPECT_NE(pdf.error().where.find("0.png"), std::string::npos);
}

TEST(PaperPdf, breaks_tables_over_pages) {
    Paper paper{"Demo",
                {{"x", "Long", {{"name"}, {"z m", true}}, {}, {"one thing"}}, {"y", "Empty", {}, {}, {}}},
                {}};
    for (int i = 0; i < 100; ++i)
        paper.tables[0].rows.push_back({{"Spot " + std::to_string(i), "6.26"}, i % 2 == 0});
    const std::string pdf = must(pdf_of(paper, PaperSize::letter));
    expect_whole(pdf);
    expect_pages(pdf, 4);
    EXPECT_EQ(must(pdf_of(paper, PaperSize::letter)), pdf);
}

} // namespace
} // namespace ghost::scene
