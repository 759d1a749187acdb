// SPDX-License-Identifier: Apache-2.0
#include "book/book_plan.h"

#include "book/private/entry_text.h"
#include "book/rests.h"
#include "show/looks.h"
#include "show/show.h"

#include <algorithm>

namespace ghost::scene {
namespace {

std::optional<std::size_t> index_of(const std::vector<StoredLook>& looks, const std::string& name) {
    const auto found =
        std::find_if(looks.begin(), looks.end(), [&](const StoredLook& look) { return look.name == name; });
    if (found == looks.end()) return std::nullopt;
    return static_cast<std::size_t>(found - looks.begin());
}

// A cue that says no time, look or camera leaves those of the cue before.
void plan_cues(const Show& show, const std::vector<StoredLook>& looks, const PrintStyle& style,
               BookPlan& plan) {
    std::optional<double> at_s;
    std::optional<std::size_t> look;
    std::string camera;
    bool is_look_missing = false;
    for (const Cue& cue : show.cues) {
        PlannedEntry& planned = plan.entries.emplace_back();
        BookEntry& entry = planned.entry;
        entry.name = cue.name;
        entry.number = cue.number;
        entry.page = cue.page;
        entry.notes = cue.notes;
        entry.goes_on = !cue.at_s;
        entry.follow_s = cue.follow_s;
        entry.fade_s = cue.fade_s;
        if (!cue.look.empty()) {
            const std::optional<std::size_t> named = index_of(looks, cue.look);
            is_look_missing = !named;
            if (named)
                look = named; // else the one before stays, as in the window
            else
                entry.unknown.push_back(style("the show has no look '%1'", {cue.look}));
            if (named && !entry.fade_s) entry.fade_s = looks[*named].fade_s;
        }
        at_s = cue.at_s ? cue.at_s : at_s;
        if (!cue.camera.empty()) {
            const bool is_there = std::any_of(show.cameras.begin(), show.cameras.end(),
                                              [&](const Camera& one) { return one.name == cue.camera; });
            if (is_there)
                camera = cue.camera;
            else
                entry.unknown.push_back(style("the show has no camera '%1'", {cue.camera}));
        }
        entry.at_s = at_s;
        if (!show.recording.empty() && !at_s)
            entry.unknown.push_back(style("no cue so far says a second of the recording: nothing is sent"));
        planned.is_other = is_look_missing || (show.recording.empty() && at_s && !look);
        if (show.recording.empty() && cue.at_s)
            entry.unknown.push_back(style("the show has no recording: what it does at %1 s is not known",
                                          {style.number(*cue.at_s, 2)}));
        if (look) entry.look = looks[*look].name;
        planned.look = look;
        planned.camera = camera;
    }
}

void plan_looks(const std::vector<StoredLook>& looks, BookPlan& plan) {
    for (std::size_t i = 0; i < looks.size(); ++i) {
        PlannedEntry& planned = plan.entries.emplace_back();
        planned.entry.name = looks[i].name;
        planned.entry.look = looks[i].name;
        planned.entry.fade_s = looks[i].fade_s;
        planned.look = i;
    }
}

void plan_found(const std::vector<double>& found_s, const PrintStyle& style, BookPlan& plan) {
    for (const double at_s : found_s) {
        PlannedEntry& planned = plan.entries.emplace_back();
        planned.entry.name = style("at rest from %1", {moment_text(at_s, style)});
        planned.entry.at_s = at_s;
    }
}

void plan_marks(const std::vector<Mark>& marks, const PrintStyle& style, BookPlan& plan) {
    for (const Mark& mark : marks) {
        BookEntry& entry = plan.entries.emplace_back().entry;
        entry.name = mark.name.empty() ? mark.number : mark.name;
        if (!mark.name.empty()) entry.number = mark.number;
        if (entry.name.empty()) entry.name = moment_text(mark.at_s, style);
        entry.notes = mark.note;
        entry.at_s = mark.at_s;
    }
}

} // namespace

Result<BookPlan> plan_book(const Show& show, const std::vector<StoredLook>& looks, BookKind kind,
                           const std::vector<double>& found_s, const PrintStyle& style,
                           const std::vector<Mark>& marks) {
    BookPlan plan;
    const std::string file = show.file.string();
    if (kind == BookKind::cues || (kind == BookKind::by_itself && !show.cues.empty())) {
        if (show.cues.empty()) return Error{"has no [[cue]] to make a book of", file};
        plan.kind = "cues";
        plan_cues(show, looks, style, plan);
    } else if (kind == BookKind::looks || (kind == BookKind::by_itself && !looks.empty())) {
        if (looks.empty()) return Error{"has no looks to make a book of", looks_file(show).string()};
        plan.kind = "looks";
        plan_looks(looks, plan);
    } else if (kind == BookKind::marks) {
        if (show.recording.empty()) return Error{"has no recording that marks could be in", file};
        if (marks.empty()) return Error{"has no mark to make a book of", file};
        plan.kind = "marks";
        plan_marks(marks, style, plan);
    } else if (kind == BookKind::found || !found_s.empty()) {
        if (show.recording.empty()) return Error{"has no recording to find cues in", file};
        if (found_s.empty())
            return Error{"never comes to rest: no cue is found in it", show.recording.string()};
        if (found_s.size() > kMostRests)
            return Error{"comes to rest " + std::to_string(found_s.size()) + " times, at most " +
                             std::to_string(kMostRests) + " are taken as cues",
                         show.recording.string()};
        plan.kind = "moments found";
        plan_found(found_s, style, plan);
    } else {
        plan.kind = "one moment";
        plan.unknown.push_back(style("the show has neither cues nor looks: this is how it begins"));
        PlannedEntry& planned = plan.entries.emplace_back();
        planned.entry.name = style("the show as it begins");
        if (!show.recording.empty()) planned.entry.at_s = 0;
    }
    if (kind == BookKind::by_itself && plan.kind == "moments found")
        plan.unknown.push_back(style("the show has neither cues nor looks: these are the moments in which "
                                     "its recording rests"));
    if (plan.entries.size() > kMostEntries)
        return Error{"a book of " + std::to_string(plan.entries.size()) + " entries, at most " +
                         std::to_string(kMostEntries) + " are possible",
                     file};
    return plan;
}

} // namespace ghost::scene
