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
constexpr PdfText kGridText{.size_pt = 5.5, .is_grey = true, .is_middle = true};

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
    const double least_pt = 9 * kPointsOfMm;
    const double every = std::max(1.0, std::ceil(least_pt / (step * metre_pt_)));
    for (int axis = 0; axis < 2; ++axis)
        for (double k = std::ceil(frame_.low[axis] / step); k * step <= frame_.high[axis]; ++k) {
            if (std::fmod(k, every) != 0) continue;
            glm::dvec2 point = frame_.low;
            point[axis] = k * step;
            const glm::dvec2 at = paper_of(point) + offset;
            if (at[axis] < window.low[axis] - 0.1 || at[axis] > window.high[axis] + 0.1) continue;
            const std::string number = style_.length(k * step);
            if (axis == 0)
                pdf_.line_of_text(at.x - 20, window.high.y + 2, 40, number, kGridText);
            else
                pdf_.line_of_text(window.low.x - 27, at.y - 4, 26, number,
                                  {.size_pt = 5.5, .is_grey = true, .is_right = true});
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
        const std::string name = is_plan_ ? (axis == 0 ? style_("centre line") : style_("set line, y = 0"))
                                          : (axis == 0 ? style_("set line, y = 0") : style_("stage, z = 0"));
        const glm::dvec2 at = axis == 0 ? glm::dvec2(line[0].x + 2, window.low.y + 2)
                                        : glm::dvec2(window.low.x + 3, line[0].y - 8);
        pdf_.line_of_text(at.x, at.y, 90, name, {.size_pt = 5.5, .is_grey = true});
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
            pdf_.line_of_text(box.low.x, y, box.size().x, line, label.is_bar ? kBarText : kLabelText);
            y += kLabelLine_pt;
        }
    }
}

void Drawing::draw_scale_bar(const Extent2& window) {
    const double unit = style_.units == Units::metric ? 1.0 : 0.3048;
    double step = 0.1 * unit;
    for (const double next : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0, 1000.0, 5000.0})
        if (step * metre_pt_ < 10 * kPointsOfMm) step = next * unit;
    const double length = step * metre_pt_, x = window.high.x - 3 * length - 26, y = window.high.y - 10;
    pdf_.fill(x - 8, y - 12, 3 * length + 32, 20, 1);
    for (int k = 0; k < 3; ++k) {
        const Extent2 box{{x + k * length, y}, {x + (k + 1) * length, y + 3}};
        const glm::dvec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
        pdf_.shape(corners, true, {.width_pt = 0.4, .fill_grey = k % 2 == 0 ? 0.0 : 1.0});
    }
    for (int k = 0; k <= 3; ++k)
        pdf_.line_of_text(x + k * length - 20, y - 9, 40,
                          k < 3 ? style_.length(k * step) : style_.length_said(k * step),
                          {.size_pt = 6, .is_middle = true});
}

void Drawing::draw_match_marks(const Extent2& window, std::size_t column, std::size_t row,
                               std::size_t first) {
    const auto sheet = [&](std::size_t x, std::size_t y) {
        return style_("goes on: sheet %1", {std::to_string(first + y * columns_ + x + 1)});
    };
    const double half = 0.5 * kSheetOverlap_pt;
    const PdfInk mark{.line_grey = 0, .width_pt = 0.6, .dash_pt = 5};
    const PdfText look{.size_pt = 6, .is_bold = true};
    if (column > 0)
        pdf_.lines(
            std::array{window.low + glm::dvec2(half, 0), glm::dvec2(window.low.x + half, window.high.y)},
            mark);
    if (column > 0)
        pdf_.line_of_text(window.low.x + half + 2, window.low.y + 12, 120, sheet(column - 1, row), look);
    if (column + 1 < columns_) {
        pdf_.lines(
            std::array{glm::dvec2(window.high.x - half, window.low.y), window.high - glm::dvec2(half, 0)},
            mark);
        pdf_.line_of_text(window.high.x - half - 122, window.low.y + 20, 120, sheet(column + 1, row),
                          {.size_pt = 6, .is_bold = true, .is_right = true});
    }
    if (row > 0) {
        pdf_.lines(
            std::array{window.low + glm::dvec2(0, half), glm::dvec2(window.high.x, window.low.y + half)},
            mark);
        pdf_.line_of_text(window.middle().x, window.low.y + half + 2, 120, sheet(column, row - 1), look);
    }
    if (row + 1 < rows_) {
        pdf_.lines(
            std::array{glm::dvec2(window.low.x, window.high.y - half), window.high - glm::dvec2(0, half)},
            mark);
        pdf_.line_of_text(window.middle().x, window.high.y - half - 9, 120, sheet(column, row + 1), look);
    }
}

void Drawing::draw(TitleBlock title, std::size_t first_sheet, std::size_t sheets,
                   const std::vector<LegendLine>& legend, std::size_t& legend_drawn) {
    std::vector<std::string> notes = notes_;
    if (const std::string boxes = pdf_.boxes_said(style_); !boxes.empty()) notes.push_back(boxes + ".");
    const glm::dvec2 size = frame_.size() * metre_pt_, room = room_.drawing.size();
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            Extent2 window = room_.drawing;
            const glm::dvec2 step = room - kSheetOverlap_pt;
            const glm::dvec2 place(static_cast<double>(column), static_cast<double>(row));
            glm::dvec2 offset = room_.drawing.low - place * step;
            // In the middle where one sheet has all of it.
            for (int axis = 0; axis < 2; ++axis)
                if ((axis == 0 ? columns_ : rows_) == 1) {
                    offset[axis] += 0.5 * (room[axis] - size[axis]);
                    window.low[axis] = offset[axis];
                    window.high[axis] = offset[axis] + size[axis];
                } else {
                    window.high[axis] = std::min(window.high[axis], offset[axis] + size[axis]);
                }
            draw_grid(offset, window);
            pdf_.begin_clip(window.low.x, window.low.y, window.size().x, window.size().y);
            draw_lines(offset, window);
            draw_rig(offset, window);
            draw_match_marks(window, column, row, first_sheet);
            const PdfText ways{.size_pt = 7, .is_bold = true, .is_grey = true, .is_middle = true};
            const double ways_x = window.low.x + 0.25 * window.size().x - 60; // beside the centre line
            if (is_plan_ && row + 1 == rows_)
                pdf_.line_of_text(ways_x, window.high.y - 11, 120, style_("HOUSE"), ways);
            if (is_plan_ && row == 0)
                pdf_.line_of_text(ways_x, window.low.y + 2, 120, style_("UP-STAGE"), ways);
            if (!is_plan_ && column == 0)
                pdf_.line_of_text(window.low.x + 3, window.low.y + 2, 120, style_("HOUSE"),
                                  {.size_pt = 7, .is_bold = true, .is_grey = true});
            draw_scale_bar(window);
            pdf_.end_clip();
            const glm::dvec2 corners[] = {
                window.low, {window.high.x, window.low.y}, window.high, {window.low.x, window.high.y}};
            pdf_.shape(corners, true, {.line_grey = 0.4, .width_pt = 0.4});
            title.sheet = style_("%1 of %2", {std::to_string(first_sheet + row * columns_ + column + 1),
                                              std::to_string(sheets)});
            legend_drawn = draw_column(pdf_, room_, style_, title, legend, notes);
            if (row == 0 && column == 0) pdf_.mark(title.title);
            pdf_.end_page();
        }
}

} // namespace ghost::scene
