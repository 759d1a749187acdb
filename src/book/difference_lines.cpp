// SPDX-License-Identifier: Apache-2.0
#include "book/private/difference_lines.h"

namespace ghost::scene {
namespace {

std::string figures_text(const PictureDifference& difference, const PrintStyle& style) {
    if (difference.seen == PictureDifference::Seen::same_pixels) return words_of(difference.seen, style);
    return words_of(difference.seen, style) + " (" + style("mean") + " " + style.number(difference.mean, 3) +
           ", " + style("p99") + " " + style.number(difference.p99, 3) + ", " + style("largest") + " " +
           style.number(difference.max, 3) + ", " + style.number(100.0 * difference.share, 1) + " % " +
           style("of the picture above 0.1") + ")";
}

} // namespace

std::vector<DifferenceLine> lines_of(const BookDifference& difference, const PrintStyle& style) {
    using Rank = DifferenceLine::Rank;
    std::vector<DifferenceLine> lines;
    for (const std::string& sentence : difference.unknown) lines.push_back({Rank::unknown, sentence});
    const auto list = [&](const std::string& heading, const std::vector<std::string>& sentences) {
        lines.push_back({Rank::heading, heading});
        for (const std::string& sentence : sentences) lines.push_back({Rank::sentence, sentence});
        if (sentences.empty()) lines.push_back({Rank::unknown, style("no change")});
    };
    list(style("Entries"), difference.entries);
    list(style("Fixtures"), difference.fixtures);
    lines.push_back({Rank::heading, style("Pictures")});
    for (const ComparedPicture& picture : difference.pictures)
        lines.push_back({Rank::sentence, style("%1 from %2", {picture.name, picture.camera}) + ": " +
                                             (picture.difference ? figures_text(*picture.difference, style)
                                                                 : picture.why_not)});
    if (difference.pictures.empty()) lines.push_back({Rank::unknown, style("none can be compared")});
    return lines;
}

} // namespace ghost::scene
