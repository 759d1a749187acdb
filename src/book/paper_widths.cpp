// SPDX-License-Identifier: Apache-2.0
#include "book/private/paper_widths.h"

#include <algorithm>
#include <numeric>

namespace ghost::scene {

std::vector<const std::string*> longest_cells(const PaperTable& table, std::size_t column, std::size_t most) {
    std::vector<const std::string*> cells;
    cells.reserve(table.rows.size());
    for (const PaperRow& row : table.rows) cells.push_back(&row.cells[column]);
    const auto is_longer = [](const std::string* a, const std::string* b) { return a->size() > b->size(); };
    if (cells.size() > most) {
        std::nth_element(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(most), cells.end(),
                         is_longer);
        cells.resize(most);
    }
    return cells;
}

std::vector<double> shared_widths(const std::vector<PaperColumn>& columns, std::vector<double> wanted,
                                  double page, double least) {
    const auto sum = [&] { return std::accumulate(wanted.begin(), wanted.end(), 0.0); };
    std::vector<double*> texts; // the narrowest first
    double of_texts = 0;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k].is_number || columns[k].is_whole) continue;
        texts.push_back(&wanted[k]);
        of_texts += wanted[k];
    }
    std::sort(texts.begin(), texts.end(), [](const double* a, const double* b) { return *a < *b; });
    if (sum() <= page) return wanted;
    double left = page - (sum() - of_texts);
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const double share = std::max(least, left / static_cast<double>(texts.size() - k));
        *texts[k] = std::min(*texts[k], share);
        left -= *texts[k];
    }
    if (const double all = sum(); all > page)
        for (double& width : wanted) width *= page / all;
    return wanted;
}

} // namespace ghost::scene
