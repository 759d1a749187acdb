#pragma once
// SPDX-License-Identifier: Apache-2.0
// A cue book against an older one: OLD is the folder of a book, or a show, which is then drawn as the new one
// was. Main thread.

#include "base/result.h"
#include "book/difference.h"
#include "cli/render/book_drawing.h"
#include "disk/whole_folder.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ghost::app {

// The book that lies there; nothing: it is no folder of a book. Error: it is one that cannot be read.
Result<std::optional<scene::Book>> old_book(const std::filesystem::path& folder);

// Pictures that differ are copied to "old", where they differ is drawn to "differences". book: the older one,
// or nothing: `old` is a show.
Result<scene::BookDifference> compare_books(const BookOptions& options, const DrawnBook& now,
                                            const std::filesystem::path& old,
                                            const std::optional<scene::Book>& book,
                                            const WholeFolder& folder);

} // namespace ghost::app
