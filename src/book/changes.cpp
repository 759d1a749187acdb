// SPDX-License-Identifier: Apache-2.0
#include "book/changes.h"

#include "print/quantities.h"
#include "show/looks.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ghost::scene {
namespace {

struct Quantity {
    float FixtureValues::*value;
    Word said;   // of the two values
    float least; // a change
    int decimals;
};
constexpr Quantity kLight{&FixtureValues::light_percent, "%1 to %2 %", 1.0f, 0};
constexpr Quantity kOthers[] = {
    {&FixtureValues::zoom_deg, "zoom %1 to %2 deg", 0.5f, 1},
    {&FixtureValues::iris_percent, "iris %1 to %2 %", 1.0f, 0},
    {&FixtureValues::frost_percent, "frost %1 to %2 %", 1.0f, 0},
    {&FixtureValues::blades_percent, "shutters %1 to %2 %", 1.0f, 0},
    {&FixtureValues::focus_percent, "focus %1 to %2 %", 1.0f, 0},
    {&FixtureValues::strobe_hz, "strobe %1 to %2 Hz", 0.1f, 1},
    {&FixtureValues::gobo_deg_s, "gobo turns at %1 to %2 deg/s", 0.5f, 1},
    {&FixtureValues::effects_deg_s, "effects turn at %1 to %2 deg/s", 0.5f, 1},
    {&FixtureValues::tint_percent, "tint %1 to %2 %", 1.0f, 0},
};
// Of angles, for which a whole turn is none.
constexpr Quantity kTurns[] = {
    {&FixtureValues::gobo_deg, "gobo turned from %1 to %2 deg", 0.5f, 0},
    {&FixtureValues::effects_deg, "effects turned from %1 to %2 deg", 0.5f, 0},
};
struct ChangedText {
    std::string FixtureValues::*value;
    Word said;
};
constexpr ChangedText kChangedTexts[] = {{&FixtureValues::colour, "colour %1 to %2"},
                                         {&FixtureValues::gobo, "gobo %1 to %2"},
                                         {&FixtureValues::effects, "effects %1 to %2"}};
constexpr float kLeastTurn_deg = 0.5f;

void add(std::string& list, const std::string& part) {
    list += (list.empty() ? "" : ", ") + part;
}

void add_quantity(const Quantity& quantity, const FixtureValues& before, const FixtureValues& after,
                  const PrintStyle& style, std::string& list) {
    const float from = before.*quantity.value, to = after.*quantity.value;
    if (!(std::abs(to - from) >= quantity.least)) return;
    add(list, style(quantity.said, {style.number(static_cast<double>(from), quantity.decimals),
                                    style.number(static_cast<double>(to), quantity.decimals)}));
}

// Single blades, where the one that is farthest in stays.
bool blades_move(const FixtureValues& before, const FixtureValues& after) {
    constexpr float kLeastShift = 0.01f; // of the field
    const auto differ = [](const fixture::Blade& a, const fixture::Blade& b) {
        return std::abs(a.a - b.a) >= kLeastShift || std::abs(a.b - b.b) >= kLeastShift ||
               std::abs(a.deg - b.deg) >= kLeastTurn_deg;
    };
    return std::abs(before.shaper_deg - after.shaper_deg) >= kLeastTurn_deg ||
           !std::equal(before.blades.begin(), before.blades.end(), after.blades.begin(),
                       [&](const fixture::Blade& a, const fixture::Blade& b) { return !differ(a, b); });
}

// But for how far one that turns or runs has come.
bool same_figure(const std::optional<fixture::LaserCurve>& a, const std::optional<fixture::LaserCurve>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->kind == b->kind && a->count == b->count && a->size_deg == b->size_deg && a->deg_s == b->deg_s &&
           a->move_hz == b->move_hz && (a->deg_s != 0 || a->deg == b->deg);
}

bool moves(const FixtureValues& before, const FixtureValues& after) {
    return std::abs(after.pan_deg - before.pan_deg) >= kLeastTurn_deg ||
           std::abs(after.tilt_deg - before.tilt_deg) >= kLeastTurn_deg;
}

} // namespace

std::string BookChange::line(const PrintStyle& style) const {
    return fixtures.empty() ? what : names_text(fixtures, style) + ": " + what;
}

std::string change_of(const FixtureValues& before, const FixtureValues& after, const PrintStyle& style) {
    std::string list;
    add_quantity(kLight, before, after, style, list);
    std::string others;
    for (const ChangedText& text : kChangedTexts)
        if (before.*text.value != after.*text.value)
            add(others, style(text.said, {before.*text.value, after.*text.value}));
    const bool by_blades =
        std::abs(after.blades_percent - before.blades_percent) < 1.0f && blades_move(before, after);
    for (const Quantity& quantity : kOthers) add_quantity(quantity, before, after, style, others);
    for (const Quantity& quantity : kTurns) {
        const float turn_deg = std::remainder(after.*quantity.value - before.*quantity.value, 360.0f);
        if (std::abs(turn_deg) >= quantity.least) add_quantity(quantity, before, after, style, others);
    }
    if (by_blades) add(others, style("shutters move"));
    if (!same_figure(before.figure, after.figure)) add(others, style("another figure"));
    if (before.is_dark() && after.is_dark()) {
        if (moves(before, after)) return style("moves in the dark");
        return others.empty() ? "" : style("is set in the dark");
    }
    if (after.is_dark()) return list; // nobody sees what else it does then
    if (!others.empty()) add(list, others);
    if (moves(before, after)) add(list, style("moves"));
    if (list.empty() && before.cells != after.cells) add(list, style("its cells change"));
    return list;
}

std::vector<BookChange> changes_of(const Show& show, const std::vector<FixtureValues>& before,
                                   const std::vector<FixtureValues>& after, const PrintStyle& style) {
    struct Line {
        BookChange change;
        double lumens = 0;
    };
    std::vector<Line> lines;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < std::min({show.fixtures.size(), before.size(), after.size()}); ++i) {
        const PatchedFixture& fixture = show.fixtures[i];
        const std::string what = change_of(before[i], after[i], style);
        if (what.empty()) continue;
        const auto [found, is_new] = known.try_emplace(what, lines.size());
        if (is_new) lines.push_back({{{}, what}, 0});
        Line& line = lines[found->second];
        line.change.fixtures.push_back(fixture.name);
        const float share = std::max(before[i].light_percent, after[i].light_percent) / 100.0f;
        if (fixture.type && !(before[i].is_dark() && after[i].is_dark()))
            line.lumens += static_cast<double>(share * full_lm(*fixture.type, fixture.patch().mode_of()));
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const Line& a, const Line& b) { return a.lumens > b.lumens; });
    std::vector<BookChange> changes;
    for (Line& line : lines) changes.push_back(std::move(line.change));
    return changes;
}

std::vector<BookChange> changes_of(const Show& show, const SceneLook& before, const SceneLook& after,
                                   const PrintStyle& style) {
    std::vector<BookChange> changes;
    const auto put = [&changes](const std::string& what) { changes.push_back({{}, what}); };
    const auto number = [&style](float value, int decimals) {
        return style.number(static_cast<double>(value), decimals);
    };
    const float smoke[] = {100.0f * before.smoke.value_or(1.0f), 100.0f * after.smoke.value_or(1.0f)};
    if (std::abs(smoke[1] - smoke[0]) >= 1.0f)
        put(style("haze %1 to %2 %", {number(smoke[0], 0), number(smoke[1], 0)}));
    const float lux[] = {before.ambient_lux.value_or(show.ambient_lux),
                         after.ambient_lux.value_or(show.ambient_lux)};
    if (std::abs(lux[1] - lux[0]) >= 0.01f)
        put(style("even light %1 to %2 lx", {number(lux[0], 2), number(lux[1], 2)}));
    if (before.ambient_colour.value_or(show.ambient_colour) !=
        after.ambient_colour.value_or(show.ambient_colour))
        put(style("even light changes its colour"));
    if (before.attenuation != after.attenuation) put(style("light falls off otherwise with distance"));
    if (before.shadows.value_or(true) != after.shadows.value_or(true))
        put(after.shadows.value_or(true) ? style("shadows on") : style("shadows off"));
    return changes;
}

std::vector<BookChange> changes_of(const Show& show, const std::vector<std::vector<float>>& before,
                                   const std::vector<std::vector<float>>& after, const PrintStyle& style) {
    constexpr float kLeastMove_m = 0.005f;
    std::vector<BookChange> changes;
    for (std::size_t i = 0; i < std::min({show.movers.size(), before.size(), after.size()}); ++i) {
        const Mover& mover = show.movers[i];
        std::string list;
        for (std::size_t k = 0; k < std::min({mover.axes.size(), before[i].size(), after[i].size()}); ++k) {
            const MoverAxis& axis = mover.axes[k];
            const float from = before[i][k], to = after[i][k];
            if (std::abs(to - from) < (axis.is_angle ? kLeastTurn_deg : kLeastMove_m)) continue;
            const auto said = [&](float value) {
                return axis.is_angle ? style.number(static_cast<double>(value), 1) + " deg"
                                     : style.length_said(static_cast<double>(value));
            };
            add(list, style("%1 from %2 to %3", {axis.name, said(from), said(to)}));
        }
        if (!list.empty()) changes.push_back({{}, mover.name + ": " + list});
    }
    return changes;
}

} // namespace ghost::scene
