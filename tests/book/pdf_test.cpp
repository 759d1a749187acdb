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

Result<std::string> of_book(const Book& book, const std::filesystem::path& folder,
                            PaperSize size = PaperSize::a4, BookLayout layout = BookLayout::list) {
    Report report;
    Result<std::string> pdf = pdf_of(book, nullptr, folder, size, report, {}, layout);
    for (const Message& message : report.messages) // which fonts a machine has is its own
        EXPECT_NE(message.what.find("no font"), std::string::npos) << message.what;
    return pdf;
}

Result<std::string> of_paper(const Paper& paper) {
    Report report;
    Result<std::string> pdf = pdf_of(paper, PaperSize::letter, report);
    EXPECT_TRUE(report.messages.empty());
    return pdf;
}

// Not counted where cairo packs what lists them (1.18).
void expect_pages(const std::string& pdf, int pages) {
    if (pdf.find("/ObjStm") != std::string::npos) return;
    EXPECT_NE(pdf.find("/Count " + std::to_string(pages)), std::string::npos);
}

TEST(BookPdf, has_four_entries_on_a_page_and_equal_bytes) {
    const TestFolder folder;
    const Book book = book_of_pictures(folder, 5);
    const std::string pdf = must(of_book(book, folder.path));
    expect_whole(pdf);
    expect_pages(pdf, 2);
    EXPECT_NE(pdf.find("/DCTDecode"), std::string::npos);
    EXPECT_EQ(must(of_book(book, folder.path)), pdf);
    EXPECT_NE(must(of_book(book, folder.path, PaperSize::letter)), pdf);
}

TEST(BookPdf, as_a_grid_has_twelve_entries_on_a_page) {
    const TestFolder folder;
    Book book = book_of_pictures(folder, 13);
    const std::string pdf = must(of_book(book, folder.path, PaperSize::a4, BookLayout::grid));
    expect_whole(pdf);
    expect_pages(pdf, 2);
    EXPECT_EQ(must(of_book(book, folder.path, PaperSize::a4, BookLayout::grid)), pdf);
    book.entries[0].pictures.clear();
    book.entries[1].name = std::string(10'000, 'x');
    book.entries[2].unknown.assign(100, "not known");
    expect_whole(must(of_book(book, folder.path, PaperSize::a4, BookLayout::grid)));
}

TEST(BookPdf, begins_with_what_changed) {
    const TestFolder folder;
    const Book book = book_of_pictures(folder, 5);
    BookDifference difference;
    difference.old_name = "Demo of yesterday";
    const auto pdf_since = [&] {
        Report report;
        return must(pdf_of(book, &difference, folder.path, PaperSize::a4, report));
    };
    expect_pages(pdf_since(), 3);
    difference.entries.assign(100, "'Cue 1' is new");
    difference.fixtures = {std::string(100'000, 'x'), "Spot 1 is gone"};
    difference.pictures.push_back({"Cue 1", "house", "", "", "", {}, "the older book has none"});
    const std::string pdf = pdf_since();
    expect_whole(pdf);
    expect_pages(pdf, 2 + 4); // entries on two, a name as long as a page, the rest
    EXPECT_EQ(pdf_since(), pdf);
}

TEST(BookPdf, of_names_of_any_script_and_length_is_made) {
    const TestFolder folder;
    Book book = book_of_pictures(folder, 2);
    book.entries[0].name = std::string(10'000, 'x');
    book.entries[0].notes = std::string(10'000, '\xff');
    book.entries[1].name = "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \xe7\x81\xaf\n\x01";
    book.entries[1].changes.assign(500, {{"Spot"}, std::string(500, 'w')});
    book.entries[1].unknown.assign(100, "not known");
    expect_whole(must(of_book(book, folder.path)));
    expect_whole(must(of_book(Book{}, folder.path)));
}

TEST(BookPdf, without_a_picture_is_an_error_that_names_it) {
    const TestFolder folder;
    const Book book = book_of_pictures(folder, 1);
    std::filesystem::remove(folder.path / "pictures/0.png");
    const auto pdf = of_book(book, folder.path);
    ASSERT_FALSE(pdf.ok());
    EXPECT_NE(pdf.error().where.find("0.png"), std::string::npos);
}

TEST(PaperPdf, breaks_tables_over_pages) {
    Paper paper{"Demo",
                {{"x", "Long", {{"name"}, {"z m", true}}, {}, {"one thing"}}, {"y", "Empty", {}, {}, {}}},
                {}};
    for (int i = 0; i < 100; ++i)
        paper.tables[0].rows.push_back({{"Spot " + std::to_string(i), "6.26"}, i % 2 == 0});
    const std::string pdf = must(of_paper(paper));
    expect_whole(pdf);
    expect_pages(pdf, 4);
    EXPECT_EQ(must(of_paper(paper)), pdf);
}

// Of a plane for private use: no font has it.
const std::string kLetterOfNoFont = "\xf4\x80\x80\x81";

TEST(BookPdf, says_letters_that_no_font_has) {
    const TestFolder folder;
    Book book = book_of_pictures(folder, 2);
    book.entries[1].notes = "Stand by " + kLetterOfNoFont;
    Report report;
    const std::string said = must(pdf_of(book, nullptr, folder.path, PaperSize::a4, report));
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(report.messages[0].what,
              "Letters that no font of this machine has are printed as boxes, as in 'Stand by " +
                  kLetterOfNoFont + "'");
    book.entries[1].notes += std::string(200, 'x');
    Report longer;
    must(pdf_of(book, nullptr, folder.path, PaperSize::a4, longer));
    ASSERT_EQ(longer.messages.size(), 1u);
    EXPECT_LT(longer.messages[0].what.size(), 140u) << "a name of any length is quoted";
}

TEST(PaperPdf, says_letters_that_no_font_has) {
    const Paper paper{"Demo", {{"x", "Long", {{"name"}}, {{{kLetterOfNoFont}}}, {}}}, {Language::german}};
    Report report;
    must(pdf_of(paper, PaperSize::a4, report));
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_TRUE(report.messages[0].what.starts_with("Buchstaben, die keine Schrift"));
}

TEST(PaperPdf, breaks_a_table_with_more_remarks_than_a_page_holds) {
    Paper paper{"Demo", {{"x", "Long", {{"name"}}, {}, std::vector<std::string>(500, "not known")}}, {}};
    for (int i = 0; i < 50; ++i) paper.tables[0].rows.push_back({{"Spot"}});
    expect_pages(must(of_paper(paper)), 2);
}

} // namespace
} // namespace ghost::scene
