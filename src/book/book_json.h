#pragma once
// SPDX-License-Identifier: Apache-2.0
// book.json: a Book as text and back. An older one is read to compare a book with it, so it comes from
// outside: sizes are limited, and names of pictures stay below the book's folder. Equal books give equal
// bytes. Any thread.

#include "base/result.h"
#include "book/book.h"
#include "book/difference.h"

#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

inline constexpr std::size_t kMostBookBytes = std::size_t{256} << 20;

std::string text_of(const Book& book);
// Error: no JSON, no book, one of another version, or a picture that lies elsewhere.
Result<Book> book_from(std::string_view text, const std::string& where);

// difference.json beside it, for pages that show it.
std::string text_of(const BookDifference& difference);
// The pictures that such a text names. Error: as above.
Result<std::vector<std::string>> files_of_difference(std::string_view text, const std::string& where);

} // namespace ghost::scene
