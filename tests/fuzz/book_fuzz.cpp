// SPDX-License-Identifier: Apache-2.0
// book.json of an older book, and what becomes of it; difference.json beside it.
#include "book/book_html.h"
#include "book/book_json.h"
#include "book/difference.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto files = ghost::scene::files_of_difference(text, "fuzz"); files.ok())
        for (const std::string& file : *files)
            if (file.find("..") != std::string::npos || file.front() == '/') std::abort();
    const auto book = ghost::scene::book_from(text, "fuzz");
    if (!book.ok()) return 0;
    const ghost::scene::BookDifference difference = ghost::scene::difference_of(*book, *book);
    (void)ghost::scene::html_of(*book, &difference, ghost::scene::PaperSize::a4);
    return 0;
}
