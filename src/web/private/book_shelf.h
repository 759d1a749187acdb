#pragma once
// SPDX-License-Identifier: Apache-2.0
// BookShelf: the files of a cue book (docs/guide/cue-book.md) for the page, by their names there: book.json,
// difference.json where it was made against an older one, and the pictures that these name. No other name
// leads to the disk. A file is read again when it was made anew, one that is damaged, too, and not before.
// One thread at a time, whichever.

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::web {

// For phones; a book on the disk may be larger. 10,000 fixtures and 1000 entries of which each changes 300
// take 9 MiB.
inline constexpr std::size_t kMostShelfBytes = std::size_t{16} << 20; // of book.json, of difference.json
inline constexpr std::size_t kMostBookPictureBytes = std::size_t{16} << 20;

class BookShelf {
public:
    // folder: empty: there is no book.
    explicit BookShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

    struct File {
        std::string type;                         // of HTTP
        std::shared_ptr<const std::string> bytes; // never null
    };
    // Without a folder book.json is {"none": a sentence}. Where the book was compared with none,
    // difference.json is null. Error: in words for who reads; there is no book, it is damaged, or has no such
    // file.
    Result<File> file(std::string_view name);

private:
    struct Stamp {
        std::filesystem::file_time_type written;
        std::uintmax_t bytes = 0;
        bool operator==(const Stamp&) const = default;
    };
    struct Text {
        std::optional<Stamp> stamp; // of what was read last, good or not; none: there is no file
        Result<std::shared_ptr<const std::string>> text;
        std::set<std::string, std::less<>> pictures = {}; // that it names
        bool is_there = false;
    };
    using PicturesOf = Result<std::vector<std::string>>(std::string_view text, const std::string& where);
    // As it is on the disk now.
    void renew(Text& text, const std::string& name, const std::string& missing, PicturesOf* pictures_of);

    std::filesystem::path folder_;
    Text book_{{}, Error{}}, difference_{{}, Error{}};
};

} // namespace ghost::web
