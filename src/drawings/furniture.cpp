// SPDX-License-Identifier: Apache-2.0
// What stands on each sheet of a drawing beside the drawing itself: its scale bar, which way the house is,
// and the names of its lines.
#include "drawings/private/drawing.h"

#include <algorithm>
#include <array>

namespace ghost::scene {
namespace {

constexpr double kScaleLetters_pt = 6, kWays_pt = 7;
constexpr double kLargeLetters_pt = 7; // on sheets that are read from farther away
constexpr double kInset_pt = 2;        // from the edge of a drawing
constexpr int kScaleSteps = 3;
constexpr std::array kAlongLine{0.0, 1.0, 0.15, 0.3,  0.45, 0.6,  0.75,
                                0.9, 0.1, 0.2,  0.25, 0.5,  0.35, 0.8}; // places of a name, of its line
constexpr double kBelowGrid_pt = 10; // what stands below the numbers of the grid

} // namespace

double Drawing::letters_pt() const {
    const bool is_large = options_.paper == PaperSize::a1 || options_.paper == PaperSize::a2 ||
                          options_.paper == PaperSize::arch_d;
    return is_large ? kLargeLetters_pt : kLeastLetters_pt;
}

SheetPart Drawing::part_at(std::size_t column, std::size_t row) const {
    const glm::dvec2 size = frame_.size() * metre_pt_, room = room_.drawing.size();
    const glm::dvec2 place(static_cast<double>(column), static_cast<double>(row));
    SheetPart part;
    part.window = room_.drawing;
    part.offset = room_.drawing.low - place * (room - kSheetOverlap_pt);
    for (int axis = 0; axis < 2; ++axis)
        if ((axis == 0 ? columns_ : rows_) == 1) { // all of it, in the middle
            part.offset[axis] += 0.5 * (room[axis] - size[axis]);
            part.window.low[axis] = part.offset[axis];
            part.window.high[axis] = part.offset[axis] + size[axis];
        } else {
            part.window.high[axis] = std::min(part.window.high[axis], part.offset[axis] + size[axis]);
        }
    return part;
}

std::optional<Extent2> Drawing::free_of_symbols(std::span<const Extent2> places,
                                                const SheetPart& part) const {
    for (const Extent2& place : places) {
        const bool is_taken = place.touches(part.scale_bar) ||
                              std::any_of(part.words.begin(), part.words.end(),
                                          [&](const EdgeWords& words) { return words.box.touches(place); });
        if (is_taken || !part.window.holds(place)) continue;
        const bool is_free = std::none_of(symbols_.begin(), symbols_.end(), [&](const DrawnSymbol& symbol) {
            return Extent2{symbol.box.low + part.offset, symbol.box.high + part.offset}.touches(place);
        });
        if (is_free) return place;
    }
    return std::nullopt;
}

bool Drawing::furnish(Labels& labels) {
    const auto box_at = [](const glm::dvec2& low, const glm::dvec2& size) {
        return Extent2{low, low + size};
    };
    const double bar_pt = kScaleSteps * scale_step_m() * metre_pt_;
    parts_.clear();
    wordless_ = 0;
    bool have_bars = true;
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            SheetPart& part = parts_.emplace_back(part_at(column, row));
            const Extent2& window = part.window;
            // Between two opposite sides of the window, so far from the first as share says.
            const auto between = [&](int axis, double share, const glm::dvec2& size) {
                return window.low[axis] + kInset_pt +
                       share * (window.size()[axis] - size[axis] - 2 * kInset_pt);
            };
            for (const Extent2& box : match_words(window, column, row)) part.words.push_back({box, "", {}});
            const glm::dvec2 bar_size(bar_pt + 32, 20);
            std::vector<Extent2> places;
            for (const double y : {1.0, 0.0})
                for (const double x : {1.0, 0.0, 0.5})
                    places.push_back(box_at({between(0, x, bar_size), between(1, y, bar_size)}, bar_size));
            // A narrow rest of a drawing would cut it; the sheet beside it has one.
            if (columns_ == 1 || window.size().x >= bar_size.x + 2 * kInset_pt) {
                const auto place =
                    is_bar_below_
                        ? box_at({window.high.x - bar_size.x, window.high.y + kBelowGrid_pt}, bar_size)
                        : free_of_symbols(places, part).value_or(Extent2{});
                have_bars = have_bars && !place.is_empty();
                part.scale_bar = place;
            }
            const auto add = [&](const std::string& text, const PdfText& look, const auto& place_at) {
                const glm::dvec2 size(pdf_.width_of(text, look) + 2, kLineOfText * look.size_pt);
                std::vector<Extent2> choice;
                for (const double share : kAlongLine) choice.push_back(box_at(place_at(share, size), size));
                if (const auto box = free_of_symbols(choice, part))
                    part.words.push_back({*box, text, look});
                else
                    ++wordless_;
            };
            const PdfText ways{.size_pt = kWays_pt, .is_bold = true, .is_grey = true};
            const auto along_edge = [&](double y) {
                return [&, y](double share, const glm::dvec2& size) {
                    // Beside the centre line first.
                    const double from_quarter = share + 0.25 > 1 ? share - 0.75 : share + 0.25;
                    return glm::dvec2(between(0, from_quarter, size), between(1, y, size));
                };
            };
            if (is_plan_ && row + 1 == rows_) add(style_("HOUSE"), ways, along_edge(1));
            if (is_plan_ && row == 0) add(style_("UP-STAGE"), ways, along_edge(0));
            if (!is_plan_ && column == 0)
                add(style_("HOUSE"), ways, [&](double share, const glm::dvec2& size) {
                    return glm::dvec2(between(0, 0, size), between(1, share, size));
                });
            const PdfText names{.size_pt = letters_pt(), .is_grey = true};
            for (int axis = 0; axis < 2; ++axis) {
                const double at = paper_of(glm::dvec2(0))[axis] + part.offset[axis];
                if (at < window.low[axis] || at > window.high[axis]) continue;
                const Word name = axis == 1 ? (is_plan_ ? Word("set line, y = 0") : Word("stage, z = 0"))
                                            : (is_plan_ ? Word("centre line") : Word("set line, y = 0"));
                add(style_(name), names, [&](double share, const glm::dvec2& size) {
                    return axis == 0 ? glm::dvec2(at + kInset_pt, between(1, share, size))
                                     : glm::dvec2(between(0, share, size), at - 1 - size.y);
                });
            }
            if (!part.scale_bar.is_empty())
                labels.keep_free({part.scale_bar.low - part.offset, part.scale_bar.high - part.offset});
            for (const EdgeWords& words : part.words)
                labels.keep_free({words.box.low - part.offset, words.box.high - part.offset});
        }
    return have_bars;
}

double Drawing::scale_step_m() const {
    const double unit = style_.units == Units::metric ? 1.0 : 0.3048;
    double step = 0.1 * unit;
    for (const double next : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0, 1000.0, 5000.0})
        if (step * metre_pt_ < 10 * kPointsOfMm) step = next * unit;
    return step;
}

void Drawing::draw_furniture(const SheetPart& part) {
    for (const EdgeWords& words : part.words) {
        if (words.text.empty()) continue; // of match marks
        pdf_.fill(words.box.low.x, words.box.low.y, words.box.size().x, words.box.size().y, 1);
        pdf_.line_of_text(words.box.low.x + 1, words.box.low.y, words.box.size().x, words.text, words.look);
    }
}

void Drawing::draw_scale_bar(const Extent2& box) {
    const double step = scale_step_m(), length = step * metre_pt_;
    const double x = box.low.x + 8, y = box.low.y + 12;
    pdf_.fill(box.low.x, box.low.y, box.size().x, box.size().y, 1);
    for (int k = 0; k < kScaleSteps; ++k) {
        const Extent2 piece{{x + k * length, y}, {x + (k + 1) * length, y + 3}};
        const glm::dvec2 corners[] = {
            piece.low, {piece.high.x, piece.low.y}, piece.high, {piece.low.x, piece.high.y}};
        pdf_.shape(corners, true, {.width_pt = 0.4, .fill_grey = k % 2 == 0 ? 0.0 : 1.0});
    }
    for (int k = 0; k <= kScaleSteps; ++k)
        pdf_.line_of_text(x + k * length - 20, y - 9, 40,
                          k < kScaleSteps ? style_.length(k * step) : style_.length_said(k * step),
                          {.size_pt = kScaleLetters_pt, .is_middle = true});
}

} // namespace ghost::scene
