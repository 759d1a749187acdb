#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a book will show, before anything is drawn: its entries in order, each with the second of the
// recording, the look on top of it and the camera that the cues have led to. Pure, any thread.

#include "base/result.h"
#include "book/book.h"
#include "book/marks.h"
#include "print/print_style.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct StoredLook; // show/looks.h

enum class BookKind { by_itself, cues, looks, marks, found };

struct PlannedEntry {
    BookEntry entry;                 // without pictures and changes
    std::optional<std::size_t> look; // of the looks
    std::string camera;              // "": the first one
    bool is_other = false;           // its picture is of something else: what the cue names is not there
};

struct BookPlan {
    std::string kind; // Book::kind
    std::vector<PlannedEntry> entries;
    std::vector<std::string> unknown;
};

// found_s: where the recording comes to rest (rests.h). by_itself: cues, else looks, else what was found,
// else the show as it is. Error: none of the kind that was asked for, or more than a book holds.
Result<BookPlan> plan_book(const Show& show, const std::vector<StoredLook>& looks, BookKind kind,
                           const std::vector<double>& found_s, const PrintStyle& style = {},
                           const std::vector<Mark>& marks = {});

} // namespace ghost::scene
