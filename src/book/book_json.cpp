// SPDX-License-Identifier: Apache-2.0
#include "book/book_json.h"

#include "json_xml_toml/json.h"
#include "show/limits.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <stdexcept>

namespace ghost::scene {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr JsonLimits kLimits{.bytes = kMostBookBytes, .values = 40'000'000, .members = 64};
constexpr double kMostNumber = 1e9;  // metres, seconds, universes, channels
constexpr double kMostSide = 16'384; // of a picture

template <class T>
Json optional(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json json_of(const glm::vec3& of) {
    return {of.x, of.y, of.z};
}

Json json_of(const BookFixture& fixture) {
    Json addresses = Json::array();
    for (const fixture::Address& address : fixture.addresses)
        addresses.push_back({address.universe, address.channel});
    Json all = {{"name", fixture.name},
                {"id", fixture.id},
                {"uuid", fixture.uuid},
                {"type", fixture.type},
                {"mode", fixture.mode},
                {"addresses", addresses},
                {"position_m", fixture.position_m ? json_of(*fixture.position_m) : Json()}};
    if (fixture.rotation_deg) all["rotation_deg"] = json_of(*fixture.rotation_deg);
    return all;
}

Json json_of(const BookEntry& entry) {
    Json pictures = Json::array(), changes = Json::array();
    for (const BookPicture& picture : entry.pictures)
        pictures.push_back({{"camera", picture.camera}, {"file", picture.file}});
    for (const BookChange& change : entry.changes)
        changes.push_back({{"fixtures", change.fixtures}, {"what", change.what}});
    return {{"name", entry.name},
            {"number", entry.number},
            {"page", entry.page},
            {"notes", entry.notes},
            {"look", entry.look},
            {"at_s", optional(entry.at_s)},
            {"goes_on", entry.goes_on},
            {"fade_s", optional(entry.fade_s)},
            {"follow_s", optional(entry.follow_s)},
            {"pictures", pictures},
            {"changes", changes},
            {"unknown", entry.unknown}};
}

// What follows throws Json::exception where something is missing or has another type, NotOfBook for a list or
// a number.
struct NotOfBook : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// What the library says begins with a name of its own: "[json.exception.out_of_range.403] key 'unknown' not
// found".
std::string damage_of(const Json::exception& error) {
    const std::string said = error.what();
    const std::size_t name_end = said.find("] ");
    return name_end == std::string::npos ? said : said.substr(name_end + 2);
}

// Json goes through objects and single values as through lists.
const Json& list_at(const Json& all, const char* key) {
    const Json& list = all.at(key);
    if (!list.is_array()) throw NotOfBook(std::string("'") + key + "' is not a list");
    return list;
}

// Json takes what an int or a float cannot hold.
template <class T>
T number_from(const Json& value, double least = -kMostNumber, double most = kMostNumber) {
    if (!value.is_number())
        throw NotOfBook(std::string("a number is expected where there is ") + value.type_name());
    const double number = value.get<double>();
    if (!(number >= least && number <= most)) {
        char words[100];
        std::snprintf(words, sizeof words, "a number from %g to %g is expected, not %g", least, most, number);
        throw NotOfBook(words);
    }
    return static_cast<T>(number);
}

template <class T>
std::optional<T> optional_from(const Json& value) {
    return value.is_null() ? std::nullopt : std::optional<T>(number_from<T>(value));
}

glm::vec3 vector_from(const Json& value) {
    glm::vec3 of(0);
    for (int k = 0; k < 3; ++k) of[k] = number_from<float>(value.at(static_cast<std::size_t>(k)));
    return of;
}

std::vector<std::string> texts_at(const Json& all, const char* key) {
    std::vector<std::string> texts;
    for (const Json& text : list_at(all, key)) texts.push_back(text.get<std::string>());
    return texts;
}

BookFixture fixture_from(const Json& all) {
    BookFixture fixture;
    fixture.name = all.at("name").get<std::string>();
    fixture.id = all.at("id").get<std::string>();
    fixture.uuid = all.at("uuid").get<std::string>();
    fixture.type = all.at("type").get<std::string>();
    fixture.mode = all.at("mode").get<std::string>();
    for (const Json& address : list_at(all, "addresses"))
        fixture.addresses.push_back({number_from<int>(address.at(0)), number_from<int>(address.at(1))});
    if (const Json& place = all.at("position_m"); !place.is_null()) fixture.position_m = vector_from(place);
    if (all.contains("rotation_deg")) fixture.rotation_deg = vector_from(all.at("rotation_deg"));
    return fixture;
}

BookEntry entry_from(const Json& all) {
    BookEntry entry;
    entry.name = all.at("name").get<std::string>();
    entry.number = all.value("number", ""); // which books had not always
    entry.page = all.value("page", "");
    entry.notes = all.at("notes").get<std::string>();
    entry.look = all.at("look").get<std::string>();
    entry.at_s = optional_from<double>(all.at("at_s"));
    entry.goes_on = all.at("goes_on").get<bool>();
    entry.fade_s = optional_from<float>(all.at("fade_s"));
    entry.follow_s = optional_from<float>(all.at("follow_s"));
    for (const Json& picture : list_at(all, "pictures"))
        entry.pictures.push_back(
            {picture.at("camera").get<std::string>(), picture.at("file").get<std::string>()});
    for (const Json& change : list_at(all, "changes"))
        entry.changes.push_back({texts_at(change, "fixtures"), change.at("what").get<std::string>()});
    entry.unknown = texts_at(all, "unknown");
    return entry;
}

Book whole_from(const Json& all) {
    Book book;
    book.show = all.at("show").get<std::string>();
    book.kind = all.at("kind").get<std::string>();
    book.width = number_from<int>(all.at("size").at(0), 0, kMostSide);
    book.height = number_from<int>(all.at("size").at(1), 0, kMostSide);
    book.ev100 = number_from<float>(all.at("ev100"));
    book.device = all.at("device").get<std::string>();
    for (const Json& fixture : list_at(all, "fixtures")) book.fixtures.push_back(fixture_from(fixture));
    for (const Json& entry : list_at(all, "entries")) book.entries.push_back(entry_from(entry));
    book.unknown = texts_at(all, "unknown");
    book.is_for_client = all.value("for_client", false);
    return book;
}

// "pictures/0001-1.png", as we name them, in that folder of the book.
bool is_of_book(const std::string& file, std::string_view folder = "pictures/") {
    constexpr std::string_view kEnding = ".png";
    if (!file.starts_with(folder) || !file.ends_with(kEnding) || file.size() < folder.size() + kEnding.size())
        return false;
    const std::string name = file.substr(folder.size(), file.size() - folder.size() - kEnding.size());
    return !name.empty() && name.find_first_not_of("0123456789-") == std::string::npos;
}

} // namespace

std::string text_of(const Book& book) {
    Json fixtures = Json::array(), entries = Json::array();
    for (const BookFixture& fixture : book.fixtures) fixtures.push_back(json_of(fixture));
    for (const BookEntry& entry : book.entries) entries.push_back(json_of(entry));
    Json all = {{"ghostlight_book", kVersion},       {"show", book.show},    {"kind", book.kind},
                {"size", {book.width, book.height}}, {"ev100", book.ev100},  {"device", book.device},
                {"unknown", book.unknown},           {"fixtures", fixtures}, {"entries", entries}};
    if (book.is_for_client) all["for_client"] = true;
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Book> book_from(std::string_view text, const std::string& where) {
    TRY(const Json all, read_ordered_json(text, where, kLimits));
    const auto version = all.is_object() ? all.find("ghostlight_book") : all.end();
    if (version == all.end()) return Error{"is no cue book: 'ghostlight_book' is expected", where};
    if (*version != kVersion)
        return Error{"is a cue book of another version; " + std::to_string(kVersion) + " is read", where};
    Book book;
    try {
        book = whole_from(all);
    } catch (const Json::exception& error) {
        return Error{"is a damaged cue book: " + damage_of(error), where};
    } catch (const NotOfBook& error) {
        return Error{std::string("is a damaged cue book: ") + error.what(), where};
    }
    if (book.entries.size() > kMostEntries || book.fixtures.size() > kMaxFixtures)
        return Error{"has " + std::to_string(book.entries.size()) + " entries and " +
                         std::to_string(book.fixtures.size()) + " fixtures, a cue book has at most " +
                         std::to_string(kMostEntries) + " and " + std::to_string(kMaxFixtures),
                     where};
    for (const BookEntry& entry : book.entries)
        for (const BookPicture& picture : entry.pictures)
            if (!is_of_book(picture.file))
                return Error{"has a picture that is not one of a cue book: '" + picture.file.substr(0, 60) +
                                 "'; 'pictures/0001-1.png' is expected",
                             where};
    return book;
}

std::string text_of(const BookDifference& difference) {
    Json pictures = Json::array();
    for (const ComparedPicture& picture : difference.pictures) {
        Json one{{"name", picture.name},         {"camera", picture.camera},
                 {"file", picture.file},         {"old_file", picture.old_file},
                 {"map_file", picture.map_file}, {"why_not", picture.why_not}};
        if (const auto& d = picture.difference) {
            one["seen"] = words_of(d->seen, {}); // a key of programs, in English
            one["mean"] = d->mean;
            one["p99"] = d->p99;
            one["max"] = d->max;
            one["share"] = d->share;
        }
        pictures.push_back(std::move(one));
    }
    const Json all = {{"ghostlight_difference", kVersion}, {"old_name", difference.old_name},
                      {"entries", difference.entries},     {"fixtures", difference.fixtures},
                      {"unknown", difference.unknown},     {"pictures", pictures}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::vector<std::string>> files_of_difference(std::string_view text, const std::string& where) {
    TRY(const Json all, read_ordered_json(text, where, kLimits));
    const auto version = all.is_object() ? all.find("ghostlight_difference") : all.end();
    if (version == all.end() || *version != kVersion)
        return Error{"is no difference between cue books, or of another version", where};
    std::vector<std::string> files;
    try {
        (void)all.at("old_name").get<std::string>();
        for (const char* key : {"entries", "fixtures", "unknown"}) (void)texts_at(all, key);
        for (const Json& picture : list_at(all, "pictures")) {
            for (const char* key : {"name", "camera"}) (void)picture.at(key).get<std::string>();
            for (const auto& [key, folder] :
                 {std::pair{"file", "pictures/"}, {"old_file", "old/"}, {"map_file", "differences/"}}) {
                auto file = picture.at(key).get<std::string>();
                if (file.empty()) continue;
                if (!is_of_book(file, folder))
                    return Error{"has a picture that is not one of a cue book: '" + file.substr(0, 60) + "'",
                                 where};
                files.push_back(std::move(file));
            }
        }
    } catch (const Json::exception& error) {
        return Error{"is damaged: " + damage_of(error), where};
    } catch (const NotOfBook& error) {
        return Error{std::string("is damaged: ") + error.what(), where};
    }
    return files;
}

} // namespace ghost::scene
