// SPDX-License-Identifier: Apache-2.0
#include "cli/render/book_against.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "book/book_json.h"
#include "disk/files.h"
#include "image/ldr.h"

#include <algorithm>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

using scene::ComparedPicture;

// Of a picture of the new book, "pictures/0001-1.png".
std::string moved_to(const std::string& folder, const std::string& file) {
    return folder + "/" + fs::path(file).filename().string();
}

// The older picture of the same entry from the same camera, or why there is none.
Result<std::string> older_picture(const scene::Book& old, std::optional<std::size_t> index,
                                  const std::string& camera, const scene::PrintStyle& style) {
    if (!index) return Error{style("the older book has no such entry"), ""};
    for (const scene::BookPicture& picture : old.entries[*index].pictures)
        if (picture.camera == camera) return picture.file;
    return Error{style("the older book has no picture from this camera"), ""};
}

// old_root: where the older pictures lie.
Result<ComparedPicture> compare_picture(const fs::path& old_root, const std::string& old_file,
                                        const scene::BookPicture& picture, const scene::PrintStyle& style,
                                        const WholeFolder& folder) {
    ComparedPicture compared;
    const Result<image::Image8> old = image::read_ldr(old_root / old_file);
    if (!old.ok()) {
        compared.why_not = style("the older picture: %1", {old.error().what});
        return compared;
    }
    TRY(const image::Image8 now, image::read_ldr(folder.written_to() / picture.file));
    if (old->width != now.width || old->height != now.height) {
        compared.why_not = style("the pictures differ in size: %1 x %2 and %3 x %4 pixels",
                                 {std::to_string(now.width), std::to_string(now.height),
                                  std::to_string(old->width), std::to_string(old->height)});
        return compared;
    }
    image::Image8 map;
    const Result<scene::PictureDifference> difference = scene::compare_pictures(*old, now, map);
    if (!difference.ok()) {
        compared.why_not = difference.error().what;
        return compared;
    }
    compared.difference = *difference;
    if (difference->seen == scene::PictureDifference::Seen::same_pixels) return compared;
    compared.old_file = moved_to("old", picture.file);
    compared.map_file = moved_to("differences", picture.file);
    TRY_VOID(image::write_png(folder.written_to() / compared.old_file, *old));
    TRY_VOID(image::write_png(folder.written_to() / compared.map_file, map));
    return compared;
}

std::string folder_name(const fs::path& path) {
    std::error_code code;
    const fs::path whole = fs::absolute(path, code).lexically_normal();
    return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

} // namespace

Result<std::optional<scene::Book>> old_book(const fs::path& folder) {
    const fs::path file = folder / "book.json";
    std::error_code code;
    if (!fs::exists(file, code)) {
        if (fs::is_directory(folder, code) && !fs::exists(folder / "show.toml", code))
            return Error{"has neither show.toml nor book.json: to compare with is a show, a plot or a book",
                         folder.string()};
        return std::optional<scene::Book>();
    }
    TRY(const std::string text, read_text_file(file, scene::kMostBookBytes));
    TRY(scene::Book book, scene::book_from(text, file.string()));
    return std::optional<scene::Book>(std::move(book));
}

Result<scene::BookDifference> compare_books(const BookOptions& options, const DrawnBook& now,
                                            const fs::path& old, const std::optional<scene::Book>& book,
                                            const WholeFolder& folder) {
    const fs::path drawn_to = folder.written_to() / "drawn";
    scene::Book before;
    if (book) {
        before = *book;
    } else {
        TRY_VOID(folder.make_folder("drawn/pictures"));
        BookOptions asked = options;
        asked.session.show = old.string();
        TRY(DrawnBook drawn, draw_book(asked, drawn_to, &now.frame));
        before = std::move(drawn.book);
    }
    scene::BookDifference difference = scene::difference_of(before, now.book, options.style);
    // Two versions of one show are told apart by their folders; a client is not told how ours are called.
    if (before.show == now.book.show && !now.book.is_for_client)
        difference.old_name += " (" + folder_name(old) + ")";
    if (before.width != now.book.width || before.height != now.book.height)
        difference.unknown.push_back(
            options.style("the older pictures are of another size and are not compared"));
    TRY_VOID(folder.make_folder("old"));
    TRY_VOID(folder.make_folder("differences"));
    Progress progress("comparing",
                      options.session.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    const std::vector<std::optional<std::size_t>> places = scene::older_entries(before, now.book);
    for (std::size_t i = 0; i < now.book.entries.size(); ++i) {
        const scene::BookEntry& entry = now.book.entries[i];
        for (const scene::BookPicture& picture : entry.pictures) {
            if (interrupted()) return Error{"interrupted: nothing is written", ""};
            const Result<std::string> file = older_picture(before, places[i], picture.camera, options.style);
            ComparedPicture compared;
            if (file.ok()) {
                TRY(compared, compare_picture(book ? old : drawn_to, *file, picture, options.style, folder));
            } else {
                compared.why_not = file.error().what;
            }
            compared.name = entry.name;
            compared.camera = picture.camera;
            compared.file = picture.file;
            difference.pictures.push_back(std::move(compared));
        }
        progress.update(static_cast<double>(i + 1) / static_cast<double>(now.book.entries.size()),
                        steady_now_s(), entry.name);
    }
    progress.finish();
    scene::sort_by_difference(difference.pictures);
    std::error_code code;
    fs::remove_all(drawn_to, code);
    return difference;
}

} // namespace ghost::app
