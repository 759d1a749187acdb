#pragma once
// SPDX-License-Identifier: Apache-2.0
// A slider that uncovers one picture below another; it takes the arrow keys. Pure.

#include "book/book.h"

#include <string>

namespace ghost::scene {

struct SlidPicture {
    std::string file; // below the page's folder
    std::string alt;
    std::string id; // of the element, or ""
};

// size: attributes of the images, " width=..". label: what a reader of screens says of it.
std::string slider_html(const SlidPicture& covered, const SlidPicture& covering, const std::string& size,
                        const std::string& label);
// " width=.. height=.." of its pictures.
std::string size_of(const Book& book);
// Once on each page that has sliders.
std::string slider_script();

} // namespace ghost::scene
