// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ghost::scene {
namespace {

constexpr PdfInk kSet{.line_grey = 0.62, .width_pt = 0.25};
constexpr PdfInk kTruss{.line_grey = 0.2, .width_pt = 0.3};
constexpr PdfInk kGrid{.line_grey = 0.86, .width_pt = 0.2};
constexpr PdfInk kGridStrong{.line_grey = 0.72, .width_pt = 0.3};
constexpr PdfInk kAxis{.line_grey = 0.25, .width_pt = 0.5, .dash_pt = 9};
constexpr PdfInk kLeader{.line_grey = 0.45, .width_pt = 0.25};
constexpr PdfInk kBody{.line_grey = 0, .width_pt = 0.35, .fill_grey = 1};
constexpr double kBesideGrid_pt = 26; // for numbers left of the drawing

} // namespace

// As fine as 5 mm on paper allow.
double Drawing::grid_step_m() const {
    const double unit = style_.units == Units::metric ? 1.0 : 0.3048;
    for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0, 1000.0, 5000.0})
        if (step * unit * metre_pt_ >= 5 * kPointsOfMm) return step * unit;
    return 10'000 * unit;
}

void Drawing::draw_grid(const glm::dvec2& offset, const Extent2& window) {
    const double step = grid_step_m();
    const auto draw = [&](int axis) {
        const double low = frame_.low[axis], high = frame_.high[axis];
        for (double k = std::ceil(low / step); k * step <= high; ++k) {
            glm::dvec2 from = frame_.low, to = frame_.high;
            from[axis] = to[axis] = k * step;
            const std::array ends{paper_of(from) + offset, paper_of(to) + offset};
            const bool is_zero = k == 0, is_strong = std::fmod(k, 5) == 0;
            if (!is_zero) pdf_.lines(ends, is_strong ? kGridStrong : kGrid);
        }
    };
    pdf_.begin_clip(window.low.x, window.low.y, window.size().x, window.size().y);
    draw(0);
    draw(1);
    pdf_.end_clip();
    // Numbers along the left and the lower side.
    const double letters_pt = this->letters_pt();
    const double least_pt = 9 * kPointsOfMm * letters_pt / kLeastLetters_pt;
    const double every = std::max(1.0, std::ceil(least_pt / (step * metre_pt_)));
    for (int axis = 0; axis < 2; ++axis)
        for (double k = std::ceil(frame_.low[axis] / step); k * step <= frame_.high[axis]; ++k) {
            if (std::fmod(k, every) != 0) continue;
            glm::dvec2 point = frame_.low;
            point[axis] = k * step;
            const glm::dvec2 at = paper_of(point) + offset;
            if (at[axis] < window.low[axis] - 0.1 || at[axis] > window.high[axis] + 0.1) continue;
            const std::string number = style_.length(k * step);
            PdfText look{
                .size_pt = letters_pt, .is_grey = true, .is_right = axis == 1, .is_middle = axis == 0};
            if (axis == 0) {
                pdf_.line_of_text(at.x - 25, window.high.y + 2, 50, number, look);
                continue;
            }
            if (pdf_.width_of(number, look) > kBesideGrid_pt) look.size_pt = kLeastLetters_pt;
            pdf_.line_of_text(window.low.x - kBesideGrid_pt - 1, at.y - 0.7 * look.size_pt, kBesideGrid_pt,
                              number, look);
        }
}

void Drawing::draw_lines(const glm::dvec2& offset, const Extent2& window) {
    for (const bool is_bar : {false, true}) {
        std::set<std::array<double, 4>> drawn; // objects behind each other have equal lines
        std::vector<glm::dvec2> ends;
        for (const Outline& object : outlines_.objects) {
            if (rigging_.are_slender[object.instance] != is_bar) continue;
            for (std::size_t k = 0; k + 1 < object.ends_m.size(); k += 2) {
                const glm::dvec2 from = paper_of(object.ends_m[k]) + offset;
                const glm::dvec2 to = paper_of(object.ends_m[k + 1]) + offset;
                Extent2 line;
                line.include(from);
                line.include(to);
                if (!line.touches(window) || !drawn.insert({from.x, from.y, to.x, to.y}).second) continue;
                ends.push_back(from);
                ends.push_back(to);
            }
        }
        pdf_.lines(ends, is_bar ? kTruss : kSet);
    }
    // Centre line and set line; in a section set line and floor.
    for (int axis = 0; axis < 2; ++axis) {
        if (frame_.low[axis] > 0 || frame_.high[axis] < 0) continue;
        glm::dvec2 from = frame_.low, to = frame_.high;
        from[axis] = to[axis] = 0;
        const std::array line{paper_of(from) + offset, paper_of(to) + offset};
        pdf_.lines(line, kAxis);
    }
}

void Drawing::draw_rig(const glm::dvec2& offset, const Extent2& window) {
    const auto moved = [&](Extent2 box) {
        box.low += offset;
        box.high += offset;
        return box;
    };
    for (const DrawnLabel& label : labels_) {
        if (!label.is_led || !moved(label.box).touches(window)) continue;
        const glm::dvec2 middle = label.around.middle();
        const glm::dvec2 end = glm::clamp(middle, label.box.low, label.box.high);
        pdf_.lines(std::array{middle + offset, end + offset}, kLeader);
    }
    for (const DrawnSymbol& symbol : symbols_) {
        if (symbol.is_hidden || !moved(symbol.box).touches(window)) continue;
        SymbolPlace place = symbol.place;
        place.at += offset;
        if (!symbol.lines.empty()) {
            std::vector<FlatLine> lines = symbol.lines;
            for (FlatLine& line : lines)
                for (glm::dvec2& point : line.points) point += offset;
            scene::draw_lines(pdf_, lines);
        } else if (symbol.bodies.empty()) {
            draw_symbol(pdf_, symbol.kind, place);
        }
        for (std::vector<glm::dvec2> body : symbol.bodies) {
            for (glm::dvec2& point : body) point += offset;
            pdf_.shape(body, true, kBody);
        }
    }
    for (const DrawnLabel& label : labels_) {
        const Extent2 box = moved(label.box);
        if (!box.touches(window)) continue;
        double y = box.low.y;
        pdf_.fill(box.low.x, box.low.y, box.size().x, box.size().y, 1);
        for (const std::string& line : label.lines) {
            pdf_.line_of_text(box.low.x, y, box.size().x, line, label.look);
            y += label.line_pt();
        }
    }
}

std::vector<Extent2> Drawing::match_words(const Extent2& window, std::size_t column, std::size_t row) const {
    constexpr double kHalf_pt = 0.5 * kSheetOverlap_pt;
    const double least_x = window.low.x + (column > 0 ? kHalf_pt : 0) + 2;
    const double most_x = window.high.x - (column + 1 < columns_ ? kHalf_pt : 0) - 2;
    // A narrow rest of a drawing has less room.
    const glm::dvec2 size_pt(std::clamp(most_x - least_x, 0.0, 80.0), 7.5);
    std::vector<Extent2> boxes;
    const auto add = [&](double wanted_x, double y) {
        const glm::dvec2 low(std::min(wanted_x, most_x - size_pt.x), y);
        boxes.push_back({low, low + size_pt});
    };
    if (column > 0) add(least_x, window.low.y + 12);
    if (column + 1 < columns_) add(most_x - size_pt.x, window.low.y + 20);
    if (row > 0) add(window.middle().x, window.low.y + kHalf_pt + 2);
    if (row + 1 < rows_) add(window.middle().x, window.high.y - kHalf_pt - 9);
    return boxes;
}

void Drawing::draw_match_marks(const Extent2& window, std::size_t column, std::size_t row,
                               std::size_t first) {
    const double half = 0.5 * kSheetOverlap_pt;
    const PdfInk mark{.line_grey = 0, .width_pt = 0.6, .dash_pt = 5};
    const glm::dvec2 low = window.low + half, high = window.high - half;
    std::vector<glm::dvec2> ends;
    std::vector<std::size_t> sheets; // in the order of match_words
    const auto add = [&](const glm::dvec2& from, const glm::dvec2& to, std::size_t x, std::size_t y) {
        ends.insert(ends.end(), {from, to});
        sheets.push_back(first + y * columns_ + x + 1);
    };
    if (column > 0) add({low.x, window.low.y}, {low.x, window.high.y}, column - 1, row);
    if (column + 1 < columns_) add({high.x, window.low.y}, {high.x, window.high.y}, column + 1, row);
    if (row > 0) add({window.low.x, low.y}, {window.high.x, low.y}, column, row - 1);
    if (row + 1 < rows_) add({window.low.x, high.y}, {window.high.x, high.y}, column, row + 1);
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) pdf_.lines(std::span(ends).subspan(k, 2), mark);
    const std::vector<Extent2> boxes = match_words(window, column, row);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const bool is_right = boxes[k].high.x > window.high.x - half - 3;
        const PdfText look{.size_pt = 6, .is_bold = true, .is_right = is_right};
        const std::string number = std::to_string(sheets[k]);
        const std::string words = style_("goes on: sheet %1", {number});
        const bool fits = pdf_.width_of(words, look) <= boxes[k].size().x;
        pdf_.line_of_text(boxes[k].low.x, boxes[k].low.y, boxes[k].size().x, fits ? words : number, look);
    }
}

void Drawing::draw(TitleBlock title, std::size_t first_sheet, std::size_t sheets,
                   const std::vector<LegendLine>& legend, std::size_t& legend_drawn) {
    std::vector<std::string> remarks = notes_;
    if (const std::string boxes = pdf_.boxes_said(style_); !boxes.empty()) remarks.push_back(boxes + ".");
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            const SheetPart& part = parts_[row * columns_ + column];
            const Extent2& window = part.window;
            const glm::dvec2& offset = part.offset;
            draw_grid(offset, window);
            pdf_.begin_clip(window.low.x, window.low.y, window.size().x, window.size().y);
            draw_lines(offset, window);
            draw_rig(offset, window);
            draw_match_marks(window, column, row, first_sheet);
            draw_furniture(part);
            pdf_.end_clip();
            if (!part.scale_bar.is_empty()) draw_scale_bar(part.scale_bar);
            const glm::dvec2 corners[] = {
                window.low, {window.high.x, window.low.y}, window.high, {window.low.x, window.high.y}};
            pdf_.shape(corners, true, {.line_grey = 0.4, .width_pt = 0.4});
            title.sheet = style_("%1 of %2", {std::to_string(first_sheet + row * columns_ + column + 1),
                                              std::to_string(sheets)});
            legend_drawn = draw_column(pdf_, room_, style_, title, legend, remarks);
            if (row == 0 && column == 0) pdf_.mark(title.title);
            pdf_.end_page();
        }
}

} // namespace ghost::scene
