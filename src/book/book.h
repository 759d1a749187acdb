#pragma once
// SPDX-License-Identifier: Apache-2.0
// Book: the cue book of a show as values: its entries, each with pictures and what changed in words, the rig
// that they were drawn of, and what is not known. What pages and book.json print. Metres, seconds. Plain
// values.

#include "book/changes.h"
#include "fixture/patch.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

inline constexpr std::size_t kMostEntries = 10'000;

struct BookFixture {
    std::string name;
    std::string id;                          // as the desk calls it, or ""
    std::string uuid;                        // of the plot, or ""
    std::string type;                        // "Vari-Lite VL2500 Spot"; "": its file could not be read
    std::string mode;                        // "": nobody names one of the type's
    std::vector<fixture::Address> addresses; // none: they cannot be read
    std::optional<glm::vec3> position_m;     // none: nobody says one
    std::optional<glm::vec3> rotation_deg;   // as a show has it; none: nobody says it, nor does an older book
};

struct BookPicture {
    std::string camera;
    std::string file; // below the book's folder: "pictures/0001-1.png"

    bool operator==(const BookPicture&) const = default;
};

struct BookEntry {
    std::string name;
    std::string number; // of the cue or mark, or ""
    std::string page;   // of the script, or ""
    std::string notes;
    std::string look;              // that lies on what the recording says, or ""
    std::optional<double> at_s;    // of the recording
    bool goes_on = false;          // the cue says no time: at_s is that of the cue before
    std::optional<float> fade_s;   // as the cue or its look says
    std::optional<float> follow_s; // after which the next one goes by itself
    std::vector<BookPicture> pictures;
    std::vector<BookChange> changes; // since the entry before; the first one: since nothing was sent
    std::vector<std::string> unknown;

    bool operator==(const BookEntry&) const = default;
};

// How its entries lie on a page: below one another with all that is known of them, or twelve, each with its
// first picture.
enum class BookLayout { list, grid };

struct Book {
    std::string show;
    std::string kind;          // "cues", "looks", "marks", "moments found", "one moment"
    int width = 0, height = 0; // of a picture
    float ev100 = 0;           // of all pictures
    std::string device;
    std::vector<BookFixture> fixtures;
    std::vector<BookEntry> entries;
    std::vector<std::string> unknown; // sentences
    bool is_for_client = false;       // fixtures, changes and what entries do not know are left out
};

// Name, fixtures, and what the show does not say about them; for a client these are counted, not named.
Book book_of(const Show& show, const PrintStyle& style = {}, bool is_for_client = false);

} // namespace ghost::scene
