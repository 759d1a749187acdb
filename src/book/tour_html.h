#pragma once
// SPDX-License-Identifier: Apache-2.0
// The page of a tour: the looks of a show from its cameras, for a client: any two of them under one slider,
// what changed since an older version, a film. Opens from file://, asks nothing of a network. Pure, any
// thread.

#include "book/book.h"
#include "book/difference.h"
#include "print/print_style.h"

#include <string>

namespace ghost::scene {

struct TourPage {
    PrintStyle style;
    std::string title; // "": the name of the show
    std::string note;  // a line below it
    std::string film;  // "film.mp4", or "": none
};

// What of a book a client gets: pictures, names and times; notes only where they are asked for.
Book for_client(Book book, bool has_notes);

// book: all entries have pictures from the same cameras. difference: or null.
std::string tour_html(const Book& book, const BookDifference* difference, const TourPage& page);

} // namespace ghost::scene
