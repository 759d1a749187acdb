// SPDX-License-Identifier: Apache-2.0
#include "book/private/entry_text.h"

#include "base/progress.h"
#include "print/quantities.h"

namespace ghost::scene {
namespace {

constexpr std::size_t kMostLines = 40; // book.json has all

} // namespace

std::string entry_number(const BookEntry& entry, std::size_t place) {
    return entry.number.empty() ? std::to_string(place + 1) : entry.number;
}

std::string times_text(const BookEntry& entry, const PrintStyle& style) {
    std::string text;
    const auto put = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (entry.at_s && entry.goes_on)
        put(style("goes on where the recording is; drawn at %1", {clock_text(*entry.at_s)}));
    else if (entry.at_s)
        put(style("at %1", {clock_text(*entry.at_s)}));
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
        lines.push_back(with_whole_quantities(change.line()));
    }
    if (entry.changes.size() > kMostLines)
        lines.push_back(style("and %1 more changes, which book.json has",
                              {std::to_string(entry.changes.size() - kMostLines)}));
    return lines;
}

} // namespace ghost::scene
