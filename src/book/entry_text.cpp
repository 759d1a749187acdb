// SPDX-License-Identifier: Apache-2.0
#include "book/private/entry_text.h"

#include "base/progress.h"
#include "book/quantities.h"

namespace ghost::scene {
namespace {

constexpr std::size_t kMostLines = 40; // book.json has all

} // namespace

std::string times_text(const BookEntry& entry) {
    std::string text;
    const auto put = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (entry.at_s && entry.goes_on)
        put("goes on where the recording is; drawn at " + clock_text(*entry.at_s));
    else if (entry.at_s)
        put("at " + clock_text(*entry.at_s));
    if (!entry.look.empty()) put("look '" + entry.look + "'");
    if (entry.fade_s) put("fade " + number_text(*entry.fade_s, 1) + " s");
    if (entry.follow_s) put("the next one follows after " + number_text(*entry.follow_s, 1) + " s");
    return text;
}

std::vector<std::string> change_lines(const BookEntry& entry) {
    std::vector<std::string> lines;
    for (const BookChange& change : entry.changes) {
        if (lines.size() == kMostLines) break;
        lines.push_back(change.line());
    }
    if (entry.changes.size() > kMostLines)
        lines.push_back("and " + std::to_string(entry.changes.size() - kMostLines) +
                        " more changes, which book.json has");
    return lines;
}

std::string changes_text(const BookEntry& entry) {
    if (entry.changes.empty()) return "nothing that is seen";
    std::string text;
    for (const std::string& line : change_lines(entry)) text += (text.empty() ? "" : "\n") + line;
    return text;
}

} // namespace ghost::scene
