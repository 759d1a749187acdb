// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/drawing.h"

#include "base/natural_order.h"
#include "print/quantities.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ghost::scene {
namespace {

constexpr double kMarginOfRig_m = 2, kMarginOfDrawing_m = 0.6;
constexpr double kFinest_mm = 0.05; // on paper
constexpr double kWidestLabel = 17; // times the height of its letters
constexpr double kWidestBarLabel_pt = 190;
constexpr double kLeastSymbol_pt = 3; // smaller ones would be a dot
constexpr double kBarBelow_pt = 20;   // beside what the grid's numbers leave below a drawing
constexpr double kSamePlace_pt = 2;   // in a section: behind each other

bool is_finite(const glm::dvec2& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
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

} // namespace

Drawing::Drawing(PdfWriter& pdf, const Show& show, const Stage& stage, const DrawingOptions& options,
                 const View& view, bool is_plan, const Rigging& rigging, FileSymbols& file_symbols)
    : pdf_(pdf), show_(show), stage_(stage), options_(options), style_(options.style), view_(view),
      is_plan_(is_plan), rigging_(rigging), file_symbols_(file_symbols), room_(room_on(pdf)) {
    for (const RiggedFixture& fixture : rigging.fixtures)
        if (!view.is_cut_away(show.fixtures[fixture.fixture].position_m) &&
            is_finite(view.flat(show.fixtures[fixture.fixture].position_m)))
            rig_.push_back(fixture);
}

// All fixtures and whatever of the stage lies among them; of what is larger the part that is there.
void Drawing::choose_frame(const Outlines& rough) {
    Extent2 rig;
    for (const RiggedFixture& fixture : rig_) {
        for (std::size_t k = 0; !is_plan_ && k < bodies_[fixture.fixture].size(); ++k)
            for (const glm::dvec2& point : bodies_[fixture.fixture][k]) rig.include(point);
        if (!is_plan_ && !bodies_[fixture.fixture].empty()) continue;
        const glm::dvec2 at = view_.flat(show_.fixtures[fixture.fixture].position_m);
        const SymbolPlace place = place_of(fixture, view_);
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) {
                const glm::dvec2 off =
                    x * fixture.size_m.x * place.right + y * fixture.size_m.y * place.front;
                rig.include(at + glm::dvec2(off.x, -off.y)); // a page runs down
            }
    }
    if (rig.is_empty())
        for (const Outline& object : rough.objects) rig.include(object.extent);
    if (rig.is_empty()) rig.include(glm::dvec2(0));
    rig.grow(kMarginOfRig_m);
    if (!is_plan_) rig.include(glm::dvec2(rig.middle().x, 0)); // the floor
    frame_ = rig;
    for (const Outline& object : rough.objects)
        if (rig.holds(object.extent) || (rigging_.are_slender[object.instance] && rig.touches(object.extent)))
            frame_.include(object.extent);
    frame_.grow(kMarginOfDrawing_m);
}

Result<std::size_t> Drawing::lay_out(int& scale) {
    if (!is_plan_) bodies_ = bodies_seen(show_, stage_, view_);
    choose_frame(outlines_of(stage_, view_, 0.02));
    TRY_VOID(spread(scale));
    const auto labels_of = [&] {
        Labels labels({{0, 0}, frame_.size() * metre_pt_});
        for (const DrawnSymbol& symbol : symbols_) labels.keep_free(symbol.box);
        return labels;
    };
    Labels labels = labels_of();
    if (!furnish(labels)) {
        is_bar_below_ = true;
        room_.drawing.high.y -= kBarBelow_pt;
        TRY_VOID(spread(scale));
        labels = labels_of();
        (void)furnish(labels);
    }
    outlines_ = outlines_of(stage_, view_, kFinest_mm * 1e-3 * scale);
    place_bars(labels);
    place_labels(labels);
    return columns_ * rows_;
}

Result<void> Drawing::spread(int& scale) {
    const glm::dvec2 room = room_.drawing.size();
    const std::optional<int> fits = fitting_scale(frame_.size(), room, style_.units);
    const std::string format(format_of(options_.paper).name);
    const double longest_m = std::max(frame_.size().x, frame_.size().y);
    const std::string none_fits = (rig_.empty() ? "the stage is " : "the fixtures lie ") +
                                  number_text(static_cast<float>(longest_m), 0) + " m " +
                                  (rig_.empty() ? "long" : "apart") +
                                  ": no scale up to 1:50000 fits on a sheet of " + format;
    if (!options_.scale && !fits) return Error{none_fits, show_.file.string()};
    scale = options_.scale ? *options_.scale : *fits;
    metre_pt_ = points_of_metre(scale);
    const glm::dvec2 size = frame_.size() * metre_pt_;
    const auto sheets_for = [](double length, double of_sheet) {
        return length <= of_sheet ? 1.0
                                  : std::ceil((length - kSheetOverlap_pt) / (of_sheet - kSheetOverlap_pt));
    };
    const double columns = sheets_for(size.x, room.x), rows = sheets_for(size.y, room.y);
    if (columns * rows > static_cast<double>(kMostSheets))
        return Error{"a drawing at 1:" + std::to_string(scale) + " would take " +
                         number_text(static_cast<float>(columns * rows), 0) + " sheets of " + format +
                         ", at most " + std::to_string(kMostSheets) + " are made; " +
                         (fits ? "1:" + std::to_string(*fits) + " fits on one" : none_fits),
                     show_.file.string()};
    columns_ = static_cast<std::size_t>(columns);
    rows_ = static_cast<std::size_t>(rows);
    place_symbols();
    return {};
}

void Drawing::place_symbols() {
    symbols_.clear();
    is_any_enlarged_ = false;
    for (const RiggedFixture& fixture : rig_) {
        DrawnSymbol& symbol = symbols_.emplace_back();
        symbol.kind = fixture.kind;
        symbol.place = place_of(fixture, view_);
        symbol.place.at = paper_of(view_.flat(show_.fixtures[fixture.fixture].position_m));
        symbol.place.size_pt = glm::max(fixture.size_m * metre_pt_, glm::dvec2(kLeastSymbol_pt));
        if (!is_plan_)
            for (const auto& body : bodies_[fixture.fixture]) {
                auto& drawn = symbol.bodies.emplace_back();
                for (const glm::dvec2& point : body) {
                    drawn.push_back(paper_of(point));
                    symbol.box.include(drawn.back());
                }
            }
        if (is_plan_) take_lines(fixture, symbol);
        if (!symbol.bodies.empty() || !symbol.lines.empty()) continue;
        is_any_enlarged_ = is_any_enlarged_ || symbol.place.size_pt != fixture.size_m * metre_pt_;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                symbol.box.include(symbol.place.at + x * symbol.place.size_pt.x * symbol.place.right +
                                   y * symbol.place.size_pt.y * symbol.place.front);
    }
    hide_what_is_behind();
}

// Of a row of lamps in a section there is one to be seen; all of them would be ink upon ink.
void Drawing::hide_what_is_behind() {
    const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    };
    const auto bodies_before = [&](const DrawnSymbol* a, const DrawnSymbol* b) {
        return std::lexicographical_compare(a->bodies.begin(), a->bodies.end(), b->bodies.begin(),
                                            b->bodies.end(), [&](const auto& body, const auto& other) {
                                                return std::lexicographical_compare(body.begin(), body.end(),
                                                                                    other.begin(),
                                                                                    other.end(), before);
                                            });
    };
    std::set<const DrawnSymbol*, decltype(bodies_before)> seen(bodies_before);
    for (auto symbol = symbols_.rbegin(); symbol != symbols_.rend(); ++symbol)
        symbol->is_hidden = !symbol->bodies.empty() && !seen.insert(&*symbol).second;
}

// Of the fixture's own file.
void Drawing::take_lines(const RiggedFixture& fixture, DrawnSymbol& symbol) {
    symbol.lines = file_symbols_.seen(show_.fixtures[fixture.fixture], fixture.to_world, view_);
    for (FlatLine& line : symbol.lines)
        for (glm::dvec2& point : line.points) {
            point = symbol.place.at + glm::dvec2(point.x, -point.y) * metre_pt_;
            symbol.box.include(point);
        }
}

bool Drawing::put(Labels& labels, DrawnLabel label, double widest_pt, std::vector<DrawnLabel>& placed) {
    double width = 0;
    for (const std::string& line : label.lines) {
        width = std::max(width, pdf_.width_of(line, label.look));
        pdf_.look_for_boxes(line);
    }
    const glm::dvec2 size(std::min(width, widest_pt) + 1.5,
                          label.line_pt() * static_cast<double>(label.lines.size()));
    const auto place = labels.place(size, label.around);
    if (!place) return false;
    label.box = place->box;
    label.is_led = place->is_led;
    placed.push_back(std::move(label));
    return true;
}

// All of a bar's thickness at one of its ends, of which its line is the middle of the underside.
Extent2 Drawing::end_of(const Bar& bar, const glm::vec3& end_m) const {
    Extent2 box;
    for (const float x : {-0.5f, 0.5f})
        for (const float y : {-0.5f, 0.5f})
            for (const float z : {0.0f, 1.0f})
                box.include(paper_of(
                    view_.flat(end_m + glm::vec3(x * bar.across_m, y * bar.across_m, z * bar.height_m))));
    return box;
}

// "Truss 1, underside 6.40 m, length 10 m"; of a long name alone something may be cut.
std::vector<std::string> Drawing::words_of(const HungBar& bar) {
    const std::string underside = style_.length_said(static_cast<double>(bar.bar.from_m.z));
    const std::string length = style_.length_said(static_cast<double>(bar.bar.length_m()));
    // From end to end is no length of what is bent.
    const bool has_length = is_plan_ && bar.bar.bow_m == 0;
    const std::string line = has_length ? style_("%1, underside %2, length %3", {bar.name, underside, length})
                                        : style_("%1, underside %2", {bar.name, underside});
    if (pdf_.width_of(line, kBarText) <= kWidestBarLabel_pt) return {line};
    return {bar.name, has_length ? style_("underside %1, length %2", {underside, length})
                                 : style_("underside %1", {underside})};
}

// Each truss at its left end; positions without a truss at their first fixture.
void Drawing::place_bars(Labels& labels) {
    std::map<std::string, bool> named;
    std::vector<glm::dvec2> places;
    for (const HungBar& bar : rigging_.bars) {
        if (view_.is_cut_away(bar.bar.from_m) && view_.is_cut_away(bar.bar.to_m)) continue;
        named[bar.name] = true;
        const glm::dvec2 from = paper_of(view_.flat(bar.bar.from_m)), to = paper_of(view_.flat(bar.bar.to_m));
        const glm::dvec2 end = from.x <= to.x ? from : to;
        const bool is_known = std::any_of(places.begin(), places.end(), [&](const glm::dvec2& other) {
            return glm::distance(other, end) < kSamePlace_pt;
        });
        if (is_known) continue; // behind another one
        places.push_back(end);
        DrawnLabel label;
        label.look = kBarText;
        label.around = end_of(bar.bar, from.x <= to.x ? bar.bar.from_m : bar.bar.to_m);
        label.around.grow(2);
        label.lines = words_of(bar);
        if (!put(labels, std::move(label), kWidestBarLabel_pt, labels_)) ++unnamed_bars_;
    }
    for (std::size_t i = 0; i < rig_.size(); ++i) {
        if (rig_[i].position.empty() || named[rig_[i].position]) continue;
        named[rig_[i].position] = true;
        DrawnLabel label;
        label.look = kBarText;
        label.around = symbols_[i].box;
        label.lines = {rig_[i].position};
        if (!put(labels, std::move(label), kWidestBarLabel_pt, labels_)) ++unnamed_bars_;
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
    return {std::to_string(group.size()) + ": " + names_text(names, style_)};
}

void Drawing::place_labels(Labels& labels) {
    // What lies behind each other has one label.
    std::map<std::pair<long, long>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < rig_.size(); ++i) {
        const glm::dvec2 cell = symbols_[i].place.at / kSamePlace_pt;
        groups[{std::lround(std::clamp(cell.x, -1e9, 1e9)), std::lround(std::clamp(cell.y, -1e9, 1e9))}]
            .push_back(i);
    }
    // As large as a sheet is read best, smaller where more of them find room then.
    std::vector<DrawnLabel> best;
    std::size_t fewest = groups.size() + 1;
    for (const double letters_pt : {this->letters_pt(), kLeastLetters_pt}) {
        Labels taken = labels;
        std::vector<DrawnLabel> placed;
        std::size_t without = 0;
        for (const auto& [cell, group] : groups) {
            DrawnLabel label;
            label.look = {.size_pt = letters_pt, .is_middle = true};
            for (const std::size_t i : group) label.around.include(symbols_[i].box);
            label.lines = words_of(group);
            // Cut, a list of numbers would end in a wrong one.
            if (group.size() > 1 &&
                pdf_.width_of(label.lines.front(), label.look) > kWidestLabel * letters_pt)
                label.lines = {style_("%1: see the instrument schedule", {std::to_string(group.size())})};
            if (!put(taken, std::move(label), kWidestLabel * letters_pt, placed)) ++without;
        }
        if (without < fewest) {
            fewest = without;
            best = std::move(placed);
        }
        if (without == 0 || letters_pt == kLeastLetters_pt) break;
    }
    labels_.insert(labels_.end(), best.begin(), best.end());
    notes_ = notes(fewest);
}

std::vector<std::string> Drawing::notes(std::size_t unlabelled) const {
    std::vector<std::string> said;
    const std::string least = style_.number(kLeastSymbol_pt, 0);
    said.push_back(style_("Beside a symbol: [number on the position] (channel) universe.address."));
    const auto of_files = std::count_if(symbols_.begin(), symbols_.end(),
                                        [](const DrawnSymbol& one) { return !one.lines.empty(); });
    if (of_files > 0)
        said.push_back(style_("Symbols are those of the fixtures' own files (GDTF) where they have one."));
    if (is_plan_ && of_files == 0)
        said.push_back(
            is_any_enlarged_
                ? style_("Symbols stand for what a type does, as large as its body but at least %1 points, "
                         "turned as it hangs.",
                         {least})
                : style_("Symbols stand for what a type does, as large as its body, turned as it hangs."));
    if (is_plan_ && of_files > 0 && of_files < std::ssize(symbols_))
        said.push_back(is_any_enlarged_
                           ? style_("Symbols without such a file stand for what a type does, as large as its "
                                    "body but at least %1 points, turned as it hangs.",
                                    {least})
                           : style_("Symbols without such a file stand for what a type does, as large as its "
                                    "body, turned as it hangs."));
    if (show_.fixtures.empty()) said.push_back(style_("The show has no fixtures."));
    // Bodies of lamps are no stage.
    if (std::all_of(stage_.instances.begin(), stage_.instances.end(),
                    [](const Instance& one) { return one.fixture != kNone; }))
        said.push_back(style_("The show has no stage model: trusses and set are not drawn."));
    std::vector<std::string> placeless, turnless;
    for (const PatchedFixture& fixture : show_.fixtures) {
        if (!fixture.is_place_known)
            placeless.push_back(fixture.name);
        else if (!fixture.is_rotation_known)
            turnless.push_back(fixture.name);
    }
    if (!placeless.empty())
        said.push_back(style_("Not drawn, for nobody says a place that can be used: %1.",
                              {names_text(placeless, style_)}));
    if (!turnless.empty())
        said.push_back(style_("Drawn as if they hung upright, for nobody says how they are turned: %1.",
                              {names_text(turnless, style_)}));
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
    if (unlabelled > 0)
        said.push_back(style_("No room for the words beside %1; the instrument schedule has them.",
                              {std::to_string(unlabelled)}));
    if (unnamed_bars_ > 0)
        said.push_back(style_("Names of trusses and hanging positions that found no room: %1.",
                              {std::to_string(unnamed_bars_)}));
    if (wordless_ > 0)
        said.push_back(style_("HOUSE, UP-STAGE and names of lines that found no room: %1.",
                              {std::to_string(wordless_)}));
    if (!show_.movers.empty())
        said.push_back(style_("What movers carry is drawn where the show has it, not as in a look."));
    if (outlines_.simplified > 0)
        said.push_back(
            style_("Simplified to their outermost line: %1 of %2 objects.",
                   {std::to_string(outlines_.simplified), std::to_string(outlines_.objects.size())}));
    if (outlines_.left_out > 0)
        said.push_back(style_("Objects that are not drawn, for there are too many: %1.",
                              {std::to_string(outlines_.left_out)}));
    if (rigging_.pieces_left_out > 0)
        said.push_back(style_("Pieces of trusses that are not joined and named, for there are too many: %1.",
                              {std::to_string(rigging_.pieces_left_out)}));
    return said;
}

} // namespace ghost::scene
