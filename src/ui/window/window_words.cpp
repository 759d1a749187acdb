// SPDX-License-Identifier: Apache-2.0
// Window: what it says by itself: title, undo and redo, what was done or refused, status line.
#include "show/show.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/fixture_groups.h"
#include "ui/widgets/shortened.h"
#include "ui/window/private/notice_bar.h"
#include "ui/window/window.h"

#include <QStatusBar>

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kLettersOfStep = 60; // in a menu

QString words_of_desk(const std::vector<dmx::Universe>& universes) {
    const auto silent =
        std::count_if(universes.begin(), universes.end(), [](const dmx::Universe& one) { return one.lost; });
    const auto all = static_cast<std::ptrdiff_t>(universes.size());
    if (silent == all) return translated("Notice", "A desk that is silent: %n universe(s)", nullptr, all);
    const QString words = translated("Notice", "A desk: %n universe(s)", nullptr, all);
    return silent == 0 ? words : words + translated("Notice", ", %n of them silent", nullptr, silent);
}

} // namespace

void Window::show_title() {
    if (!app_.show()) return;
    const scene::Show& show = *app_.show();
    QString title = QString::fromStdString(show.name.empty() ? show.file.string() : show.name);
    const bool is_plot = show.file == show.plot_file;
    if (const auto file = show.file.filename(); !is_plot && !show.name.empty() && file != "show.toml")
        title += " (" + QString::fromStdString(file.string()) + ")";
    if (document_.is_read_only() || is_plot) title += " " + translated("Window", "(read only)");
    setWindowTitle(title + "[*] - Ghostlight");
    setWindowModified(document_.is_changed());
}

// The entries of the menu say what they would do.
void Window::name_steps() {
    const auto name = [this](const char* action, const QString& alone, const QString& with, QString step) {
        step = shortened(step, kLettersOfStep).replace("&", "&&");
        actions_.item(action)->setText(step.isEmpty() ? alone : with.arg(step));
    };
    name("undo", translated("Action", "Undo"), translated("Action", "Undo: %1"),
         app_.undo_stack().undoText());
    name("redo", translated("Action", "Redo"), translated("Action", "Redo: %1"),
         app_.undo_stack().redoText());
}

void Window::say_refused(const Error& error, bool is_of_edit, const QString& helps) {
    // Names of actions are words of scripts.
    const bool names_action = actions_.item(QString::fromStdString(error.where)) != nullptr;
    say(QString::fromStdString(names_action ? error.what : error.text()), 8000);
    refused_ = statusBar()->currentMessage();
    if (!is_of_edit || !notice_) return;
    const QString what = said(error.what);
    if (!notice_->say_refused(what, helps)) toast_->say(what);
}

// What was refused is no news once something else is done.
void Window::forget_refused() {
    if (notice_) notice_->forget_refused();
    if (!refused_.isEmpty() && statusBar()->currentMessage() == refused_) statusBar()->clearMessage();
}

// What else would show nothing.
void Window::say_done(const Action& action, bool made_step) {
    static const std::set<QString> kSays{
        "hang",           "duplicate", "remove",        "unpatch",         "distribute",    "add-fixture",
        "add-model",      "set-stage", "substitute",    "substitute-same", "move-object",   "palette-store",
        "palette-remove", "cue-add",   "fly-on-hoists", "mover-address",   "camera-rename", "camera-remove"};
    if (action.name == "save")
        toast_->say(translated("Notice", "Saved: %1")
                        .arg(QString::fromStdString(app_.show()->file.filename().string())));
    else if (made_step && action.name == "keep-camera")
        say_step(app_.undo_stack().undoText(), [this, number = app_.show()->cameras.size()] {
            actions_.choose(QString("camera-rename %1").arg(number));
        });
    else if (made_step && kSays.contains(action.name))
        say_step(app_.undo_stack().undoText());
}

void Window::say_step(const QString& what, std::function<void()> name) {
    step_said_ = app_.undo_stack().index();
    toast_->say(
        what, [this] { actions_.choose("undo"); }, std::move(name));
}

void Window::say_hand_taken() {
    const std::size_t count = app_.look().fixtures.size();
    const bool has_hand = count > 0;
    if (has_hand && !had_hand_ && !app_.fades()) {
        const auto dark =
            std::count_if(app_.look().fixtures.begin(), app_.look().fixtures.end(), [this](const auto& one) {
                return one.first < app_.show()->fixtures.size() &&
                       !can_shine(app_.show()->fixtures[one.first]);
            });
        QString words = words_of(app_.look());
        if (dark > 0)
            words = translated("Notice", "%1, of which %2 have no optics and stay dark").arg(words).arg(dark);
        say_step(
            translated("Notice", "By hand now: %1. R gives back what is selected, Shift+R all").arg(words));
    }
    had_hand_ = has_hand;
}

void Window::show_status() {
    const RigNow& rig = app_.rig();
    const bool listens = options_.takes_desk;
    QString text;
    if (rig.from_desk)
        text = rig.universes.list.empty()
                   ? (listens ? translated("Notice", "Listening for a desk: nothing has come yet")
                              : translated("Notice", "No input: started with --no-desk"))
                   : words_of_desk(rig.universes.list);
    else if (rig.recording_s <= 0)
        text = app_.request().input == Input::recording
                   ? translated("Notice", "No recording: the show has none; a desk is not taken (Play menu)")
               : listens ? translated("Notice",
                                      "No recording; a desk that sends sACN or Art-Net takes over by itself")
                         : translated("Notice", "No recording, and no desk: started with --no-desk");
    else
        text = translated("Notice", "Recording, %1 of %2 s")
                   .arg(app_.moment_s(), 0, 'f', 1)
                   .arg(rig.recording_s, 0, 'f', 1);
    if (!rig.timecode.empty()) text += "; " + said(rig.timecode);
    if (rig.recorded_s >= 0)
        text += "; " + translated("Notice", "RECORDING, %1 s").arg(rig.recorded_s, 0, 'f', 1);
    status_input_->setText(text);
}

void Window::show_jobs() {
    QString words;
    for (const Job& job : app_.jobs().all())
        if (job.state == Job::State::runs)
            words = QString("%1: %2 %").arg(job.title).arg(static_cast<int>(100 * job.share)) +
                    (job.left.isEmpty() ? QString() : translated("Jobs", ", %1 left").arg(job.left));
    status_jobs_->setText(words);
}

void Window::say(const QString& words, int for_ms) {
    const QString what = said(words);
    const int room_px = status_jobs_->x(); // what always stands there begins there
    statusBar()->showMessage(shortened(what, room_px / fontMetrics().averageCharWidth()), for_ms);
    statusBar()->setToolTip(what);
}

} // namespace ghost::ui
