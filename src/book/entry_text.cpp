// SPDX-License-Identifier: Apache-2.0
#include "book/private/entry_text.h"

#include "base/progress.h"
#include "print/quantities.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostLines = 40; // book.json has all

} // namespace

std::string entry_number(const Book& book, std::size_t place) {
    const BookEntry& entry = book.entries[place];
    if (!entry.number.empty()) return entry.number + ". ";
    const bool has_any = std::any_of(book.entries.begin(), book.entries.end(),
                                     [](const BookEntry& one) { return !one.number.empty(); });
    return has_any ? "" : std::to_string(place + 1) + ". ";
}

std::string moment_text(double at_s, const PrintStyle& style) {
    constexpr double kRounding_s = 1e-6; // of 12.48, which is 12.47999...
    const double shown_s = std::floor((at_s + kRounding_s) * 100) / 100, whole_s = std::floor(shown_s);
    const std::string part = style.number(shown_s - whole_s, 2); // "0.5"
    return clock_text(whole_s) + (part.size() > 1 ? part.substr(1) : "");
}

std::string times_text(const BookEntry& entry, const PrintStyle& style) {
    std::string text;
    const auto put = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (entry.at_s && entry.goes_on)
        put(style("goes on where the recording is; drawn at %1", {moment_text(*entry.at_s, style)}));
    else if (entry.at_s)
        put(style("at %1", {moment_text(*entry.at_s, style)}));
    if (!entry.page.empty()) put(style("page %1 of the script", {entry.page}));
    if (!entry.look.empty()) put(style("look '%1'", {entry.look}));
    if (entry.fade_s) put(style("fade %1 s", {style.number(static_cast<double>(*entry.fade_s), 1)}));
    if (entry.follow_s)
        put(style("the next one follows after %1 s",
                  {style.number(static_cast<double>(*entry.follow_s), 1)}));
    return with_whole_quantities(text);
}

std::vector<std::string> change_lines(const BookEntry& entry, const PrintStyle& style) {
    std::vector<std::string> lines;
    for (const BookChange& change : entry.changes) {
        if (lines.size() == kMostLines) break;
        lines.push_back(with_whole_quantities(change.line(style)));
    }
    if (entry.changes.size() > kMostLines)
        lines.push_back(style("and %1 more changes, which book.json has",
                              {std::to_string(entry.changes.size() - kMostLines)}));
    return lines;
}

} // namespace ghost::scene
