// SPDX-License-Identifier: Apache-2.0
// A book against an older one.
#include "book/difference.h"

#include "book/book_html.h"
#include "book/book_json.h"
#include "book/tour_html.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

using Sentences = std::vector<std::string>;

Book book(const std::vector<std::string>& entries) {
    Book made;
    for (const std::string& name : entries) made.entries.emplace_back().name = name;
    return made;
}

BookFixture spot(const std::string& name, int channel, const std::string& uuid = "") {
    return {name, "", uuid, "Maker Spot", "Standard", {{1, channel}}, glm::vec3(0, 0, 6), glm::vec3(0)};
}

TEST(Difference, of_equal_books_is_nothing) {
    Book one = book({"a", "b"});
    one.fixtures = {spot("Spot 1", 1)};
    const BookDifference difference = difference_of(one, one);
    EXPECT_TRUE(difference.entries.empty());
    EXPECT_TRUE(difference.fixtures.empty());
    EXPECT_TRUE(difference.unknown.empty());
}

TEST(Difference, of_a_fixture_that_hangs_otherwise_is_its_turn) {
    Book old = book({"a"}), now = book({"a"});
    old.fixtures = now.fixtures = {spot("Spot 1", 1), spot("Spot 2", 23)};
    now.fixtures[0].rotation_deg = glm::vec3(180, 0, 90);
    old.fixtures[0].rotation_deg = glm::vec3(180, 0, 0);
    now.fixtures[1].rotation_deg = glm::vec3(360, 0.1f, 0); // as it was
    EXPECT_EQ(difference_of(old, now).fixtures, (Sentences{"Spot 1 hangs otherwise, turned by 90 deg"}));
    old.fixtures[0].rotation_deg.reset();
    EXPECT_EQ(
        difference_of(old, now).fixtures,
        (Sentences{
            "whether a fixture hangs otherwise is not known: the older book does not say how they hang"}));
}

TEST(Difference, of_books_drawn_in_another_order_says_that_they_may_round_otherwise) {
    Book old = book({"a"}), now = book({"a"});
    old.entries[0].pictures = {{"house", "pictures/0001-1.png"}, {"close", "pictures/0001-2.png"}};
    now.entries[0].pictures = {{"house", "pictures/0001-1.png"}};
    ASSERT_EQ(difference_of(old, now).unknown.size(), 1u);
    EXPECT_NE(difference_of(old, now).unknown[0].find("another order"), std::string::npos);
    EXPECT_TRUE(difference_of(now, now).unknown.empty());
    EXPECT_TRUE(difference_of(book({"a", "b"}), book({"a", "new", "b"})).unknown.empty());
    EXPECT_FALSE(difference_of(book({"a", "b"}), book({"b", "a"})).unknown.empty());
    old = now;
    old.is_for_client = true;
    EXPECT_FALSE(difference_of(old, now).unknown.empty());
}

TEST(Difference, names_entries_that_are_new_gone_and_moved) {
    EXPECT_EQ(difference_of(book({"a", "b", "c", "d"}), book({"d", "a", "c", "e"})).entries,
              (Sentences{"'e' is new", "'b' is gone", "'d' moved in the list, from place 4 to 1"}));
    Book old = book({"a"}), now = book({"a"});
    old.entries[0].at_s = 10;
    now.entries[0].at_s = 12.5;
    now.entries[0].look = "Blue";
    EXPECT_EQ(difference_of(old, now).entries,
              (Sentences{"'a' is at 12.5 s, was at 10 s", "'a' has the look 'Blue', had ''"}));
}

TEST(Difference, matches_entries_by_number_then_by_name) {
    Book old = book({"Dark", "Verse", "Dark", "Solo"}),
         now = book({"Dark", "Chorus", "Dark", "Dark", "Solo"});
    for (std::size_t i = 0; i < 4; ++i) old.entries[i].number = std::to_string(i + 1);
    const char* const numbers[] = {"1", "2", "2.5", "3", "5"};
    for (std::size_t i = 0; i < 5; ++i) now.entries[i].number = numbers[i];
    EXPECT_EQ(older_entries(old, now), (std::vector<std::optional<std::size_t>>{0, 1, std::nullopt, 2, 3}));
    EXPECT_EQ(difference_of(old, now).entries, (Sentences{"'Dark' is new", "'Chorus' was called 'Verse'",
                                                          "'Solo' has the number '5', had '4'"}));
}

TEST(Difference, since_a_tour_says_that_it_names_no_fixtures) {
    Book now = book({"a", "b"});
    now.fixtures = {spot("Spot 1", 1)};
    now.entries[0].notes = "Stand by";
    now.entries[0].changes = {{{"Spot 1"}, "0 to 80 %"}};
    now.entries[0].unknown = {"Spot 1 is not known"};
    const Book tour = for_client(now, false);
    const std::string text = text_of(tour);
    for (const char* const secret : {"Spot 1", "Stand by", "Standard"})
        EXPECT_EQ(text.find(secret), std::string::npos) << secret;
    EXPECT_NE(text_of(for_client(now, true)).find("Stand by"), std::string::npos);
    const auto read = book_from(text, "tour");
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_TRUE(read->is_for_client);
    const BookDifference difference = difference_of(*read, now);
    EXPECT_TRUE(difference.entries.empty());
    EXPECT_EQ(difference.fixtures,
              (Sentences{"the older one is a tour, which names no fixtures: they are not compared"}));
    EXPECT_FALSE(book_from(text_of(now), "book")->is_for_client);
}

TEST(Difference, names_fixtures_that_are_new_gone_moved_and_patched) {
    Book old, now;
    old.fixtures = {spot("Spot 1", 1), spot("Spot 2", 23), spot("Spot 3", 45), spot("Old", 100, "u1")};
    now.fixtures = {spot("Spot 1", 1), spot("Spot 2", 23), spot("New name", 100, "u1"), spot("Spot 4", 67)};
    now.fixtures[0].position_m->x = now.fixtures[1].position_m->x = 0.4f;
    now.fixtures[1].addresses = {{2, 23}};
    now.fixtures[0].mode = "Extended";
    EXPECT_EQ(difference_of(old, now).fixtures,
              (Sentences{"Spot 4 is new", "Spot 3 is gone", "Spot 1-2 moved by 0.4 m",
                         "Spot 1 is 'Maker Spot' in mode 'Extended', was 'Maker Spot' in mode 'Standard'",
                         "Spot 2 is patched at 2.23, was at 1.23", "New name was called 'Old'"}));
}

TEST(Difference, does_not_measure_from_a_place_that_nobody_knows) {
    Book old, now;
    old.fixtures = {spot("Spot 1", 1), spot("Spot 2", 23), spot("Spot 3", 45)};
    now.fixtures = old.fixtures;
    old.fixtures[0].position_m = old.fixtures[2].position_m = now.fixtures[1].position_m =
        now.fixtures[2].position_m = std::nullopt;
    EXPECT_EQ(difference_of(old, now).fixtures, (Sentences{"Spot 1 has a place, which was not known",
                                                           "Spot 2 has no place any more that is known"}));
}

TEST(Difference, of_a_name_that_was_hung_anew_is_the_same_fixture) {
    Book old, now;
    old.fixtures = {spot("Spot 1", 1, "u1")};
    now.fixtures = {spot("Spot 1", 1, "u2")};
    EXPECT_TRUE(difference_of(old, now).fixtures.empty());
}

image::Image8 grey(int width, std::uint8_t level) {
    image::Image8 picture(width, 32, 4);
    std::fill(picture.samples.begin(), picture.samples.end(), level);
    return picture;
}

TEST(Pictures, that_are_equal_have_no_difference) {
    image::Image8 map;
    const auto same = compare_pictures(grey(32, 80), grey(32, 80), map);
    ASSERT_TRUE(same.ok());
    EXPECT_EQ(same->seen, PictureDifference::Seen::same_pixels);
    EXPECT_EQ(same->max, 0);
    EXPECT_TRUE(map.empty());
}

TEST(Pictures, differ_as_far_as_people_see) {
    image::Image8 map;
    const auto little = compare_pictures(grey(32, 80), grey(32, 81), map);
    EXPECT_EQ(little->seen, PictureDifference::Seen::not_seen) << little->max;
    EXPECT_GT(little->max, 0);
    EXPECT_EQ(map.width, 32);
    const auto all = compare_pictures(grey(32, 20), grey(32, 200), map);
    EXPECT_EQ(all->seen, PictureDifference::Seen::large);
    EXPECT_GT(all->mean, 0.1);
    image::Image8 spotted = grey(64, 20);
    for (int y = 10; y < 14; ++y)
        for (int x = 10; x < 14; ++x)
            for (int k = 0; k < 3; ++k) spotted.at(x, y)[k] = 255;
    const auto spot = compare_pictures(grey(64, 20), spotted, map);
    EXPECT_EQ(spot->seen, PictureDifference::Seen::seen) << spot->share;
    EXPECT_FALSE(compare_pictures(grey(32, 20), grey(33, 20), map).ok());
}

TEST(Pictures, that_differ_most_come_first) {
    std::vector<ComparedPicture> pictures(4);
    for (int i = 0; i < 4; ++i) pictures[static_cast<std::size_t>(i)].name = std::to_string(i);
    pictures[0].difference = PictureDifference{};
    pictures[1].difference = PictureDifference{PictureDifference::Seen::seen, 0.1, 0.3, 0.5, 0.1};
    pictures[2].difference = PictureDifference{};
    sort_by_difference(pictures);
    std::string order;
    for (const ComparedPicture& picture : pictures) order += picture.name;
    EXPECT_EQ(order, "3102");
}

TEST(DifferencePage, has_a_slider_for_what_differs_alone) {
    Book now = book({"a", "b"});
    BookDifference difference = difference_of(now, now);
    difference.pictures = {{"a", "house", "pictures/0001-1.png", "old/0001-1.png", "differences/0001-1.png",
                            PictureDifference{PictureDifference::Seen::seen, 0.1, 0.3, 0.5, 0.1}, ""},
                           {"b", "house", "pictures/0002-1.png", "", "", PictureDifference{}, ""}};
    const std::string page = html_of(now, &difference, PaperSize::a4);
    EXPECT_NE(page.find("old/0001-1.png"), std::string::npos);
    EXPECT_NE(page.find("type=\"range\""), std::string::npos);
    EXPECT_EQ(page.find("type=\"range\""), page.rfind("type=\"range\""));
    EXPECT_NE(page.find("the same"), std::string::npos);
}

TEST(DifferenceJson, names_its_pictures_and_no_others) {
    BookDifference difference;
    difference.pictures = {{"a", "house", "pictures/0001-1.png", "old/0001-1.png", "differences/0001-1.png",
                            PictureDifference{PictureDifference::Seen::seen, 0.1, 0.3, 0.5, 0.1}, ""},
                           {"b", "house", "pictures/0002-1.png", "", "", std::nullopt, "of another size"}};
    const std::string text = text_of(difference);
    EXPECT_NE(text.find("\"seen\": \"seen\""), std::string::npos);
    const auto files = files_of_difference(text, "x");
    ASSERT_TRUE(files.ok());
    EXPECT_EQ(*files, (Sentences{"pictures/0001-1.png", "old/0001-1.png", "differences/0001-1.png",
                                 "pictures/0002-1.png"}));
    for (std::size_t size = 0; size + 1 < text.size(); ++size)
        EXPECT_FALSE(files_of_difference(text.substr(0, size), "x").ok()) << size;
    for (const char* bad :
         {"[]", "{}", R"({"ghostlight_difference":2,"pictures":[]})", R"({"ghostlight_difference":1})",
          R"({"ghostlight_difference":1,"pictures":[{}]})", R"({"ghostlight_difference":1,"pictures":7})"})
        EXPECT_FALSE(files_of_difference(bad, "x").ok()) << bad;
    for (const char* list : {"entries", "fixtures", "unknown", "pictures"})
        for (const char* wrong : {R"("abc")", R"({"length":5})", R"({"a":{}})", "null"}) {
            std::string bad = text;
            const std::string key = std::string("\"") + list + "\": ";
            const std::size_t at = bad.find(key);
            ASSERT_NE(at, std::string::npos) << list;
            bad.insert(at + key.size(), std::string(wrong) + ",\"was_" + list + "\": ");
            const auto refused = files_of_difference(bad, "x");
            ASSERT_FALSE(refused.ok()) << bad;
            EXPECT_NE(refused.error().what.find(list), std::string::npos) << refused.error().what;
        }
    for (const char* file : {"/etc/passwd", "old/../../x.png", "pictures/0001-1.png", "old/.png", "old/a.png",
                             "old/0001-1.png/", "old/0001-1.jpg", "old.png"}) {
        difference.pictures[0].old_file = file;
        EXPECT_FALSE(files_of_difference(text_of(difference), "x").ok()) << file;
    }
}

} // namespace
} // namespace ghost::scene
