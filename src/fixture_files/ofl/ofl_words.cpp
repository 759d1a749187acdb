// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/ofl/private/ofl_words.h"

#include "base/text.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::string_view kMaster[] = {"all", "master", "main", "global", "general", "total", "overall"};
constexpr std::string_view kLight[] = {
    "red",    "green",  "blue",  "white", "amber", "uv",    "lime",      "cyan",       "magenta",   "yellow",
    "indigo", "violet", "warm",  "cold",  "cool",  "color", "colour",    "led",        "intensity", "dimmer",
    "dim",    "level",  "value", "light", "fine",  "msb",   "luminance", "brightness", "channel"};
constexpr std::string_view kPlace[] = {"left",   "right",  "top",   "bottom", "front", "back", "rear",
                                       "middle", "center", "upper", "lower",  "inner", "outer"};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

template <class List>
bool is_in(const List& list, std::string_view word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

} // namespace

std::vector<std::string> ofl_words(std::string_view name) {
    std::vector<std::string> words;
    char before = ' ';
    for (const char c : lower(std::string(name))) {
        const bool counts = is_digit(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 128;
        const bool starts = before == ' ' || is_digit(c) != is_digit(before);
        if (counts && starts) words.emplace_back();
        if (counts) words.back() += c;
        before = counts ? c : ' ';
    }
    return words;
}

bool ofl_is_master(std::string_view name) {
    const std::vector<std::string> words = ofl_words(name);
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) { return is_in(kMaster, word); });
}

std::string ofl_label(std::string_view name) {
    std::string label;
    for (const std::string& word : ofl_words(name))
        if (!is_in(kLight, word)) label += (label.empty() ? "" : " ") + word;
    return label;
}

bool ofl_is_place(std::string_view label) {
    return std::all_of(label.begin(), label.end(), is_digit) || label.size() == 1 || is_in(kPlace, label);
}

bool ofl_has_label(std::string_view name, std::string_view label) {
    const std::vector<std::string> words = ofl_words(name);
    const std::vector<std::string> wanted = ofl_words(label);
    return !wanted.empty() && std::all_of(wanted.begin(), wanted.end(),
                                          [&](const std::string& word) { return is_in(words, word); });
}

} // namespace ghost::fixture
