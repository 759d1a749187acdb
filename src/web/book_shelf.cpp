// SPDX-License-Identifier: Apache-2.0
#include "web/private/book_shelf.h"

#include "base/log.h"
#include "book/book_json.h"
#include "disk/files.h"

namespace ghost::web {
namespace {

constexpr const char* kNoFile = "the cue book has no such file";

Result<std::vector<std::string>> files_of_book(std::string_view text, const std::string& where) {
    TRY(const scene::Book book, scene::book_from(text, where));
    std::vector<std::string> files;
    for (const scene::BookEntry& entry : book.entries)
        for (const scene::BookPicture& picture : entry.pictures) files.push_back(picture.file);
    return files;
}

} // namespace

void BookShelf::renew(Text& text, const std::string& name, const std::string& missing,
                      PicturesOf* pictures_of) {
    const std::filesystem::path file = folder_ / name;
    std::error_code no_time, no_size, no_status;
    if (std::filesystem::is_symlink(file, no_status)) { // a book may come from strangers
        text = {{},
                Error{"the cue book has a link in the place of " + name + ", which is not followed", ""},
                {},
                true};
        return;
    }
    const Stamp stamp{std::filesystem::last_write_time(file, no_time),
                      std::filesystem::file_size(file, no_size)};
    if (no_time || no_size) {
        text = {{}, Error{missing, ""}};
        return;
    }
    if (text.stamp == stamp) return;
    Result<std::string> read = read_text_file(file, kMostShelfBytes);
    text = {stamp, Error{}, {}, true};
    if (!read.ok()) {
        text.text = read.error();
    } else {
        text.text = std::make_shared<const std::string>(std::move(*read));
        Result<std::vector<std::string>> pictures = pictures_of(**text.text, name);
        if (pictures.ok())
            text.pictures.insert(pictures->begin(), pictures->end());
        else
            text.text = pictures.error();
    }
    if (!text.text.ok()) log_warning("browsers: " + name + " of the cue book: " + text.text.error().what);
}

Result<BookShelf::File> BookShelf::file(std::string_view name) {
    if (folder_.empty()) {
        const char* const why =
            "no cue book is given: start with --book FOLDER, which 'ghostlight book' makes";
        // A browser that asks for one writes no fault to its console.
        if (name == "book.json")
            return File{"application/json",
                        std::make_shared<const std::string>(R"({"none":")" + std::string(why) + "\"}")};
        return Error{why, ""};
    }
    renew(book_, "book.json", "there is no cue book in the folder of --book", files_of_book);
    renew(difference_, "difference.json", kNoFile, scene::files_of_difference);
    if (!book_.text.ok()) return book_.text.error();
    if (name == "book.json") return File{"application/json", *book_.text};
    if (name == "difference.json") {
        if (!difference_.is_there)
            return File{"application/json", std::make_shared<const std::string>("null")};
        if (!difference_.text.ok()) return difference_.text.error();
        return File{"application/json", *difference_.text};
    }
    const Text& naming = book_.pictures.contains(name) ? book_ : difference_;
    const auto picture = naming.pictures.find(name);
    if (picture == naming.pictures.end()) return Error{kNoFile, ""};
    const std::filesystem::path path = folder_ / *picture;
    std::error_code code;
    for (const std::filesystem::path& part : {path.parent_path(), path})
        if (std::filesystem::is_symlink(part, code))
            return Error{"the cue book has a link in the place of a picture, which is not followed", ""};
    TRY(std::string bytes, read_text_file(path, kMostBookPictureBytes));
    return File{"image/png", std::make_shared<const std::string>(std::move(bytes))};
}

} // namespace ghost::web
