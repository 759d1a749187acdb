// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/cue_list.h"

#include "base/suggest.h"
#include "show/show.h"
#include "show_file/cue_edit.h"
#include "ui/language/language.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::ui {
namespace {

constexpr double kLongestFollow_s = 86400, kLongestFlight_s = 60;
constexpr double kPassesWithin_s = 2; // a longer step of the recording is a jump

Result<std::optional<float>> seconds_of(const QString& words, double most_s) {
    if (words.isEmpty()) return std::optional<float>();
    TRY(const double seconds, number_of({words}, 0, "number of seconds", 0, most_s));
    return std::optional(static_cast<float>(seconds));
}

std::vector<std::string> names_of(const std::vector<scene::Cue>& cues) {
    std::vector<std::string> names;
    for (const scene::Cue& cue : cues) names.push_back(cue.name);
    return names;
}

std::optional<std::size_t> place_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - names.begin()));
}

} // namespace

CueList::CueList(AppModel& app, ShowDocument& document, Looks& looks)
    : app_(app), document_(document), looks_(looks) {
    follow_.setSingleShot(true);
    connect(&follow_, &QTimer::timeout, this, [this] {
        if (const Result<void> done = go(); !done.ok() && complain) complain(done.error());
    });
    connect(&app_, &AppModel::opened_show, this, &CueList::take_cues);
    connect(&app_, &AppModel::cue_called, this, [this](const QString& name) {
        const auto cue = std::ranges::find(all(), name.toStdString(), &scene::Cue::name);
        if (cue != all().end()) be_in(static_cast<std::size_t>(cue - all().begin()), After::follows);
    });
    connect(&app_, &AppModel::rig_came, this, &CueList::look_at_recording);
}

const std::vector<scene::Cue>& CueList::all() const {
    static const std::vector<scene::Cue> kNone;
    return app_.show() ? app_.show()->cues : kNone;
}

void CueList::take_cues() {
    if (!app_.opened().is_edit && !app_.opened().again) {
        names_ = names_of(all());
        called_.clear();
        current_.reset();
        follow_.stop();
        follows_recording_ = false;
        seen_ = {};
        app_.publish_cue("");
    } else {
        find_called();
        // Who listens for remote controls may have opened it as another show.
        if (!app_.opened().is_edit) app_.publish_cue(current_ ? names_[*current_] : "");
    }
    Q_EMIT changed();
}

// After an edit: whoever looks on knows it by its name, and what is called next is what stood behind it.
void CueList::find_called() {
    const std::vector<std::string> before = std::exchange(names_, names_of(all()));
    if (called_.empty()) return;
    const std::string known = current_ ? before[*current_] : "";
    const std::optional<std::size_t> was = place_of(before, called_);
    const std::optional<std::size_t> place_before = current_;
    current_ = place_of(names_, called_);
    if (!current_ && was && before.size() == names_.size() && !place_of(before, names_[*was])) {
        current_ = was;
        called_ = names_[*was];
    }
    const std::size_t behind = was ? *was : place_before ? *place_before + 1 : 0;
    for (std::size_t i = behind; !current_ && i > 0; --i) current_ = place_of(names_, before[i - 1]);
    const bool is_there = current_ && names_[*current_] == called_;
    if (!is_there || *current_ + 1 == names_.size()) follow_.stop();
    const std::string now = current_ ? names_[*current_] : "";
    if (now != known) app_.publish_cue(now);
}

double CueList::follows_in_s() const {
    return follow_.isActive() ? follow_.remainingTime() * 1e-3 : -1.0;
}

Result<void> CueList::go() {
    if (all().empty()) return Error{"the show has no cue: add one", ""};
    const std::size_t next = current_ ? *current_ + 1 : 0;
    if (next >= all().size()) return Error{"this was the last cue", ""};
    return call(next, Place::goes_there, After::follows);
}

Result<void> CueList::back() {
    if (all().empty()) return Error{"the show has no cue: add one", ""};
    if (!current_ || *current_ == 0) return Error{"this is the first cue", ""};
    return call(*current_ - 1);
}

Result<void> CueList::call(std::size_t index) {
    return call(index, Place::goes_there, After::stands);
}

Result<void> CueList::call(std::size_t index, Place place, After after) {
    if (index >= all().size()) return Error{"there is no cue number " + std::to_string(index + 1), ""};
    const scene::Cue cue = all()[index];
    // What is there of it is done: a cue that lacks its look must not hold up those behind it.
    Result<void> done;
    if (!cue.look.empty()) done = looks_.recall(cue.look, cue.fade_s ? static_cast<double>(*cue.fade_s) : -1);
    if (!cue.camera.empty()) {
        const Result<std::size_t> camera = app_.show()->find_camera(cue.camera);
        if (!camera.ok())
            done = camera.error();
        else if (cue.flight_s > 0)
            app_.travel_to_stored(app_.show()->cameras[*camera], static_cast<int>(1000 * cue.flight_s));
        else
            app_.cut_to(app_.show()->cameras[*camera]);
    }
    if (cue.at_s && place == Place::goes_there)
        app_.change_request([&](ViewRequest& request) {
            ++request.transport.seeks;
            request.transport.at_s = *cue.at_s;
        });
    be_in(index, after);
    app_.publish_cue(cue.name);
    return done;
}

void CueList::be_in(std::size_t index, After after) {
    current_ = index;
    called_ = all()[index].name;
    follow_.stop();
    const std::optional<float>& follow_s = all()[index].follow_s;
    if (after == After::follows && follow_s && index + 1 < all().size())
        follow_.start(static_cast<int>(1000 * std::min(static_cast<double>(*follow_s), kLongestFollow_s)));
    Q_EMIT changed();
}

void CueList::set_follows_recording(bool follows) {
    if (follows_recording_ != follows) seen_ = {app_.rig().at_s, app_.rig().seeks, true};
    follows_recording_ = follows;
    Q_EMIT changed();
}

// Who jumps to a second, or comes round to the first one, has what stands there before him; it comes when the
// recording plays on.
void CueList::look_at_recording() {
    const RigNow& rig = app_.rig();
    const Transport& transport = app_.request().transport;
    const bool loops = transport.loop_to_s > transport.loop_from_s;
    Seen from = seen_;
    if (rig.seeks != from.seeks) {
        const double asked_s = app_.has_jumped() && std::isfinite(transport.at_s) ? transport.at_s : rig.at_s;
        const double at_s = std::max(asked_s, 0.0);
        from = {rig.recording_s > 0 ? std::fmod(at_s, rig.recording_s) : at_s, rig.seeks, true};
    } else if (rig.at_s < from.at_s && (loops || from.at_s - rig.at_s > kPassesWithin_s)) { // no jitter
        from = {loops ? transport.loop_from_s : 0.0, rig.seeks, true};
    }
    seen_ = {rig.at_s, rig.seeks, from.comes && rig.at_s == from.at_s};
    if (!follows_recording_ || rig.from_desk || rig.at_s <= from.at_s ||
        rig.at_s - from.at_s > kPassesWithin_s)
        return;
    std::vector<std::size_t> come;
    for (std::size_t i = 0; i < all().size(); ++i) {
        const std::optional<double>& at_s = all()[i].at_s;
        if (!at_s || *at_s > rig.at_s || *at_s < from.at_s) continue;
        // Who called a cue has jumped to its second, and is in it.
        const bool comes = *at_s > from.at_s || (from.comes && current_ != i);
        if (comes) come.push_back(i);
    }
    std::ranges::stable_sort(come, {}, [this](std::size_t i) { return *all()[i].at_s; });
    for (const std::size_t i : come)
        if (const Result<void> done = call(i, Place::stays, After::follows); !done.ok() && complain)
            complain(done.error());
}

Result<void> CueList::edit(const QString& what, const Result<std::string>& text) {
    TRY_VOID(text);
    return document_.edit(what, {*text, app_.look(), app_.selection()});
}

Result<void> CueList::rename_look(const std::string& look, const std::string& to) {
    std::vector<scene::Cue> cues = all();
    if (std::ranges::find(cues, look, &scene::Cue::look) == cues.end()) return {};
    TRY_VOID(document_.check_editable());
    std::string text = document_.text();
    for (std::size_t i = 0; i < cues.size(); ++i) {
        if (cues[i].look != look) continue;
        scene::Cue renamed = cues[i];
        renamed.look = to;
        TRY(text, scene::edit_cue(text, cues, i, renamed));
        cues[i] = std::move(renamed);
    }
    return edit(translated("Undo", "Look '%1' renamed '%2'")
                    .arg(QString::fromStdString(look), QString::fromStdString(to)),
                text);
}

Result<void> CueList::add(const QString& name, const QString& look) {
    TRY_VOID(document_.check_editable());
    scene::Cue cue;
    cue.look = look.toStdString();
    if (!cue.look.empty()) TRY_VOID(scene::find_look(looks_.all(), cue.look));
    // Without a look it is the moment of the recording, or else the camera.
    if (cue.look.empty() && app_.rig().recording_s > 0 && !app_.rig().from_desk)
        cue.at_s = std::round(app_.moment_s() * 10) / 10;
    else if (cue.look.empty())
        cue.camera = app_.show()->cameras.empty() ? "" : app_.show()->cameras.front().name;
    const auto is_taken = [&](const std::string& wanted) {
        return std::any_of(all().begin(), all().end(),
                           [&](const scene::Cue& one) { return one.name == wanted; });
    };
    cue.name = name.toStdString();
    if (cue.name.empty()) cue.name = cue.look.empty() ? "Cue " + std::to_string(all().size() + 1) : cue.look;
    const std::string wanted = cue.name;
    for (int number = 2; name.isEmpty() && is_taken(cue.name); ++number)
        cue.name = wanted + " " + std::to_string(number);
    if (is_taken(cue.name)) return Error{"another cue is called '" + cue.name + "'", ""};
    return edit(translated("Undo", "Cue '%1' added").arg(QString::fromStdString(cue.name)),
                scene::add_cue(document_.text(), cue));
}

Result<void> CueList::set(std::size_t index, const QString& what, const QString& words) {
    TRY_VOID(document_.check_editable());
    if (index >= all().size()) return Error{"there is no cue number " + std::to_string(index + 1), ""};
    scene::Cue cue = all()[index];
    if (what == "name") {
        if (words.isEmpty()) return Error{"a cue needs a name", ""};
        cue.name = words.toStdString();
        for (std::size_t i = 0; i < all().size(); ++i)
            if (i != index && all()[i].name == cue.name)
                return Error{"another cue is called '" + cue.name + "'", ""};
    } else if (what == "look") {
        cue.look = words.toStdString();
        if (!cue.look.empty()) TRY_VOID(scene::find_look(looks_.all(), cue.look));
    } else if (what == "camera") {
        cue.camera = words.toStdString();
        if (!cue.camera.empty()) TRY_VOID(app_.show()->find_camera(cue.camera));
    } else if (what == "at") {
        TRY(const std::optional<float> at_s, seconds_of(words, 366.0 * 86400.0));
        cue.at_s = at_s ? std::optional(words.toDouble()) : std::nullopt;
    } else if (what == "flight") {
        TRY(const std::optional<float> flight_s, seconds_of(words, kLongestFlight_s));
        cue.flight_s = flight_s.value_or(0);
    } else if (what == "fade") {
        TRY(cue.fade_s, seconds_of(words, scene::kLongestFade_s));
    } else if (what == "follow") {
        TRY(cue.follow_s, seconds_of(words, kLongestFollow_s));
    } else if (what == "number") {
        cue.number = words.toStdString();
    } else if (what == "page") {
        cue.page = words.toStdString();
    } else if (what == "notes") {
        cue.notes = words.toStdString();
    } else {
        return Error{"'" + what.toStdString() +
                         "' is none of name, number, look, at, camera, flight, fade, follow, page and notes",
                     ""};
    }
    if (!cue.at_s && cue.camera.empty() && cue.look.empty())
        return Error{"a cue needs a look, a camera or a place in the recording", ""};
    return edit(translated("Undo", "Cue '%1' changed").arg(QString::fromStdString(all()[index].name)),
                scene::edit_cue(document_.text(), all(), index, cue));
}

Result<void> CueList::move(std::size_t index, int by) {
    TRY_VOID(document_.check_editable());
    const std::size_t lower = by < 0 ? index : index + 1;
    if (by > 0 && lower >= all().size()) return Error{"this is the last cue", ""};
    if (lower >= all().size()) return Error{"there is no cue number " + std::to_string(index + 1), ""};
    return edit(translated("Undo", "Cue '%1' moved").arg(QString::fromStdString(all()[index].name)),
                scene::move_cue_up(document_.text(), all(), lower));
}

Result<void> CueList::remove(std::size_t index) {
    TRY_VOID(document_.check_editable());
    if (index >= all().size()) return Error{"there is no cue number " + std::to_string(index + 1), ""};
    return edit(translated("Undo", "Cue '%1' removed").arg(QString::fromStdString(all()[index].name)),
                scene::remove_cue(document_.text(), all(), index));
}

namespace {

Result<std::size_t> cue_of(const CueList& cues, const QString& word) {
    bool is_number = false;
    const int number = word.toInt(&is_number);
    if (is_number && number >= 1 && static_cast<std::size_t>(number) <= cues.all().size())
        return static_cast<std::size_t>(number) - 1;
    std::vector<std::string> names;
    for (const scene::Cue& cue : cues.all()) {
        if (cue.name == word.toStdString()) return names.size();
        names.push_back(cue.name);
    }
    return Error{"there is no cue '" + word.toStdString() + "'" + did_you_mean(word.toStdString(), names),
                 ""};
}

} // namespace

void add_cue_actions(Actions& actions, CueList& cues) {
    const auto add = [&](const QString& name, const QString& text, const QString& key,
                         const QString& arguments, std::function<Result<void>(const QStringList&)> run) {
        actions.add({name,
                     text.isEmpty() ? "" : "Play",
                     text.isEmpty() ? name : text,
                     key,
                     arguments,
                     std::move(run),
                     {}});
    };
    add("cue-go", translated("Action", "Go: the next cue"), "Ctrl+G", "",
        [&cues](const QStringList&) { return cues.go(); });
    add("cue-back", translated("Action", "Back: the cue before"), "Ctrl+Shift+G", "",
        [&cues](const QStringList&) { return cues.back(); });
    actions.add({"cue-follow", "Play", translated("Action", "Cues follow the recording"), "", "",
                 [&cues](const QStringList&) -> Result<void> {
                     cues.set_follows_recording(!cues.follows_recording());
                     return {};
                 },
                 [&cues] { return cues.follows_recording(); }});
    const auto with_cue = [&cues](auto f) {
        return [&cues, f](const QStringList& words) -> Result<void> {
            TRY(const std::size_t index, cue_of(cues, words.value(0)));
            return f(cues, index, words);
        };
    };
    add("cue", "", "", "NAME|PLACE",
        with_cue([](CueList& list, std::size_t index, const QStringList&) { return list.call(index); }));
    add("cue-add", "", "", "[NAME [LOOK]]",
        [&cues](const QStringList& words) { return cues.add(words.value(0), words.value(1)); });
    add("cue-set", "", "", "NAME|PLACE name|number|look|at|camera|flight|fade|follow|page|notes [VALUE]",
        with_cue([](CueList& list, std::size_t index, const QStringList& words) {
            return list.set(index, words.value(1), words.value(2));
        }));
    add("cue-move", "", "", "NAME|PLACE up|down",
        with_cue([](CueList& list, std::size_t index, const QStringList& words) -> Result<void> {
            if (words.value(1) != "up" && words.value(1) != "down")
                return Error{"'" + words.value(1).toStdString() + "' is neither up nor down", ""};
            return list.move(index, words[1] == "up" ? -1 : 1);
        }));
    add("cue-remove", "", "", "NAME|PLACE",
        with_cue([](CueList& list, std::size_t index, const QStringList&) { return list.remove(index); }));
}

} // namespace ghost::ui
