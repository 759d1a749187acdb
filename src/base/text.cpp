// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <limits>

namespace ghost {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::size_t letter_bytes(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
    return end - at;
}

} // namespace

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

bool matches(std::string_view pattern, std::string_view name) {
    std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
    return matches(pattern, name, steps);
}

bool matches(std::string_view pattern, std::string_view name, std::uint64_t& steps) {
    if (steps == 0) return false;
    --steps;
    std::size_t p = 0;
    std::size_t n = 0;
    std::size_t star = std::string_view::npos; // where the last * stands, and what it has swallowed so far
    std::size_t swallowed = 0;
    while (n < name.size()) {
        if (steps == 0) return false;
        --steps;
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            swallowed = n;
            if (p == pattern.size()) return true; // whatever follows
        } else if (p < pattern.size() && pattern[p] == '?') {
            ++p;
            n += letter_bytes(name, n);
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            swallowed += letter_bytes(name, swallowed);
            n = swallowed;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::string name_list(const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t k = 0; k < names.size() && k < kShown; ++k) {
        if (k > 0) text += ", ";
        text += "'" + names[k].substr(0, 80) + "'";
    }
    if (names.size() > kShown) text += " and " + std::to_string(names.size() - kShown) + " more";
    return text;
}

} // namespace ghost
