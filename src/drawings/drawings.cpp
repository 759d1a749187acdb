// SPDX-License-Identifier: Apache-2.0
#include "drawings/drawings.h"

#include "drawings/labels.h"
#include "drawings/outlines.h"
#include "drawings/rigging.h"
#include "drawings/sheet.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ghost::scene {
namespace {

constexpr double kMarginOfRig_m = 2, kMarginOfDrawing_m = 0.6;
constexpr double kOverlap_pt = 10 * kPointsOfMm; // of two sheets
constexpr double kFinest_mm = 0.05;              // on paper
constexpr double kLabel_pt = 5.5, kWidestLabel_pt = 95, kLabelLine_pt = 6.8;
constexpr double kLeastSymbol_pt = 3; // smaller ones would be a dot
constexpr double kSamePlace_pt = 2;   // in a section: behind each other

constexpr PdfInk kSet{.line_grey = 0.62, .width_pt = 0.25};
constexpr PdfInk kTruss{.line_grey = 0.2, .width_pt = 0.3};
constexpr PdfInk kGrid{.line_grey = 0.86, .width_pt = 0.2};
constexpr PdfInk kGridStrong{.line_grey = 0.72, .width_pt = 0.3};
constexpr PdfInk kAxis{.line_grey = 0.25, .width_pt = 0.5, .dash_pt = 9};
constexpr PdfInk kLeader{.line_grey = 0.45, .width_pt = 0.25};
constexpr PdfInk kBody{.line_grey = 0, .width_pt = 0.35, .fill_grey = 1};
constexpr PdfText kLabelText{.size_pt = kLabel_pt, .is_middle = true};
constexpr PdfText kBarText{.size_pt = 7, .is_bold = true};
constexpr PdfText kGridText{.size_pt = 5.5, .is_grey = true, .is_middle = true};

// Words beside what they name, in points of the whole drawing.
struct DrawnLabel {
    Extent2 box, around;
    std::vector<std::string> lines;
    bool is_led = false, is_bar = false;
};

struct DrawnSymbol {
    SymbolKind kind = SymbolKind::other;
    SymbolPlace place;
    std::vector<std::vector<glm::dvec2>> bodies; // in a section
    Extent2 box;
};

bool is_finite(const glm::dvec2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

// One drawing, which may take several sheets.
class Drawing {
public:
    Drawing(PdfWriter& pdf, const Show& show, const Stage& stage, const DrawingOptions& options,
            const View& view, bool is_plan, const std::vector<RiggedFixture>& rig)
        : pdf_(pdf), show_(show), stage_(stage), options_(options), style_(options.style), view_(view),
          is_plan_(is_plan), room_(room_on(pdf)) {
        for (const RiggedFixture& fixture : rig)
            if (!view.is_cut_away(show.fixtures[fixture.fixture].position_m) &&
                is_finite(view.flat(show.fixtures[fixture.fixture].position_m)))
                rig_.push_back(fixture);
    }

    Result<std::size_t> lay_out(int& scale);
    void draw(TitleBlock title, std::size_t first_sheet, std::size_t sheets,
              const std::vector<LegendLine>& legend, std::size_t& legend_drawn);

private:
    void choose_frame(const Outlines& rough);
    glm::dvec2 paper_of(const glm::dvec2& point_m) const {
        const glm::dvec2 from = (point_m - frame_.low) * metre_pt_;
        return {from.x, (frame_.size().y * metre_pt_) - from.y};
    }
    Extent2 paper_of(const Extent2& box) const {
        Extent2 result;
        result.include(paper_of(box.low));
        result.include(paper_of(box.high));
        return result;
    }
    void place_symbols();
    void place_bars(Labels& labels);
    void place_labels(Labels& labels);
    std::vector<std::string> words_of(const std::vector<std::size_t>& group) const;
    void put(Labels& labels, DrawnLabel label, std::vector<std::string>* without);
    std::vector<std::string> notes(const std::vector<std::string>& without) const;
    void draw_grid(const glm::dvec2& offset, const Extent2& window);
    void draw_lines(const glm::dvec2& offset, const Extent2& window);
    void draw_rig(const glm::dvec2& offset, const Extent2& window);
    void draw_scale_bar(const Extent2& window);
    void draw_match_marks(const Extent2& window, std::size_t column, std::size_t row, std::size_t first);
    double grid_step_m() const;

    PdfWriter& pdf_;
    const Show& show_;
    const Stage& stage_;
    const DrawingOptions& options_;
    const PrintStyle& style_;
    View view_;
    bool is_plan_;
    SheetRoom room_;
    std::vector<RiggedFixture> rig_;
    Extent2 frame_; // metres
    double metre_pt_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    Outlines outlines_;
    std::vector<bool> slender_;
    std::vector<DrawnSymbol> symbols_;
    std::vector<DrawnLabel> labels_;
    std::vector<std::string> notes_;
};

// All fixtures and whatever of the stage lies among them; of what is larger the part that is there.
void Drawing::choose_frame(const Outlines& rough) {
    Extent2 rig;
    for (const RiggedFixture& fixture : rig_)
        rig.include(view_.flat(show_.fixtures[fixture.fixture].position_m));
    if (rig.is_empty())
        for (const Outline& object : rough.objects) rig.include(object.extent);
    if (rig.is_empty()) rig.include(glm::dvec2(0));
    rig.grow(kMarginOfRig_m);
    if (!is_plan_) rig.include(glm::dvec2(rig.middle().x, 0)); // the floor
    frame_ = rig;
    for (const Outline& object : rough.objects)
        if (rig.holds(object.extent) || (slender_[object.instance] && rig.touches(object.extent)))
            frame_.include(object.extent);
    frame_.grow(kMarginOfDrawing_m);
}

Result<std::size_t> Drawing::lay_out(int& scale) {
    slender_ = slender_instances(stage_);
    choose_frame(outlines_of(stage_, view_, 0.02));
    const glm::dvec2 room = room_.drawing.size();
    const int fits = fitting_scale(frame_.size(), room, style_.units);
    scale = options_.scale.value_or(fits);
    metre_pt_ = points_of_metre(scale);
    const glm::dvec2 size = frame_.size() * metre_pt_;
    const auto sheets_for = [](double length, double of_sheet) {
        return length <= of_sheet ? 1.0 : std::ceil((length - kOverlap_pt) / (of_sheet - kOverlap_pt));
    };
    const double columns = sheets_for(size.x, room.x), rows = sheets_for(size.y, room.y);
    if (columns * rows > static_cast<double>(kMostSheets))
        return Error{"a drawing at 1:" + std::to_string(scale) + " would take " +
                         number_text(static_cast<float>(columns * rows), 0) + " sheets of " +
                         std::string(format_of(options_.paper).name) + ", at most " +
                         std::to_string(kMostSheets) + " are made; 1:" + std::to_string(fits) +
                         " fits on one",
                     show_.file.string()};
    columns_ = static_cast<std::size_t>(columns);
    rows_ = static_cast<std::size_t>(rows);
    outlines_ = outlines_of(stage_, view_, kFinest_mm * 1e-3 * scale);
    place_symbols();
    Labels labels({{0, 0}, size});
    for (const DrawnSymbol& symbol : symbols_) labels.keep_free(symbol.box);
    place_bars(labels);
    place_labels(labels);
    return columns_ * rows_;
}

// In a plan the way that a fixture's own axes point; where one stands upright, the other says it.
SymbolPlace place_of(const RiggedFixture& fixture, const View& view) {
    const auto flat_way = [&](int axis) {
        const glm::dvec2 way = view.flat(glm::vec3(fixture.to_world[axis]));
        return glm::dvec2(way.x, -way.y); // down the page
    };
    SymbolPlace place;
    const glm::dvec2 x = flat_way(0), y = flat_way(1), z = flat_way(2);
    if (glm::length(x) > 0.3)
        place.right = glm::normalize(x);
    else if (glm::length(y) > 0.3)
        place.right = glm::normalize(glm::dvec2(-y.y, y.x));
    place.front = {place.right.y, -place.right.x};
    // A lamp that is fixed looks along its beam.
    const glm::dvec2 beam = -z;
    const bool is_fixed = fixture.kind == SymbolKind::profile || fixture.kind == SymbolKind::wash ||
                          fixture.kind == SymbolKind::projector;
    if (is_fixed && glm::length(beam) > 0.2) {
        place.front = glm::normalize(beam);
        place.right = {-place.front.y, place.front.x};
    } else if (glm::dot(place.front, y) < 0) {
        place.front = -place.front;
    }
    return place;
}

void Drawing::place_symbols() {
    std::vector<std::vector<std::vector<glm::dvec2>>> bodies;
    if (!is_plan_) bodies = bodies_seen(show_, stage_, view_);
    for (const RiggedFixture& fixture : rig_) {
        DrawnSymbol& symbol = symbols_.emplace_back();
        symbol.kind = fixture.kind;
        symbol.place = place_of(fixture, view_);
        symbol.place.at = paper_of(view_.flat(show_.fixtures[fixture.fixture].position_m));
        symbol.place.size_pt = glm::max(fixture.size_m * metre_pt_, glm::dvec2(kLeastSymbol_pt));
        if (!is_plan_)
            for (const auto& body : bodies[fixture.fixture]) {
                auto& drawn = symbol.bodies.emplace_back();
                for (const glm::dvec2& point : body) {
                    drawn.push_back(paper_of(point));
                    symbol.box.include(drawn.back());
                }
            }
        if (!symbol.bodies.empty()) continue;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                symbol.box.include(symbol.place.at + x * symbol.place.size_pt.x * symbol.place.right +
                                   y * symbol.place.size_pt.y * symbol.place.front);
    }
}

void Drawing::put(Labels& labels, DrawnLabel label, std::vector<std::string>* without) {
    double width = 0;
    const PdfText& look = label.is_bar ? kBarText : kLabelText;
    for (const std::string& line : label.lines) width = std::max(width, pdf_.width_of(line, look));
    const double line_pt = label.is_bar ? 9 : kLabelLine_pt;
    const glm::dvec2 size(std::min(width, label.is_bar ? 2 * kWidestLabel_pt : kWidestLabel_pt) + 1.5,
                          line_pt * static_cast<double>(label.lines.size()));
    if (const auto placed = labels.place(size, label.around)) {
        label.box = placed->box;
        label.is_led = placed->is_led;
        labels_.push_back(std::move(label));
    } else if (without) {
        without->push_back(label.lines.front());
    }
}

// "Truss 1, z = 6.40 m, 10 m long"; positions without a truss at their first fixture.
void Drawing::place_bars(Labels& labels) {
    std::map<std::string, bool> named;
    std::vector<glm::dvec2> places;
    for (const HungBar& bar : hung_bars(show_, stage_, rig_)) {
        named[bar.name] = true;
        const glm::dvec2 from = paper_of(view_.flat(bar.bar.from_m)), to = paper_of(view_.flat(bar.bar.to_m));
        const glm::dvec2 end = from.x <= to.x ? from : to;
        const bool is_known = std::any_of(places.begin(), places.end(), [&](const glm::dvec2& other) {
            return glm::distance(other, end) < kSamePlace_pt;
        });
        if (is_known) continue; // behind another one
        places.push_back(end);
        DrawnLabel label;
        label.is_bar = true;
        label.around.include(end);
        label.around.grow(2);
        label.lines = {bar.name + ", z = " + style_.length_said(static_cast<double>(bar.bar.from_m.z)) +
                       (is_plan_ ? ", " + style_.length_said(static_cast<double>(bar.bar.length_m())) : "")};
        put(labels, std::move(label), nullptr);
    }
    for (std::size_t i = 0; i < rig_.size(); ++i) {
        if (rig_[i].position.empty() || named[rig_[i].position]) continue;
        named[rig_[i].position] = true;
        DrawnLabel label;
        label.is_bar = true;
        label.around = symbols_[i].box;
        label.lines = {rig_[i].position};
        put(labels, std::move(label), nullptr);
    }
}

std::vector<std::string> Drawing::words_of(const std::vector<std::size_t>& group) const {
    const auto called = [&](const RiggedFixture& fixture) {
        const PatchedFixture& patched = show_.fixtures[fixture.fixture];
        return patched.fixture_id.empty() ? patched.name : "(" + patched.fixture_id + ")";
    };
    const RiggedFixture& first = rig_[group.front()];
    const PatchedFixture& patched = show_.fixtures[first.fixture];
    if (group.size() == 1) {
        const std::string unit = first.unit.empty() ? "" : "[" + first.unit + "] ";
        std::vector<std::string> lines{unit + called(first)};
        if (patched.address > 0) lines.push_back(address_text(patched.universe, patched.address));
        return lines;
    }
    std::vector<std::string> names;
    for (const std::size_t i : group) {
        const PatchedFixture& one = show_.fixtures[rig_[i].fixture];
        names.push_back(one.fixture_id.empty() ? one.name : one.fixture_id);
    }
    std::stable_sort(names.begin(), names.end(), natural_less);
    return {std::to_string(group.size()) + ": " + names_text(names)};
}

void Drawing::place_labels(Labels& labels) {
    // What lies behind each other has one label.
    std::map<std::pair<long, long>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < rig_.size(); ++i) {
        const glm::dvec2 cell = symbols_[i].place.at / kSamePlace_pt;
        groups[{std::lround(std::clamp(cell.x, -1e9, 1e9)), std::lround(std::clamp(cell.y, -1e9, 1e9))}]
            .push_back(i);
    }
    std::vector<std::string> without;
    for (const auto& [cell, group] : groups) {
        DrawnLabel label;
        for (const std::size_t i : group) label.around.include(symbols_[i].box);
        label.lines = words_of(group);
        put(labels, std::move(label), &without);
    }
    notes_ = notes(without);
}

std::vector<std::string> Drawing::notes(const std::vector<std::string>& without) const {
    std::vector<std::string> said;
    said.push_back(style_("Beside a symbol: [number on the position] (channel) universe.address."));
    if (is_plan_)
        said.push_back(
            style_("Symbols stand for what a type does, as large as its body, turned as it hangs."));
    if (show_.fixtures.empty()) said.push_back(style_("The show has no fixtures."));
    if (stage_.instances.empty())
        said.push_back(style_("The show has no stage model: trusses and set are not drawn."));
    std::size_t sizeless = 0, typeless = 0;
    for (const RiggedFixture& fixture : rig_) {
        if (!fixture.is_size_known) ++sizeless;
        if (fixture.kind == SymbolKind::not_known) ++typeless;
    }
    if (typeless > 0)
        said.push_back(
            style_("What a type does is not known of %1: its file could not be read, or says nothing.",
                   {std::to_string(typeless)}));
    if (sizeless > 0)
        said.push_back(style_("Size not known of %1: drawn %2 wide.",
                              {std::to_string(sizeless), style_.length_said(kAssumedSize_m)}));
    if (!without.empty())
        said.push_back(style_("No room for the words beside %1; the instrument schedule has them.",
                              {std::to_string(without.size())}));
    if (outlines_.simplified > 0)
        said.push_back(
            style_("Simplified to their outermost line: %1 of %2 objects.",
                   {std::to_string(outlines_.simplified), std::to_string(outlines_.objects.size())}));
    if (outlines_.left_out > 0)
        said.push_back(style_("Objects that are not drawn, for there are too many: %1.",
                              {std::to_string(outlines_.left_out)}));
    return said;
}

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
                pdf_.line_of_text(window.low.x - 14, at.y - 4, 13, number,
                                  {.size_pt = 5.5, .is_grey = true, .is_right = true});
        }
}

void Drawing::draw_lines(const glm::dvec2& offset, const Extent2& window) {
    for (const bool is_bar : {false, true}) {
        std::vector<glm::dvec2> ends;
        for (const Outline& object : outlines_.objects) {
            if (slender_[object.instance] != is_bar) continue;
            for (std::size_t k = 0; k + 1 < object.ends_m.size(); k += 2) {
                const glm::dvec2 from = paper_of(object.ends_m[k]) + offset;
                const glm::dvec2 to = paper_of(object.ends_m[k + 1]) + offset;
                Extent2 line;
                line.include(from);
                line.include(to);
                if (!line.touches(window)) continue;
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
        if (!moved(symbol.box).touches(window)) continue;
        SymbolPlace place = symbol.place;
        place.at += offset;
        if (symbol.bodies.empty()) draw_symbol(pdf_, symbol.kind, place);
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
    const double half = 0.5 * kOverlap_pt;
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
    const glm::dvec2 size = frame_.size() * metre_pt_, room = room_.drawing.size();
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            Extent2 window = room_.drawing;
            const glm::dvec2 step = room - kOverlap_pt;
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
            legend_drawn = draw_column(pdf_, room_, style_, title, legend, notes_);
            if (row == 0 && column == 0) pdf_.mark(title.title);
            pdf_.end_page();
        }
}

std::string type_text(const PatchedFixture& fixture) {
    if (!fixture.type) return "";
    return fixture.type->manufacturer + (fixture.type->manufacturer.empty() ? "" : " ") + fixture.type->name;
}

std::vector<LegendLine> legend_of(const Show& show, const std::vector<RiggedFixture>& rig) {
    std::map<std::pair<int, std::string>, std::size_t> counts;
    for (const RiggedFixture& fixture : rig)
        ++counts[{static_cast<int>(fixture.kind), type_text(show.fixtures[fixture.fixture])}];
    std::vector<LegendLine> legend;
    for (const auto& [key, count] : counts)
        legend.push_back({static_cast<SymbolKind>(key.first), key.second, count});
    return legend;
}

} // namespace

Result<Drawings> drawings_of(const Show& show, const Stage& stage, const DrawingOptions& options) {
    const PrintStyle& style = options.style;
    const std::vector<RiggedFixture> rig = rigged_fixtures(show, stage);
    const std::vector<LegendLine> legend = legend_of(show, rig);
    TitleBlock title;
    title.show = show.name.empty() ? show.folder.filename().string() : show.name;
    title.paper = std::string(format_of(options.paper).name);
    title.date = options.date;
    PdfWriter pdf(options.paper, true, title.show + ": " + style("Plan"));
    Drawings made;
    Drawing plan(pdf, show, stage, options, from_above(), true, rig);
    Drawing section(pdf, show, stage, options, from_the_side(options.section_x_m), false, rig);
    TRY(const std::size_t of_plan, plan.lay_out(made.plan_scale));
    TRY(const std::size_t of_section, section.lay_out(made.section_scale));
    made.sheets = of_plan + of_section;
    std::size_t legend_drawn = 0;
    title.title = style("Plan");
    title.remark = style("seen from above, up-stage at the top");
    title.scale = scale_text(made.plan_scale);
    plan.draw(title, 0, made.sheets, legend, legend_drawn);
    title.title = options.section_x_m ? style("Section at x = %1", {style.length_said(*options.section_x_m)})
                                      : style("Section");
    title.remark = style("seen from stage left, the house at the left");
    title.scale = scale_text(made.section_scale);
    section.draw(title, of_plan, made.sheets, legend, legend_drawn);
    if (legend_drawn < legend.size()) draw_legend_sheet(pdf, style, legend, legend_drawn, title);
    TRY(made.pdf, pdf.finish());
    return made;
}

} // namespace ghost::scene
