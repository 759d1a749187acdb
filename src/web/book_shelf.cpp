// SPDX-License-Identifier: Apache-2.0
#include "web/book_shelf.h"

#include "book/book_json.h"
#include "disk/files.h"

namespace ghost::web {

Result<void> BookShelf::read() {
    if (folder_.empty())
        return Error{"no cue book is given: start with --book FOLDER, which 'ghostlight book' makes", ""};
    const std::filesystem::path file = folder_ / "book.json", other = folder_ / "difference.json";
    std::error_code code;
    const auto written = std::filesystem::last_write_time(file, code);
    if (code) return Error{"there is no cue book in the folder of --book", ""};
    if (!book_.empty() && written == read_at_) return {};
    book_.clear();
    difference_.clear();
    pictures_.clear();
    TRY(std::string text, read_text_file(file, scene::kMostBookBytes));
    TRY(const scene::Book book, scene::book_from(text, "book.json"));
    for (const scene::BookEntry& entry : book.entries)
        for (const scene::BookPicture& picture : entry.pictures) pictures_.insert(picture.file);
    if (std::filesystem::exists(other, code)) {
        TRY(difference_, read_text_file(other, scene::kMostBookBytes));
        TRY(const std::vector<std::string> files, scene::files_of_difference(difference_, "difference.json"));
        pictures_.insert(files.begin(), files.end());
    }
    book_ = std::move(text);
    read_at_ = written;
    return {};
}

Result<BookShelf::File> BookShelf::file(std::string_view name) {
    TRY_VOID(read());
    if (name == "book.json") return File{"application/json", book_};
    if (name == "difference.json" && !difference_.empty()) return File{"application/json", difference_};
    const auto picture = pictures_.find(name);
    if (picture == pictures_.end()) return Error{"the cue book has no such file", ""};
    const std::filesystem::path path = folder_ / *picture;
    std::error_code code;
    for (const std::filesystem::path& part : {path.parent_path(), path})
        if (std::filesystem::is_symlink(part, code)) // a book may come from strangers
            return Error{"the cue book has a link in the place of a picture, which is not followed", ""};
    TRY(std::string bytes, read_text_file(path, kMostBookPictureBytes));
    return File{"image/png", std::move(bytes)};
}

} // namespace ghost::web
