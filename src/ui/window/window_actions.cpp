// SPDX-License-Identifier: Apache-2.0
// The actions of the window itself: open, save a picture, full screen, overlays.
#include "ui/language/language.h"
#include "ui/window/window.h"

#include "disk/files.h"
#include "image/ldr.h"
#include "show/show.h"
#include "ui/model/aside.h"
#include "ui/panels/fixture_panel.h"
#include "ui/window/private/notice_bar.h"
#include "ui/window/private/panel_rail.h"
#include "ui/window/private/shortcut_sheet.h"
#include "ui/window/private/state_json.h"

#include <QDesktopServices>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLayout>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QUrl>

#include <algorithm>

namespace ghost::ui {

void Window::add_window_actions() {
    actions_.add({"open",
                  "Show",
                  translated("Action", "Open a show..."),
                  "Ctrl+O",
                  "PATH",
                  [this](const QStringList& words) -> Result<void> {
                      app_.open(words[0].toStdString());
                      return {};
                  },
                  {},
                  {translated("Files", "Open a show"),
                   translated("Files", "Shows (show.toml *.mvr);;All files (*)"), ""}});
    actions_.add({"open-outside",
                  "",
                  "open-outside",
                  "",
                  "FILE",
                  [](const QStringList& words) -> Result<void> {
                      if (QDesktopServices::openUrl(QUrl::fromLocalFile(words.value(0)))) return {};
                      return Error{"no program was found that opens it", words.value(0).toStdString()};
                  },
                  {}});
    actions_.add({"open-demo",
                  "Show",
                  translated("Action", "Open the demo"),
                  "Ctrl+Shift+O",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (options_.demo.empty())
                          return Error{"there is no folder 'demo' beside this program (assets/demo, or "
                                       "share/ghostlight/demo)",
                                       ""};
                      app_.open(options_.demo);
                      return {};
                  },
                  {}});
    actions_.add({"take-plot",
                  "Show",
                  translated("Action", "Take the received plot"),
                  "Ctrl+T",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (app_.plot().number == 0)
                          return Error{"no plot came from the network (MVR-xchange)", ""};
                      if (!app_.show() || app_.show()->plot_file.empty())
                          app_.open(app_.plot().file); // it is no newer version of anything
                      else
                          app_.change_request(
                              [&](ViewRequest& request) { request.take_plot = app_.plot().number; });
                      statusBar()->clearMessage();
                      return {};
                  },
                  {}});
    actions_.add({"save-picture",
                  "Show",
                  translated("Action", "Save the picture..."),
                  "Ctrl+Shift+S",
                  "FILE",
                  [this](const QStringList& words) { return save_picture(words[0]); },
                  {},
                  {translated("Files", "Save the picture"), translated("Files", "Pictures (*.png *.exr)"),
                   "picture.png"}});
    actions_.add({"screenshot",
                  "Show",
                  translated("Action", "Save a picture of the window..."),
                  "",
                  "FILE",
                  [this](const QStringList& words) -> Result<void> {
                      const PictureSurface::Whole with_the_picture;
                      if (grab().save(words[0], "PNG")) return {};
                      return Error{"the picture cannot be written", words[0].toStdString()};
                  },
                  {},
                  {translated("Files", "Save a picture of the window"),
                   translated("Files", "Pictures (*.png)"), "window.png"}});
    actions_.add({"state",
                  "",
                  "state",
                  "",
                  "FILE",
                  [this](const QStringList& words) { return save_state(words); },
                  {}});
    actions_.add({"quit",
                  "Show",
                  translated("Action", "Quit"),
                  "Ctrl+Q",
                  "[anyway]",
                  [this](const QStringList& words) -> Result<void> {
                      closes_anyway_ = words.value(0) == "anyway";
                      if (actions_.is_by_hand() && !closes_anyway_ && asks_to_close()) return {};
                      if (!close())
                          return Error{"changes are saved nowhere: save a copy elsewhere, or close and lose "
                                       "them (in a script: quit anyway)",
                                       ""};
                      return {};
                  },
                  {}});
    actions_.add({"undo",
                  "Edit",
                  translated("Action", "Undo"),
                  "Ctrl+Z",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (!app_.undo_stack().canUndo()) return Error{"there is nothing to undo", ""};
                      app_.undo_stack().undo();
                      return {};
                  },
                  {}});
    actions_.add({"redo",
                  "Edit",
                  translated("Action", "Redo"),
                  "Ctrl+Shift+Z; Ctrl+Y",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (!app_.undo_stack().canRedo()) return Error{"there is nothing to redo", ""};
                      app_.undo_stack().redo();
                      return {};
                  },
                  {}});
    actions_.add({"find",
                  "Edit",
                  translated("Action", "Find a fixture"),
                  "Ctrl+F",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      TRY_VOID(actions_.run("panel-fixtures on"));
                      fixtures_->find();
                      return {};
                  },
                  {}});
    actions_.add({"shortcuts",
                  "Help",
                  translated("Action", "Keys"),
                  "?; F1",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      show_shortcuts();
                      return {};
                  },
                  {}});
}

// Of the next window: texts stand in every part of this one.
void Window::add_languages() {
    language_ = QSettings().value("language").toString();
    const auto add = [this](const QString& name, const QString& code, const QString& text) {
        actions_.add({"language-" + name, "", text, "", "",
                      [this, code, text](const QStringList&) -> Result<void> {
                          if (!options_.remembers)
                              return Error{"this window keeps nothing: it was started with --forget", ""};
                          language_ = code;
                          QSettings().setValue("language", code);
                          say(translated("Notice", "From the next start on: %1").arg(text), 8000);
                          return {};
                      },
                      [this, code] { return language_ == code; }});
    };
    add("system", "", translated("Action", "The desktop's language"));
    for (const LanguageChoice& one : kLanguages) add(one.code, one.code, QString::fromUtf8(one.name));
}

void Window::add_view_switches() {
    actions_.add({"full-screen", "View", translated("Action", "Full screen, the picture alone"), "F11", "",
                  [this](const QStringList&) -> Result<void> {
                      set_full_screen(!isFullScreen());
                      return {};
                  },
                  [this] { return isFullScreen(); }});
    actions_.add({"second-display", "View", translated("Action", "The picture on a second display"),
                  "Shift+F11", "[off|window|NUMBER|NAME]",
                  [this](const QStringList& words) -> Result<void> {
                      const bool closes =
                          words.isEmpty() ? second_.is_open() || second_.waits() : words[0] == "off";
                      if (!closes) return second_.open(words.value(0), screen());
                      second_.close();
                      return {};
                  },
                  [this] { return second_.is_open(); }});
    actions_.add({"second-window", "View", translated("Action", "The picture in a second window"), "", "",
                  [this](const QStringList&) -> Result<void> {
                      if (!second_.is_open()) return second_.open("window", screen());
                      second_.close();
                      return {};
                  },
                  [this] { return second_.is_open(); }});
    actions_.add({"reset-figures",
                  "",
                  "reset-figures",
                  "",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      app_.reset_figures();
                      view_->reset_figures();
                      loop_->reset();
                      return {};
                  },
                  {}});
    actions_.add({"black-out", "View", translated("Action", "Black-out"), "B", "",
                  [this](const QStringList&) -> Result<void> {
                      app_.change_request(
                          [](ViewRequest& request) { request.black_out = !request.black_out; });
                      return {};
                  },
                  [this] { return app_.request().black_out; }});
    actions_.add({"work-light", "View",
                  translated("Action", "Work light: see the stage where nothing shines"), "K",
                  "[on|off|auto]",
                  [this](const QStringList& words) -> Result<void> {
                      const QString word = words.value(0, has_work_light() ? "off" : "on");
                      if (word != "on" && word != "off" && word != "auto")
                          return Error{"'" + word.toStdString() + "' is none of on, off and auto", ""};
                      const WorkLight wanted = word == "on"    ? WorkLight::on
                                               : word == "off" ? WorkLight::off
                                                               : WorkLight::automatic;
                      app_.change_request([&](ViewRequest& request) { request.work_light = wanted; });
                      return {};
                  },
                  [this] { return has_work_light(); }});
    actions_.add({"master",
                  "",
                  "master",
                  "",
                  "SHARE",
                  [this](const QStringList& words) -> Result<void> {
                      TRY(const double share, number_of(words, 0, "share", 0, 1));
                      app_.change_request(
                          [&](ViewRequest& request) { request.master = static_cast<float>(share); });
                      return {};
                  },
                  {}});
    const auto add = [this](const QString& name, const QString& text, const QString& key,
                            bool OverlayChoice::*one) {
        actions_.add({name, "View", text, key, "",
                      [this, one](const QStringList&) -> Result<void> {
                          view_->overlays.*one = !(view_->overlays.*one);
                          view_->update();
                          return {};
                      },
                      [this, one] { return view_->overlays.*one; }});
    };
    add("chips", translated("Action", "Where levels come from, exposure, what hands hold"), "",
        &OverlayChoice::chips);
    add("figures", translated("Action", "Frame time and latency"), "I", &OverlayChoice::figures);
    add("names", translated("Action", "Names of fixtures"), "N", &OverlayChoice::names);
    add("addresses", translated("Action", "Addresses of fixtures"), "U", &OverlayChoice::addresses);
    add("aims", translated("Action", "Where fixtures point"), "L", &OverlayChoice::aims);
    add("frame", translated("Action", "Frame of the camera"), "G", &OverlayChoice::frame);
    add("marks", translated("Action", "Marks of the selection"), "M", &OverlayChoice::marks);
    add("movers", translated("Action", "Movers: their ways, end stops and where they go"), "",
        &OverlayChoice::movers);
}

void Window::set_full_screen(bool full) {
    if (full) {
        docks_shown_.clear();
        in_front_.clear();
        sizes_in_front_.clear();
        for (QDockWidget* dock : docks_) {
            docks_shown_.push_back(dock->isVisible());
            if (dock->visibleRegion().isEmpty()) continue;
            in_front_.push_back(dock);
            sizes_in_front_.push_back(dock->size());
        }
        size_before_ = size();
        for (QDockWidget* dock : docks_) dock->hide();
        transport_shown_ = transport_->isVisible();
        strip_shown_ = strip_->isVisible();
    }
    menuBar()->setVisible(!full);
    transport_->setVisible(!full && transport_shown_);
    strip_->setVisible(!full && strip_shown_);
    statusBar()->setVisible(!full);
    if (full) {
        // What is left may need more width than a window has whose display got another scale; Qt resizes it
        // then, which would end the full screen.
        layout()->activate();
        setWindowState(windowState() | Qt::WindowFullScreen); // one that is maximised is so again afterwards
    } else {
        setWindowState(windowState() & ~Qt::WindowFullScreen);
        reach_.look(); // its display may have gone meanwhile
        for (std::size_t i = 0; i < docks_shown_.size(); ++i) docks_[i]->setVisible(docks_shown_[i]);
        for (QDockWidget* dock : in_front_) dock->raise();
        rail_->leave_full_screen();
        QMetaObject::invokeMethod(
            this, [this] { give_sizes_back(); }, Qt::QueuedConnection);
    }
    view_->setFocus();
}

// Panels that come back share what there is anew, so they get theirs when the window has its own again, which
// a window manager gives it when it likes.
void Window::give_sizes_back() {
    if (size_before_.isEmpty() || isFullScreen() || size() != size_before_) return;
    size_before_ = {};
    layout()->activate();
    int tabs_height = 0; // of the bar over panels that lie behind one another, which is shared out as well
    for (const QTabBar* const tabs : findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        if (tabs->isVisible()) tabs_height = std::max(tabs_height, tabs->height());
    QList<int> widths, heights;
    for (qsizetype k = 0; k < in_front_.size(); ++k) {
        const QSize& size = sizes_in_front_[static_cast<std::size_t>(k)];
        widths.push_back(size.width());
        heights.push_back(size.height() + (tabifiedDockWidgets(in_front_[k]).isEmpty() ? 0 : tabs_height));
    }
    resizeDocks(in_front_, widths, Qt::Horizontal);
    resizeDocks(in_front_, heights, Qt::Vertical);
}

void Window::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    QMetaObject::invokeMethod(
        this, [this] { give_sizes_back(); }, Qt::QueuedConnection);
}

// What is measured has none, and none is seen of it then.
bool Window::has_work_light() const {
    return app_.request().false_colour.measure == Measure::none ? app_.picture().has_work_light
                                                                : app_.request().work_light == WorkLight::on;
}

void Window::show_shortcuts() {
    auto* sheet = new ShortcutSheet(actions_, this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

Result<void> Window::save_picture(const QString& file) {
    if (!app_.picture().image) return Error{"there is no picture yet", ""};
    if (file.endsWith(".exr", Qt::CaseInsensitive) || view_->is_picture_on_device()) {
        // The engine has the linear values, and the newest picture; it says when they are there.
        app_.change_request([&](ViewRequest& request) {
            ++request.save_frame.number;
            request.save_frame.file = file.toStdString();
        });
        return {};
    }
    return aside(
        [image = app_.picture().image, to = file.toStdString()] { return image::write_png(to, *image); });
}

Result<void> Window::save_state(const QStringList& arguments) {
    QJsonObject state = state_json(app_, *view_);
    QJsonArray looks;
    for (const scene::StoredLook& look : looks_.all()) looks.append(QString::fromStdString(look.name));
    state["looks"] = looks;
    state["look"] = QString::fromStdString(looks_.current());
    if (cues_.current()) state["cue"] = QString::fromStdString(cues_.all()[*cues_.current()].name);
    QJsonObject titles;
    for (const Action& action : actions_.all())
        if (action.text != action.name) titles[action.name] = actions_.item(action.name)->text();
    state["language"] = language();
    state["titles"] = titles;
    state["toast"] = toast_->words();
    state["notice"] = notice_->words();
    state["dark"] = static_cast<int>(
        std::count_if(app_.verdicts().begin(), app_.verdicts().end(),
                      [](const Verdict& verdict) { return verdict.visibility != scene::Visibility::lit; }));
    if (const scene::PlotPage* const page = plot_report_.page()) {
        QJsonArray lightless;
        for (const scene::LightlessType& type : page->lightless)
            lightless.append(QJsonObject{
                {"file", QString::fromStdString(type.wanted)},
                {"heads", static_cast<int>(type.fixtures.size())},
                {"dark", type.is_dark},
                {"stand_in",
                 type.stand_ins.empty() ? QString() : QString::fromStdString(type.stand_ins.front().label)}});
        state["plot_page"] = QJsonObject{{"missing", page->count(Severity::error)},
                                         {"guessed", page->count(Severity::warning)},
                                         {"odd", page->count(Severity::note)},
                                         {"lightless", lightless}};
    }
    QJsonArray jobs;
    for (const Job& job : app_.jobs().all())
        jobs.append(QJsonObject{{"title", job.title},
                                {"state", state_name(job.state)},
                                {"share", job.share},
                                {"left", job.left},
                                {"said", job.last_said}});
    state["jobs"] = jobs;
    QJsonArray panels;
    for (const QDockWidget* dock : docks_)
        if (dock->isVisible() && !dock->visibleRegion().isEmpty()) panels.append(dock->objectName());
    state["panels"] = panels;                             // that are seen
    state["event_loop_ms"] = latency_json(loop_->busy()); // busy at a stretch
    state["second_display"] = second_.words();
    state["unsaved"] = document_.is_changed();
    state["changes_wait"] = document_.has_draft();
    state["read_only"] = document_.is_read_only();
    const QByteArray text = QJsonDocument(state).toJson();
    return write_file_atomic(arguments.value(0).toStdString(), text.toStdString());
}

} // namespace ghost::ui
