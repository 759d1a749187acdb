#pragma once
// SPDX-License-Identifier: Apache-2.0
// Draws the pictures of a cue book: every entry at rest, from its cameras, all under one exposure, with the
// air of time 0 and films at the second of the entry; and says what changed from one to the next. The same
// show gives the same bytes. Main thread.

#include "base/result.h"
#include "book/book.h"
#include "book/book_plan.h"
#include "live/session/session.h"
#include "print/print_style.h"
#include "show/camera.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {

struct BookOptions {
    SessionOptions session;
    scene::BookKind kind = scene::BookKind::by_itself;
    std::string marks;              // file of kind marks
    double mark_fps = 0;            // of time code in it; 0: nobody says it
    std::vector<std::string> views; // empty: where the cues have put the picture
    scene::PrintStyle style;
    // Of a tour: without views from all cameras; entries whose picture would be of something else are left
    // out, which is said; fixtures are counted, not named.
    bool is_for_client = false;
    std::vector<std::string> only; // names of entries; empty: all
    int width = 640, height = 360;
};

// What two versions of a show are drawn with, so that they can be compared.
struct BookFrame {
    std::vector<scene::Camera> cameras;
    float ev100 = 0;
};

struct DrawnBook {
    scene::Book book;
    BookFrame frame;
    std::string values_csv; // BookValues
};

// folder: gets the pictures, in its folder "pictures", which is there. frame: instead of the show's own.
// Error: no such show or camera, nothing to draw, interrupted, a full disk.
Result<DrawnBook> draw_book(const BookOptions& options, const std::filesystem::path& folder,
                            const BookFrame* frame);

} // namespace ghost::app
