// SPDX-License-Identifier: Apache-2.0
// The plan of a book, its file and its page.
#include "book/book.h"

#include "book/book_html.h"
#include "book/book_json.h"
#include "book/book_plan.h"
#include "book/book_values.h"
#include "book/rests.h"
#include "show/limits.h"
#include "show/looks.h"
#include "show/show.h"
#include "support/must.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace ghost::scene {
namespace {

Show demo() {
    Show show;
    show.name = "Demo";
    show.file = "demo/show.toml";
    show.recording = "demo.ghostdmx";
    show.cameras = {{.name = "house"}, {.name = "close"}};
    return show;
}

Cue cue(const std::string& name, std::optional<double> at_s, const std::string& look = "",
        const std::string& camera = "") {
    Cue made;
    made.name = name;
    made.at_s = at_s;
    made.look = look;
    made.camera = camera;
    return made;
}

Book small_book() {
    Book book;
    book.show = "Demo <\"&'>";
    book.kind = "cues";
    book.width = 640;
    book.height = 360;
    book.ev100 = 5.5f;
    book.device = "device";
    book.unknown = {"one thing"};
    book.fixtures.push_back(
        {"Spot 1", "101", "uuid", "Maker Spot", "Standard", {{1, 2}, {3, 0}}, glm::vec3(1, 2.5f, 3), {}});
    BookEntry& entry = book.entries.emplace_back();
    entry.name = "Verse";
    entry.number = "47.5";
    entry.page = "12";
    entry.notes = "slowly";
    entry.look = "Blue";
    entry.at_s = 12.25;
    entry.goes_on = true;
    entry.fade_s = 2;
    entry.pictures = {{"house", "pictures/0001-1.png"}};
    entry.changes = {{{"Spot 1"}, "0 to 80 %"}};
    entry.unknown = {"another"};
    return book;
}

TEST(Plan, of_cues_goes_on_where_they_say_nothing) {
    Show show = demo();
    show.cues = {cue("a", {}), cue("b", 10.0, "", "close"), cue("c", {}, "Blue"), cue("d", 20.0),
                 cue("e", {}, "Red")};
    const std::vector<StoredLook> looks{{.name = "Blue", .fade_s = 3}};
    const auto plan = plan_book(show, looks, BookKind::by_itself, {});
    ASSERT_TRUE(plan.ok()) << plan.error().text();
    ASSERT_EQ(plan->entries.size(), 5u);
    EXPECT_EQ(plan->kind, "cues");
    EXPECT_FALSE(plan->entries[0].entry.at_s);
    EXPECT_EQ(plan->entries[0].entry.unknown.size(), 1u);
    EXPECT_EQ(plan->entries[1].camera, "close");
    EXPECT_EQ(plan->entries[2].entry.at_s, 10.0);
    EXPECT_TRUE(plan->entries[2].entry.goes_on);
    EXPECT_EQ(plan->entries[2].entry.fade_s, 3.0f);
    EXPECT_EQ(plan->entries[3].look, 0u); // what hands set stays
    EXPECT_EQ(plan->entries[3].camera, "close");
    EXPECT_EQ(plan->entries[4].look, 0u) << "as in the window, where such a cue recalls nothing";
    EXPECT_TRUE(plan->entries[4].is_other);
    EXPECT_EQ(plan->entries[4].entry.unknown.at(0), "the show has no look 'Red'");
}

TEST(Plan, of_cues_has_their_numbers_and_pages) {
    Show show = demo();
    show.cues = {cue("a", 1.0)};
    show.cues[0].number = "47.5";
    show.cues[0].page = "12";
    const auto plan = plan_book(show, {}, BookKind::cues, {});
    ASSERT_TRUE(plan.ok());
    EXPECT_EQ(plan->entries[0].entry.number, "47.5");
    EXPECT_EQ(plan->entries[0].entry.page, "12");
}

TEST(Plan, takes_what_the_show_has) {
    Show show = demo();
    const std::vector<StoredLook> looks{{.name = "Blue"}, {.name = "Red"}};
    EXPECT_EQ(plan_book(show, looks, BookKind::by_itself, {})->kind, "looks");
    EXPECT_EQ(plan_book(show, {}, BookKind::by_itself, {1.5, 72})->entries.at(1).entry.name,
              "at rest from 1:12");
    const auto bare = plan_book(show, {}, BookKind::by_itself, {});
    ASSERT_TRUE(bare.ok());
    EXPECT_EQ(bare->entries.size(), 1u);
    EXPECT_EQ(bare->unknown.size(), 1u);
    show.recording.clear();
    EXPECT_FALSE(plan_book(show, {}, BookKind::by_itself, {})->entries[0].entry.at_s);
}

TEST(Plan, of_what_is_not_there_is_an_error) {
    Show show = demo();
    for (const BookKind kind : {BookKind::cues, BookKind::looks, BookKind::found})
        EXPECT_FALSE(plan_book(show, {}, kind, {}).ok());
    EXPECT_EQ(plan_book(show, {}, BookKind::found, {}).error().where, "demo.ghostdmx");
    Show listed = show;
    listed.cues.assign(kMostEntries, cue("x", 1.0));
    EXPECT_TRUE(plan_book(listed, {}, BookKind::cues, {}).ok());
    listed.cues.push_back(cue("x", 1.0));
    EXPECT_EQ(plan_book(listed, {}, BookKind::cues, {}).error().text(),
              "demo/show.toml: a book of 10001 entries, at most 10000 are possible");
}

TEST(Plan, a_recording_that_rests_too_often_has_no_cues) {
    const Show show = demo();
    std::vector<double> found_s(kMostRests, 1.0);
    for (const BookKind kind : {BookKind::by_itself, BookKind::found}) {
        const auto plan = plan_book(show, {}, kind, found_s);
        ASSERT_TRUE(plan.ok()) << plan.error().text();
        EXPECT_EQ(plan->entries.size(), kMostRests);
    }
    found_s.push_back(1);
    for (const BookKind kind : {BookKind::by_itself, BookKind::found})
        EXPECT_EQ(plan_book(show, {}, kind, found_s).error().text(),
                  "demo.ghostdmx: comes to rest 1001 times, at most 1000 are taken as cues");
}

TEST(Rests, are_where_levels_stay) {
    const auto levels = [](std::uint8_t level) {
        dmx::Universes universes;
        dmx::Levels values{};
        values[0] = level;
        universes.at(1).levels = std::make_shared<const dmx::Levels>(values);
        return universes;
    };
    RestFinder finder;
    finder.feed(0, levels(0));
    for (int i = 0; i < 10; ++i) finder.feed(2 + 0.04 * i, levels(static_cast<std::uint8_t>(10 * i + 10)));
    finder.feed(5, levels(100));    // sent again
    finder.feed(8, levels(0));      // a flash
    finder.feed(8.04, levels(100)); // the same look once more
    finder.feed(11, levels(50));
    const auto found = finder.finish(11.5);
    ASSERT_EQ(found.size(), 2u); // the last one does not last
    EXPECT_EQ(found[0], 0);
    EXPECT_NEAR(found[1], 2.36, 1e-9);
    EXPECT_TRUE(RestFinder().finish(10).empty());
}

TEST(BookFile, comes_back_as_it_was) {
    const Book book = small_book();
    const std::string text = text_of(book);
    const auto read = book_from(text, "book.json");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(text_of(*read), text);
    EXPECT_EQ(read->entries, book.entries);
}

TEST(BookFile, has_no_place_of_a_fixture_that_has_none) {
    Book book = small_book();
    book.fixtures.resize(1);
    book.fixtures[0].position_m = std::nullopt;
    const std::string text = text_of(book);
    EXPECT_NE(text.find("\"position_m\": null"), std::string::npos) << text;
    EXPECT_FALSE(must(book_from(text, "x")).fixtures[0].position_m);
}

TEST(Values, are_those_of_lamps_that_shine) {
    Show show;
    show.fixtures.resize(3);
    for (PatchedFixture& fixture : show.fixtures) fixture.type = std::make_shared<fixture::Type>();
    show.fixtures[0].name = "Spot, left";
    show.fixtures[0].fixture_id = "101";
    show.fixtures[2].is_mode_known = false;
    std::vector<FixtureValues> values(3);
    values[0].light_percent = 80;
    values[0].pan_deg = -12.5f;
    values[2].light_percent = 100;
    BookEntry entry;
    entry.number = "2.5";
    entry.name = "Verse";
    BookValues all;
    all.add(BookEntry{}, show, std::vector<FixtureValues>(3));
    all.add(entry, show, values);
    const std::string& csv = all.csv();
    EXPECT_TRUE(csv.starts_with("\xef\xbb\xbf"
                                "entry,entry_number,entry_name,fixture_number,fixture,"));
    EXPECT_NE(csv.find("\r\n2,2.5,Verse,101,\"Spot, left\",open,open,80,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",-12.5,0\r\n"), std::string::npos) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
}

TEST(Values, are_whole_entries_up_to_kMostValuesBytes) {
    Show show;
    show.fixtures.resize(1);
    show.fixtures[0].type = std::make_shared<fixture::Type>();
    show.fixtures[0].name = std::string(kMostValuesBytes / 2 - 1000, 'x');
    std::vector<FixtureValues> values(1);
    values[0].light_percent = 100;
    BookValues all;
    for (int entry = 0; entry < 3; ++entry) all.add(BookEntry{}, show, values);
    EXPECT_EQ(all.left_out(), 1u);
    EXPECT_LE(all.csv().size(), kMostValuesBytes);
    EXPECT_TRUE(all.csv().ends_with("\r\n"));
}

TEST(BookFile, every_beginning_is_refused_with_its_name) {
    const std::string text = text_of(small_book());
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
        const auto read = book_from(text.substr(0, size), "book.json");
        ASSERT_FALSE(read.ok()) << size;
        ASSERT_EQ(read.error().where, "book.json");
    }
}

// The book with something else under that key, at its first place.
std::string with(const char* key, const char* wrong) {
    std::string text = text_of(small_book());
    const std::string name = std::string("\"") + key + "\": ";
    const std::size_t at = text.find(name);
    EXPECT_NE(at, std::string::npos) << key;
    return text.insert(at + name.size(), std::string(wrong) + ",\"was_" + key + "\": ");
}

TEST(BookFile, something_else_in_the_place_of_a_list_is_refused) {
    for (const char* list : {"addresses", "pictures", "changes", "unknown", "entries"})
        for (const char* wrong : {R"("abc")", R"({"length":5})", R"({})", "null"}) {
            const auto refused = book_from(with(list, wrong), "x");
            ASSERT_FALSE(refused.ok()) << list << " " << wrong;
            EXPECT_NE(refused.error().what.find(list), std::string::npos) << refused.error().what;
        }
}

TEST(BookFile, a_number_that_has_no_room_is_refused) {
    EXPECT_EQ(book_from(with("size", "[64, 3e16]"), "x").error().what,
              "is a damaged cue book: a number from 0 to 16384 is expected, not 3e+16");
    for (const auto& [key, wrong] : {std::pair{"size", "[-3, 64]"},
                                     {"ev100", "1e300"},
                                     {"ev100", "true"},
                                     {"addresses", "[[1e10, 1]]"},
                                     {"position_m", "[0, -1e39, 0]"},
                                     {"fade_s", "1e39"},
                                     {"at_s", "\"1\""}})
        EXPECT_FALSE(book_from(with(key, wrong), "x").ok()) << key << " " << wrong;
    EXPECT_TRUE(book_from(with("fade_s", "null"), "x").ok());
}

TEST(BookFile, of_another_kind_is_refused) {
    EXPECT_FALSE(book_from("[]", "x").ok());
    EXPECT_FALSE(book_from("{}", "x").ok());
    EXPECT_FALSE(book_from(R"({"ghostlight_book": 2})", "x").ok());
    EXPECT_FALSE(book_from(R"({"ghostlight_book": 1})", "x").ok());
    Book large;
    large.fixtures.resize(kMaxFixtures);
    ASSERT_TRUE(book_from(text_of(large), "x").ok());
    large.fixtures.emplace_back();
    EXPECT_EQ(book_from(text_of(large), "x").error().text(),
              "x: has 0 entries and 10001 fixtures, a cue book has at most 10000 and 10000");
    for (const char* const file :
         {"../secret.png", "pictures/../../a.png", "/etc/passwd", "pictures/.png", "a.png", ""}) {
        Book book = small_book();
        book.entries[0].pictures[0].file = file;
        EXPECT_FALSE(book_from(text_of(book), "x").ok()) << file;
    }
}

// Each of them is looked up by walking.
TEST(BookFile, of_objects_with_more_members_than_any_of_ours_is_refused) {
    const auto with_members = [](std::size_t count) {
        std::string all = R"({"ghostlight_book": 2)";
        for (std::size_t k = 1; k < count; ++k) all += ", \"" + std::to_string(k) + "\": 0";
        return book_from(all + "}", "x").error().what;
    };
    EXPECT_NE(with_members(64).find("of another version"), std::string::npos);
    EXPECT_NE(with_members(65).find("more than 64 members"), std::string::npos);
}

TEST(Page, escapes_names_and_keeps_every_script) {
    Book book = small_book();
    book.entries[0].name = "</h2><script>alert(1)</script>";
    book.entries[0].notes = "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d"; // right to left
    book.fixtures[0].name = std::string(10'000, 'x');
    const std::string page = html_of(book, nullptr, PaperSize::a4);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_NE(page.find("&lt;script&gt;"), std::string::npos);
    EXPECT_NE(page.find("<bdi>\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d</bdi>"), std::string::npos);
    EXPECT_NE(page.find("Demo &lt;&quot;&amp;&#39;&gt;"), std::string::npos);
    EXPECT_NE(page.find("one thing"), std::string::npos);
    EXPECT_NE(page.find("goes on where the recording is; drawn at 0:12"), std::string::npos);
    EXPECT_EQ(html_text("a\x1b\xff"), "a\\u001b\xef\xbf\xbd");
}

TEST(Page, of_a_book_has_numbers_and_pages_of_the_script) {
    Book book = small_book();
    book.entries.push_back(book.entries[0]);
    book.entries[1].number.clear();
    for (const BookLayout layout : {BookLayout::list, BookLayout::grid}) {
        const std::string page = html_of(book, nullptr, PaperSize::a4, {}, layout);
        EXPECT_NE(page.find("<h2>47.5. <bdi>Verse</bdi></h2>"), std::string::npos);
        EXPECT_NE(page.find("<h2><bdi>Verse</bdi></h2>"), std::string::npos)
            << "that of its place is another's";
        EXPECT_NE(page.find("page 12 of the script"), std::string::npos);
        EXPECT_NE(page.find("pictures/0001-1.png"), std::string::npos);
        EXPECT_EQ(page.find("0 to 80\u00a0%") == std::string::npos, layout == BookLayout::grid);
    }
}

TEST(Page, says_that_nothing_is_seen) {
    Book book = small_book();
    book.entries.push_back(book.entries[0]);
    book.entries[1].changes.clear();
    EXPECT_NE(html_of(book, nullptr, PaperSize::letter).find("nothing that is seen"), std::string::npos);
}

TEST(Page, of_a_book_without_numbers_counts_and_tells_moments_to_a_hundredth) {
    Book book = small_book();
    book.entries.resize(1);
    book.entries[0].number.clear();
    book.entries[0].goes_on = false;
    for (const auto& [at_s, said] : {std::pair{25.5, "at 0:25.5"},
                                     {59.6, "at 0:59.6"},
                                     {12.48, "at 0:12.48"},
                                     {12.999, "at 0:12.99"},
                                     {3600.0, "at 1:00:00"}}) {
        book.entries[0].at_s = at_s;
        book.entries[0].page.clear();
        const std::string page = html_of(book, nullptr, PaperSize::a4);
        EXPECT_NE(page.find("<h2>1. <bdi>Verse</bdi></h2>"), std::string::npos);
        EXPECT_NE(page.find(said), std::string::npos) << said;
    }
    const std::string german = html_of(book, nullptr, PaperSize::a4, {Language::german});
    EXPECT_NE(german.find("1:00:00"), std::string::npos);
    book.entries[0].at_s = 25.5;
    EXPECT_NE(html_of(book, nullptr, PaperSize::a4, {Language::german}).find("0:25,5"), std::string::npos);
}

TEST(BookOfShow, says_what_it_does_not_know) {
    Show show = demo();
    EXPECT_EQ(book_of(show).unknown.at(0), "the show has no fixtures");
    show.fixtures.resize(3);
    EXPECT_TRUE(book_of(show).unknown.at(0).starts_with("3 fixtures have no file"));
}

TEST(BookPage, is_german_where_it_is_asked_for) {
    const PrintStyle german{Language::german, Units::metric};
    const std::string page = html_of(small_book(), nullptr, PaperSize::a4, german);
    for (const char* part : {"<html lang=\"de\">", "Cue-Buch", "(Cues)", "Aus dem Dunkel", "gezeichnet von"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* part : {"From the dark", "What changes", "drawn by", "entries"})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
}

TEST(Marks, are_read_and_what_is_none_is_said) {
    Report report;
    const std::string csv = "\xef\xbb\xbftime,number,name,note\r\n1:23.5,12,\"Solo, \"\"slow\"\"\",\r\n"
                            "5,3,Haze,from the left\nsoon,4,Never,\n\n# a remark\n00:00:10:12,5,,\n"
                            "0:75,6,,\n-1,7,,\n9";
    const std::vector<Mark> marks = read_marks(csv, "cues.csv", 25, report);
    ASSERT_EQ(marks.size(), 4u) << "in the order of time";
    EXPECT_EQ(marks[0].at_s, 5);
    EXPECT_EQ(marks[0].note, "from the left");
    EXPECT_EQ(marks[1].at_s, 9);
    EXPECT_DOUBLE_EQ(marks[2].at_s, 10.48);
    EXPECT_EQ(marks[3].at_s, 83.5);
    EXPECT_EQ(marks[3].name, "Solo, \"slow\"");
    ASSERT_EQ(report.messages.size(), 3u);
    EXPECT_EQ(report.messages[0].where, "cues.csv:4");
    Report rateless;
    EXPECT_TRUE(read_marks("00:00:10:12,5\n", "cues.csv", 0, rateless).empty());
    EXPECT_NE(rateless.messages.at(0).what.find("--mark-fps"), std::string::npos);
    for (std::size_t size = 0; size < csv.size(); ++size)
        (void)read_marks(csv.substr(0, size), "", 25, rateless);
    Show show;
    show.recording = "a.ghostdmx";
    const auto plan = plan_book(show, {}, BookKind::marks, {}, {}, marks);
    ASSERT_TRUE(plan.ok());
    EXPECT_EQ(plan->kind, "marks");
    EXPECT_EQ(plan->entries[0].entry.name, "Haze");
    EXPECT_EQ(plan->entries[0].entry.number, "3");
    EXPECT_EQ(plan->entries[2].entry.name, "5") << "a number is its name where it has no other";
    EXPECT_TRUE(plan->entries[2].entry.number.empty());
    EXPECT_EQ(plan->entries[1].entry.name, "0:09");
    EXPECT_FALSE(plan_book(show, {}, BookKind::marks, {}, {}, {}).ok());
    show.recording.clear();
    EXPECT_FALSE(plan_book(show, {}, BookKind::marks, {}, {}, marks).ok());
}

TEST(Marks, have_the_separator_of_their_first_line) {
    Report report;
    const auto spreadsheet = read_marks("Zeit;Nummer;Name;Notiz\n10,5;1;Blau, dann rot;Notiz\n"
                                        "\"00:00:20;15\";2;Rot;\n30,5,3,Gold\n0:40,25;4\n",
                                        "marks_de.csv", 30, report);
    ASSERT_EQ(spreadsheet.size(), 3u);
    EXPECT_EQ(spreadsheet[0].at_s, 10.5);
    EXPECT_EQ(spreadsheet[0].number, "1");
    EXPECT_EQ(spreadsheet[0].name, "Blau, dann rot");
    EXPECT_EQ(spreadsheet[0].note, "Notiz");
    EXPECT_DOUBLE_EQ(spreadsheet[1].at_s, 615 * 1.001 / 30);
    EXPECT_EQ(spreadsheet[2].at_s, 40.25);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(report.messages[0].where, "marks_de.csv:4");
    EXPECT_NE(report.messages[0].what.find("'30,5,3,Gold', expected seconds or H:MM:SS before a ';'"),
              std::string::npos)
        << report.messages[0].what;

    const auto drop_frame = read_marks("00:00:36;15,12,Solo\n00:01:00;02\n7;8\n", "", 30, report);
    ASSERT_EQ(drop_frame.size(), 2u);
    EXPECT_DOUBLE_EQ(drop_frame[0].at_s, 1095 * 1.001 / 30);
    EXPECT_EQ(drop_frame[0].number, "12");
    EXPECT_DOUBLE_EQ(drop_frame[1].at_s, 1800 * 1.001 / 30);
    Report rateless;
    EXPECT_TRUE(read_marks("00:00:36;15,12\n", "", 25, rateless).empty());
    EXPECT_NE(rateless.messages.at(0).what.find("--mark-fps 30"), std::string::npos);

    EXPECT_EQ(read_marks("10,5\tone\n", "", 0, report).at(0).at_s, 10.5);
    Report refused;
    EXPECT_TRUE(
        read_marks("time,number,name,note\n10,5,1,Blau,Notiz\n1.5:30,2\n", "m.csv", 0, refused).empty());
    ASSERT_EQ(refused.messages.size(), 2u);
    EXPECT_NE(refused.messages[0].what.find("5 parts, expected at most 4"), std::string::npos);
}

TEST(Marks, that_may_be_decimals_with_commas_say_so) {
    const auto warnings = [](std::string_view csv) {
        Report report;
        read_marks(csv, "cues.csv", 0, report);
        return report.messages.size();
    };
    EXPECT_EQ(warnings("83,5\n91,2\n"), 1u);
    EXPECT_EQ(warnings("Zeit\n83,50\n91,25\n95,00\n"), 1u);
    EXPECT_EQ(warnings("83,5\n"), 1u);
    EXPECT_EQ(warnings("10,5\n20,25\n30\n41,75\n50,5\n"), 1u);
    EXPECT_EQ(warnings("10\n20\n"), 0u);
    EXPECT_EQ(warnings("0,1\n12,2\n25,10\n"), 0u) << "numbers that count on";
    EXPECT_EQ(warnings("83,5,Solo\n91,2,Verse\n"), 0u);
    EXPECT_EQ(warnings("83,5;\n91,2;\n"), 0u);
    EXPECT_EQ(warnings("time,number\n83,1\n91,2\n"), 0u);
}

TEST(Marks, of_spreadsheets_are_read_or_told_what_they_are) {
    Report report;
    const std::vector<Mark> told = read_marks("sep=;\nZeit;Nummer\n20,5;1;A\n", "cues.csv", 0, report);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_DOUBLE_EQ(told[0].at_s, 20.5);
    EXPECT_TRUE(report.messages.empty());
    EXPECT_TRUE(read_marks(std::string_view("\xff\xfe"
                                            "2\0000\0",
                                            6),
                           "cues.csv", 0, report)
                    .empty());
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].what.find("UTF-16"), std::string::npos);
    read_marks("\"20,5\",1,A\n", "cues.csv", 0, report);
    ASSERT_EQ(report.messages.size(), 2u);
    EXPECT_NE(report.messages[1].what.find("';' parts the cells"), std::string::npos);
}

TEST(Marks, have_no_separator_from_their_words) {
    for (const std::string head : {"time,cue; name\n", "Show: list; made by me\n", ""}) {
        Report report;
        const auto marks = read_marks(head + "10,1,Go; slowly\n20,2,B\n", "m.csv", 0, report);
        ASSERT_EQ(marks.size(), 2u) << head;
        EXPECT_EQ(marks[0].at_s, 10);
        EXPECT_EQ(marks[0].name, "Go; slowly");
        EXPECT_TRUE(report.messages.empty());
    }
    Report report;
    EXPECT_TRUE(read_marks("00:01:23;12;1;A\n", "m.csv", 30, report).empty());
    EXPECT_NE(report.messages.at(0).what.find("stands in quotes"), std::string::npos);
}

} // namespace
} // namespace ghost::scene
