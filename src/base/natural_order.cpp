// SPDX-License-Identifier: Apache-2.0
#include "base/natural_order.h"

#include <cstddef>

namespace ghost {

bool natural_less(std::string_view a, std::string_view b) {
    const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
    std::size_t i = 0, k = 0;
    while (i < a.size() && k < b.size()) {
        if (!is_digit(a[i]) || !is_digit(b[k])) {
            if (a[i] != b[k]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[k]);
            ++i, ++k;
            continue;
        }
        while (i + 1 < a.size() && a[i] == '0' && is_digit(a[i + 1])) ++i;
        while (k + 1 < b.size() && b[k] == '0' && is_digit(b[k + 1])) ++k;
        std::size_t end = i, other_end = k;
        while (end < a.size() && is_digit(a[end])) ++end;
        while (other_end < b.size() && is_digit(b[other_end])) ++other_end;
        if (end - i != other_end - k) return end - i < other_end - k;
        if (const int order = a.substr(i, end - i).compare(b.substr(k, other_end - k)); order != 0)
            return order < 0;
        i = end, k = other_end;
    }
    // What differs by zeros in front alone is not the same, or later keys of a sort would mix its groups.
    return a.size() - i == b.size() - k ? a < b : a.size() - i < b.size() - k;
}

} // namespace ghost
