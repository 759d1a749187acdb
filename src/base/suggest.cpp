// SPDX-License-Identifier: Apache-2.0
#include "base/suggest.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace ghost {
namespace {

constexpr std::size_t kLooked = 64; // letters

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitute = diagonal + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
        }
    }
    return row[b.size()];
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    return Suggestions().did_you_mean(word, candidates);
}

std::string Suggestions::did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    word = word.substr(0, kLooked);
    std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates) {
        const std::string_view other = std::string_view(candidate).substr(0, kLooked);
        const std::size_t longer = std::max(word.size(), other.size());
        const bool is_far = longer - std::min(word.size(), other.size()) >= best;
        const std::size_t cost = is_far ? 1 : (word.size() + 1) * (other.size() + 1);
        if (cost > left_) {
            left_ = 0;
            return "";
        }
        left_ -= cost;
        if (is_far) continue;
        const std::size_t distance = edit_distance(word, other);
        if (distance < best) {
            best = distance;
            nearest = &candidate;
        }
    }
    return nearest ? ", did you mean '" + *nearest + "'?" : "";
}

} // namespace ghost
