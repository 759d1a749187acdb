// SPDX-License-Identifier: Apache-2.0
// book.json of an older book, and what becomes of it.
#include "book/book_html.h"
#include "book/book_json.h"
#include "book/difference.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto book = ghost::scene::book_from({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!book.ok()) return 0;
    const ghost::scene::BookDifference difference = ghost::scene::difference_of(*book, *book);
    (void)ghost::scene::html_of(*book, &difference, ghost::scene::PaperSize::a4);
    return 0;
}
