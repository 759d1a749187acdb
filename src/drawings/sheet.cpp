// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/sheet.h"

#include <algorithm>
#include <array>

namespace ghost::scene {
namespace {

constexpr double kMargin_pt = 10 * kPointsOfMm;
constexpr double kNumbers_pt = 7 * kPointsOfMm; // of the grid, left of the drawing and below it
constexpr double kTitle_pt = 44 * kPointsOfMm;  // height of the block
constexpr double kPad_pt = 4;
constexpr double kLine_pt = 17; // of the legend
constexpr double kLegendSymbol_pt = 24, kLegendCount_pt = 26;
constexpr double kSecondLine_pt = 8, kTwoLines_pt = 17; // of a long type
constexpr double kNote_pt = 60, kNoteGap_pt = 2;
constexpr double kMoreNote_pt = 20; // says what is not in the legend: two lines

constexpr PdfInk kFrame{.line_grey = 0, .width_pt = 1};
constexpr PdfInk kThin{.line_grey = 0.3, .width_pt = 0.4};
constexpr PdfText kHead{.size_pt = 9, .is_bold = true};
constexpr PdfText kWords{.size_pt = 6.5};
constexpr PdfText kSmall{.size_pt = 6, .is_grey = true};

void rectangle(PdfWriter& pdf, const Extent2& box, const PdfInk& ink) {
    const glm::dvec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    pdf.shape(corners, true, ink);
}

// Into a box of the page.
std::vector<FlatLine> fitted(std::vector<FlatLine> lines, const glm::dvec2& middle, const glm::dvec2& room) {
    Extent2 all;
    for (const FlatLine& line : lines)
        for (const glm::dvec2& point : line.points) all.include(point);
    const glm::dvec2 size = glm::max(all.size(), glm::dvec2(1e-6));
    const double scale = std::min(room.x / size.x, room.y / size.y);
    for (FlatLine& line : lines)
        for (glm::dvec2& point : line.points) {
            const glm::dvec2 from = (point - all.middle()) * scale;
            point = middle + glm::dvec2(from.x, -from.y);
        }
    return lines;
}

std::string type_of(const PrintStyle& style, const LegendLine& line) {
    return line.type.empty() ? style("file not read") : line.type;
}

double legend_line_pt(PdfWriter& pdf, const PrintStyle& style, const LegendLine& line, double width) {
    const double room = width - kLegendSymbol_pt - kLegendCount_pt;
    return kLine_pt + (pdf.width_of(type_of(style, line), kWords) > room ? kSecondLine_pt : 0);
}

// A long type takes two lines. The height that all of it takes.
double draw_legend_line(PdfWriter& pdf, const PrintStyle& style, const LegendLine& line, double x, double y,
                        double width) {
    const bool is_long = line.kind == SymbolKind::bar || line.kind == SymbolKind::wall;
    const glm::dvec2 middle(x + 10, y + 0.5 * kLine_pt);
    if (line.lines.empty())
        draw_symbol(pdf, line.kind, {middle, {1, 0}, {0, -1}, is_long ? glm::dvec2(18, 4) : glm::dvec2(12)});
    else
        draw_lines(pdf, fitted(line.lines, middle, {18, 15}));
    const double words = x + kLegendSymbol_pt, count = kLegendCount_pt;
    const double room = width - kLegendSymbol_pt - count;
    const std::string type = type_of(style, line);
    const double more = legend_line_pt(pdf, style, line, width) - kLine_pt;
    if (more > 0)
        pdf.text(words, y + 1, room, kTwoLines_pt, type, kWords);
    else
        pdf.line_of_text(words, y + 1, room, type, kWords);
    const std::string kind = style(word_of(line.kind));
    pdf.line_of_text(words, y + 8.5 + more, room,
                     line.lines.empty() ? kind : style("%1, symbol of its file", {kind}), kSmall);
    pdf.line_of_text(x + width - count, y + 3, count, std::to_string(line.count),
                     {.size_pt = 8, .is_right = true});
    return kLine_pt + more;
}

void draw_title(PdfWriter& pdf, const Extent2& box, const PrintStyle& style, const TitleBlock& title) {
    rectangle(pdf, box, kFrame);
    const double x = box.low.x + kPad_pt, width = box.size().x - 2 * kPad_pt;
    double y = box.low.y + kPad_pt;
    y += pdf.text(x, y, width, 26, title.show, kHead) + 1;
    pdf.line_of_text(x, y, width, title.title, {.size_pt = 12, .is_bold = true});
    y += 16;
    y += pdf.text(x, y, width, 18, title.remark, kSmall);
    const std::array<std::pair<Word, const std::string*>, 4> rows{{{Word("scale"), &title.scale},
                                                                   {Word("paper"), &title.paper},
                                                                   {Word("date"), &title.date},
                                                                   {Word("sheet"), &title.sheet}}};
    y = box.high.y - 4 * 10.5 - 2;
    for (const auto& [word, value] : rows) {
        pdf.lines(std::array{glm::dvec2(box.low.x, y), glm::dvec2(box.high.x, y)}, kThin);
        pdf.line_of_text(x, y + 1.5, 0.35 * width, style(word), kSmall);
        pdf.line_of_text(x + 0.35 * width, y + 0.5, 0.65 * width, *value, {.size_pt = 7.5, .is_bold = true});
        y += 10.5;
    }
}

} // namespace

SheetRoom room_on(const PdfWriter& pdf) {
    const double width = std::min(62 * kPointsOfMm, 0.24 * pdf.width_pt());
    const glm::dvec2 high(pdf.width_pt() - kMargin_pt, pdf.height_pt() - kMargin_pt);
    SheetRoom room;
    room.column = {{high.x - width, kMargin_pt}, high};
    room.drawing = {{kMargin_pt + kNumbers_pt, kMargin_pt + 2},
                    {high.x - width - kPad_pt, high.y - kNumbers_pt}};
    return room;
}

std::size_t draw_column(PdfWriter& pdf, const SheetRoom& room, const PrintStyle& style,
                        const TitleBlock& title, const std::vector<LegendLine>& legend,
                        const std::vector<std::string>& notes) {
    rectangle(pdf, {{kMargin_pt, kMargin_pt}, room.column.high}, kFrame);
    const Extent2 block{{room.column.low.x, room.column.high.y - kTitle_pt}, room.column.high};
    draw_title(pdf, block, style, title);
    pdf.lines(std::array{room.column.low, glm::dvec2(room.column.low.x, room.column.high.y)}, kFrame);
    const double x = room.column.low.x + kPad_pt, width = room.column.size().x - 2 * kPad_pt;
    double y = room.column.low.y + kPad_pt;
    pdf.line_of_text(x, y, width, style("Legend"), kHead);
    y += 14;
    // What is not known is always said: its room comes first.
    double end = block.low.y - kNoteGap_pt - kMoreNote_pt; // of the legend
    for (const std::string& note : notes) end -= pdf.height_of(width, kNote_pt, note, kSmall) + kNoteGap_pt;
    std::size_t drawn = 0;
    for (; drawn < legend.size() && y + legend_line_pt(pdf, style, legend[drawn], width) < end; ++drawn)
        y += draw_legend_line(pdf, style, legend[drawn], x, y, width);
    std::vector<std::string> all = notes;
    if (drawn < legend.size())
        all.insert(all.begin(),
                   style("%1 kinds more: see the last sheet.", {std::to_string(legend.size() - drawn)}));
    for (const std::string& note : all)
        y += pdf.text(x, y, width, std::min(kNote_pt, block.low.y - y - kNoteGap_pt), note, kSmall) +
             kNoteGap_pt;
    return drawn;
}

void draw_legend_sheet(PdfWriter& pdf, const PrintStyle& style, const std::vector<LegendLine>& legend,
                       std::size_t from, const TitleBlock& title) {
    const double top = kMargin_pt + 24, width = 200,
                 end = pdf.height_pt() - kMargin_pt - kLine_pt - kSecondLine_pt;
    const auto begin = [&] {
        pdf.line_of_text(kMargin_pt, kMargin_pt, pdf.width_pt() - 2 * kMargin_pt,
                         title.show + ": " + style("Legend"), {.size_pt = 12, .is_bold = true});
    };
    begin();
    double x = kMargin_pt, y = top;
    for (std::size_t k = from; k < legend.size(); ++k) {
        if (y > end) {
            y = top;
            x += width + 12;
        }
        if (x + width > pdf.width_pt() - kMargin_pt) {
            pdf.end_page();
            begin();
            x = kMargin_pt;
        }
        y += draw_legend_line(pdf, style, legend[k], x, y, width);
    }
    pdf.end_page();
}

std::string scale_text(int scale) {
    constexpr std::pair<int, const char*> kFeet[] = {{12, "1\""},   {16, "3/4\""},   {24, "1/2\""},
                                                     {32, "3/8\""}, {48, "1/4\""},   {64, "3/16\""},
                                                     {96, "1/8\""}, {128, "3/32\""}, {192, "1/16\""}};
    std::string text = "1:" + std::to_string(scale);
    for (const auto& [of, inches] : kFeet)
        if (of == scale) text += std::string(" (") + inches + " = 1'-0\")";
    return text;
}

std::optional<int> fitting_scale(const glm::dvec2& size_m, const glm::dvec2& room_pt, Units units) {
    constexpr std::array kMetric{10,  20,  25,   50,   75,   100,    125,    200,
                                 250, 500, 1000, 2000, 5000, 10'000, 20'000, 50'000};
    constexpr std::array kFeet{12,  16,  24,  32,  48,   64,   96,     128,
                               192, 384, 768, 960, 1536, 6144, 12'288, 49'152};
    const auto& scales = units == Units::metric ? kMetric : kFeet;
    for (const int scale : scales)
        if (size_m.x * points_of_metre(scale) <= room_pt.x && size_m.y * points_of_metre(scale) <= room_pt.y)
            return scale;
    return std::nullopt;
}

} // namespace ghost::scene
