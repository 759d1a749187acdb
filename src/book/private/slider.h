#pragma once
// SPDX-License-Identifier: Apache-2.0
// A slider that uncovers one picture below another; it takes the arrow keys. A button shows both by turns,
// each half a second. Pure.

#include "book/book.h"
#include "print/print_style.h"

#include <string>

namespace ghost::scene {

struct SlidPicture {
    std::string file; // below the page's folder
    std::string alt;
    std::string id; // of the element, or ""
};

// size: attributes of the images, " width=..". label: what a reader of screens says of it.
std::string slider_html(const SlidPicture& covered, const SlidPicture& covering, const std::string& size,
                        const std::string& label, const PrintStyle& style);
// " width=.. height=.." of its pictures.
std::string size_of(const Book& book);
// Once on each page that has sliders.
std::string slider_script();

} // namespace ghost::scene
