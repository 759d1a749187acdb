#pragma once
// SPDX-License-Identifier: Apache-2.0
// What paper says of the difference from an older book, a line below the other. Pure.

#include "book/difference.h"
#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

struct DifferenceLine {
    enum class Rank { heading, sentence, unknown };
    Rank rank = Rank::sentence;
    std::string text;
};

// Without the title. Pictures in their order, those that differ most first, each with its figures.
std::vector<DifferenceLine> lines_of(const BookDifference& difference, const PrintStyle& style);

} // namespace ghost::scene
