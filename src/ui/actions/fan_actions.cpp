// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/fan_actions.h"

#include "show/show.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/head_parameters.h"

#include <QColor>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

// A word, or the attribute of that name.
Result<std::string> head_word(const AppModel& app, const QString& words) {
    if (std::find(kHeadWords.begin(), kHeadWords.end(), words.toStdString()) != kHeadWords.end())
        return words.toStdString();
    return attribute_named(app, words);
}

Result<std::vector<std::size_t>> heads_with(const AppModel& app, const std::string& word, HeadOrder order) {
    TRY_VOID(need_selection(app));
    std::vector<std::size_t> heads = heads_in(order, app);
    std::erase_if(heads, [&](std::size_t head) { return !has_value(app.show()->fixtures[head], word); });
    if (heads.empty()) return Error{"no selected fixture has '" + word + "'", ""};
    return heads;
}

Result<HeadValue> value_now(const AppModel& app, std::size_t head, const std::string& word) {
    if (const auto value = HeadReader(*app.show(), app.look(), app.rig()).value(head, word)) return *value;
    return Error{"'" + app.show()->fixtures[head].name + "' is dark or turns its wheel, and nobody set its " +
                     word + " by hand",
                 ""};
}

HeadValue between(const FanRequest& request, const HeadValue& a, const HeadValue& b, std::size_t number,
                  std::size_t count) {
    const auto* const colour = std::get_if<glm::vec3>(&a);
    if (!colour) return fanned(request.fan, std::get<float>(a), std::get<float>(b), number, count);
    const glm::vec3 mixed = fanned(request.fan, *colour, std::get<glm::vec3>(b), number, count);
    return mixed / std::max({mixed.x, mixed.y, mixed.z, 1e-4f}); // as a filter by hand is
}

int step_of(const std::string& word) {
    const auto place = std::find(kHeadWords.begin(), kHeadWords.end(), word) - kHeadWords.begin();
    return static_cast<int>(ProgrammerStep::fan) + static_cast<int>(place);
}

struct Limits {
    const char* what;
    double low, high;
};
Limits limits_of(const std::string& word) {
    if (word == "pan" || word == "tilt") return {"number of degrees", -3600, 3600};
    if (word == "zoom") return {"number of degrees", 0.05, 160};
    if (word == "gobo") return {"slot, 0 is open,", 0, 255};
    return {"share", 0, 1};
}

Result<HeadValue> value_from(const QStringList& words, int index, const std::string& word, Fan fan) {
    if (word == "colour") {
        const QColor colour(words.value(index));
        if (colour.isValid()) return HeadValue(filter_from(colour));
        return Error{"'" + words.value(index).toStdString() + "' is no colour like #ff8000", ""};
    }
    const Limits limits = limits_of(word);
    // What the ends of a centred fan are off by goes both ways.
    const bool is_offset = fan == Fan::centre && index == 2;
    TRY(const double number,
        number_of(words, index, limits.what, is_offset ? -limits.high : limits.low, limits.high));
    return HeadValue(static_cast<float>(number));
}

template <std::size_t Count>
Result<std::size_t> one_of(const QString& word, const std::array<const char*, Count>& names) {
    for (std::size_t i = 0; i < Count; ++i)
        if (word == names[i]) return i;
    std::string text = "'" + word.toStdString() + "' is none of";
    for (std::size_t i = 0; i < Count; ++i)
        text += (i == 0 ? " " : i + 1 < Count ? ", " : " and ") + std::string(names[i]);
    return Error{text, ""};
}

Result<void> fan_by_words(AppModel& app, const QStringList& words) {
    TRY_VOID(need_selection(app));
    FanRequest request;
    TRY(request.word, head_word(app, words.value(0)));
    const bool is_between = words.value(1) == "between";
    const int at = is_between ? 2 : 4; // where the order stands
    if (!is_between && words.size() > 3) {
        TRY(const std::size_t fan, one_of(words[3], kFans));
        request.fan = static_cast<Fan>(fan);
    }
    if (words.size() > at) {
        TRY(const std::size_t order, one_of(words[at], kHeadOrders));
        request.order = static_cast<HeadOrder>(order);
    }
    if (!is_between) {
        TRY(const HeadValue a, value_from(words, 1, request.word, request.fan));
        TRY(const HeadValue b, value_from(words, 2, request.word, request.fan));
        request.values = {a, b};
    }
    return fan_selected(app, request);
}

// Everything that hands set of it, by words.
std::vector<std::pair<std::string, HeadValue>> by_hand(const AppModel& app, std::size_t head) {
    std::vector<std::pair<std::string, HeadValue>> all;
    const auto found = app.look().fixtures.find(head);
    if (found == app.look().fixtures.end()) return all;
    const HeadReader reader(*app.show(), app.look(), app.rig());
    const scene::PatchedFixture& fixture = app.show()->fixtures[head];
    const fixture::Programmer programmer = in_channels(fixture, found->second);
    // Attributes first: a value that stands above them is to win.
    if (fixture.type) {
        const fixture::Patch patch = fixture.patch();
        for (const fixture::Channel& channel : patch.mode_of().channels)
            if (const auto share = programmer.channels.find(channel.name); share != programmer.channels.end())
                all.emplace_back(attribute_of(channel), share->second);
    }
    const auto put = [&](const char* word, const auto& value) {
        if (value) all.emplace_back(word, *value);
    };
    put("intensity", programmer.intensity);
    put("zoom", programmer.zoom_deg);
    put("pan", programmer.pan_deg);
    put("tilt", programmer.tilt_deg);
    put("colour", programmer.colour);
    if (programmer.gobo) all.emplace_back("gobo", static_cast<float>(*programmer.gobo));
    return all;
}

Result<void> align_by_words(AppModel& app, const QStringList& words) {
    TRY_VOID(need_selection(app));
    if (words.value(0) != "first" && words.value(0) != "last")
        return Error{"'" + words.value(0).toStdString() + "' is neither first nor last", ""};
    std::string word = "all";
    if (words.size() > 1 && words[1] != "all") {
        TRY(word, head_word(app, words[1]));
    }
    return align_values(app, word, words[0] == "last" ? AlignTo::last : AlignTo::first);
}

} // namespace

Result<void> fan_selected(AppModel& app, const FanRequest& request) {
    TRY(const std::vector<std::size_t> heads, heads_with(app, request.word, request.order));
    if (request.word == "colour" && request.fan == Fan::centre)
        return Error{"colours go from one to the other (line or symmetric), not to both sides of one", ""};
    HeadValue a, b;
    if (request.values) {
        std::tie(a, b) = *request.values;
    } else {
        TRY(a, value_now(app, heads.front(), request.word));
        TRY(b, value_now(app, heads.back(), request.word));
    }
    Look look = app.look();
    for (std::size_t k = 0; k < heads.size(); ++k)
        set_value(app.show()->fixtures[heads[k]], request.word, between(request, a, b, k, heads.size()),
                  look.fixtures[heads[k]]);
    app.set_look(std::move(look), translated("Undo", "fan %1").arg(QString::fromStdString(request.word)),
                 step_of(request.word));
    return {};
}

Result<void> align_values(AppModel& app, const std::string& word, AlignTo to) {
    TRY_VOID(need_selection(app));
    std::vector<std::size_t> heads = app.selected_in_order();
    if (word != "all") {
        TRY(heads, heads_with(app, word, HeadOrder::selection));
    }
    const std::size_t model = to == AlignTo::first ? heads.front() : heads.back();
    std::vector<std::pair<std::string, HeadValue>> values;
    if (word == "all") {
        values = by_hand(app, model);
        if (values.empty())
            return Error{"nothing of '" + app.show()->fixtures[model].name +
                             "' is set by hand; name what all shall have, or hold it first",
                         ""};
    } else {
        TRY(const HeadValue value, value_now(app, model, word));
        values.emplace_back(word, value);
    }
    Look look = app.look();
    for (const std::size_t head : heads)
        for (const auto& [name, value] : values)
            set_value(app.show()->fixtures[head], name, value, look.fixtures[head]);
    app.set_look(std::move(look), translated("Undo", "align %1").arg(QString::fromStdString(word)));
    return {};
}

Result<void> hold_selected(AppModel& app) {
    TRY_VOID(need_selection(app));
    const fixture::Levels levels = levels_of(app.rig().universes);
    Look look = app.look();
    for (const std::size_t head : app.selection())
        hold(app.show()->fixtures[head], levels, look.fixtures[head]);
    std::erase_if(look.fixtures, [](const auto& entry) { return entry.second.is_empty(); });
    if (look == app.look()) return Error{"everything of the selected fixtures is the hand's already", ""};
    app.set_look(std::move(look), translated("Undo", "hold"));
    return {};
}

void add_fan_actions(Actions& actions, AppModel& app) {
    actions.add({"fan",
                 "",
                 "fan",
                 "",
                 "WHAT A B [line|symmetric|centre]|between [selection|list|left-to-right]",
                 [&app](const QStringList& words) { return fan_by_words(app, words); },
                 {}});
    actions.add({"align-values",
                 "",
                 "align-values",
                 "",
                 "first|last [WHAT|all]",
                 [&app](const QStringList& words) { return align_by_words(app, words); },
                 {}});
    actions.add({"hold",
                 "Edit",
                 translated("Action", "Hold what the desk asks of the selected fixtures"),
                 "H",
                 "",
                 [&app](const QStringList&) { return hold_selected(app); },
                 {}});
}

} // namespace ghost::ui
