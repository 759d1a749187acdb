#pragma once
// SPDX-License-Identifier: Apache-2.0
// BookShelf: the files of a cue book (docs/guide/cue-book.md) for the page, by their names there: book.json,
// difference.json where it was made against an older one, and the pictures that these name. No other name
// leads to the disk. The book is read again when it was made anew. One thread.

#include "base/result.h"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace ghost::web {

inline constexpr std::size_t kMostBookPictureBytes = std::size_t{64} << 20;

class BookShelf {
public:
    // folder: empty: there is no book.
    explicit BookShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

    struct File {
        std::string type; // of HTTP
        std::string bytes;
    };
    // Error: in words for who reads; there is no book, it is damaged, or has no such file.
    Result<File> file(std::string_view name);

private:
    Result<void> read();

    std::filesystem::path folder_;
    std::filesystem::file_time_type read_at_{};
    std::string book_, difference_;
    std::set<std::string, std::less<>> pictures_;
};

} // namespace ghost::web
