// SPDX-License-Identifier: Apache-2.0
#include "ui/window/window.h"

#include "show/show.h"
#include "ui/actions/aiming.h"
#include "ui/actions/can_do.h"
#include "ui/actions/export_actions.h"
#include "ui/actions/fan_actions.h"
#include "ui/actions/hang_edit.h"
#include "ui/actions/look_actions.h"
#include "ui/actions/object_edit.h"
#include "ui/actions/patch_actions.h"
#include "ui/actions/patch_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/actions/show_actions.h"
#include "ui/actions/tone_actions.h"
#include "ui/language/language.h"
#include "ui/panels/air_panel.h"
#include "ui/panels/browser_panel.h"
#include "ui/panels/cue_panel.h"
#include "ui/panels/export_panel.h"
#include "ui/panels/fixture_panel.h"
#include "ui/panels/look_panel.h"
#include "ui/panels/message_panel.h"
#include "ui/panels/network_panel.h"
#include "ui/panels/plot_panel.h"
#include "ui/panels/programmer_panel.h"
#include "ui/panels/scene_panel.h"
#include "ui/panels/transport_panel.h"
#include "ui/panels/value_panel.h"
#include "ui/picture/camera_strip.h"
#include "ui/picture/view_bar.h"
#include "ui/widgets/focus_guide.h"
#include "ui/widgets/panel_area.h"
#include "ui/widgets/plain_labels.h"
#include "ui/widgets/popup_keys.h"
#include "ui/widgets/undo_keys.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/window/private/meter_actions.h"
#include "ui/window/private/notice_bar.h"
#include "ui/window/private/panel_rail.h"
#include "ui/window/private/plot_actions.h"
#include "ui/window/private/print_dialog.h"
#include "ui/window/private/tear_off.h"
#include "ui/window/private/welcome.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kLayoutVersion = 3;        // another number: a layout of an older program is not taken
constexpr int kTwoColumnsFrom_px = 2200; // of the window; a narrower one has all panels at its left

} // namespace

Window::Window(Link& link, const WindowOptions& options)
    : options_(options), app_(link), document_(app_), looks_(app_), plot_report_(app_, options.fixtures),
      cues_(app_, document_, looks_), palettes_(app_, document_), exporter_(app_, document_), second_(app_),
      actions_(*this), view_(new View(app_, this)), recent_(app_, options.remembers),
      menus_(actions_, app_, document_, recent_), toast_(new Toast(view_)), status_input_(new QLabel(this)),
      status_supply_(new QLabel(this)), status_jobs_(new QLabel(this)), status_device_(new QLabel(this)) {
    setWindowTitle("Ghostlight");
    setAcceptDrops(true);
    qApp->installEventFilter(new PlainLabels(this));
    qApp->installEventFilter(new WheelGuard(this));
    qApp->installEventFilter(new PopupKeys(this));
    auto* const undo_keys = new UndoKeys(this);
    qApp->installEventFilter(undo_keys);
    // The next key is one of the window's again; the number takes its own first.
    connect(
        undo_keys, &UndoKeys::entered, this,
        [this](QWidget* number) {
            if (number->window()->focusWidget() != number) return; // it went on by itself
            number->clearFocus();
            view_->setFocus();
        },
        Qt::QueuedConnection);
    setDockNestingEnabled(true);
    setCentralWidget(view_);
    for (QLabel* const one : {status_input_, status_supply_, status_jobs_, status_device_})
        one->setMinimumWidth(1); // long words do not make the window wider than a small display
    statusBar()->addWidget(status_input_, 1);
    statusBar()->addPermanentWidget(status_jobs_);
    statusBar()->addPermanentWidget(status_supply_);
    statusBar()->addPermanentWidget(status_device_);
    actions_.show_folder = [this] {
        if (app_.show()) return QString::fromStdString(app_.show()->folder.string());
        return recent_.all().empty() ? QDir::homePath() : QFileInfo(recent_.all().front().path).path();
    };
    actions_.complain = [this](const Error& error) { say_refused(error, is_edit(error.where)); };
    const auto edit_refused = [this](const Error& error) { say_refused(error, true); };
    actions_.ask_word = [this](const QString& what, const QString& value,
                               std::function<Result<void>(const QString&)> done) {
        toast_->ask(what, value, [done = std::move(done)](const QString& word) {
            const Result<void> taken = done(word);
            return taken.ok() ? QString() : said(taken.error().what);
        });
    };
    cues_.complain = actions_.complain;
    looks_.may_write = [this] { return document_.check_ours(); };
    connect(&app_.undo_stack(), &QUndoStack::undoTextChanged, this, &Window::name_steps);
    connect(&app_.undo_stack(), &QUndoStack::redoTextChanged, this, &Window::name_steps);
    rail_ = new PanelRail(*this);
    add_panels();
    add_strip();
    add_window_actions();
    add_view_switches();
    add_languages();
    add_meter_actions(actions_, app_, *view_);
    add_programmer_actions(actions_, app_);
    add_camera_actions(actions_, app_, [this] { return fixtures_->listed(); });
    add_tone_actions(actions_, app_);
    add_play_actions(actions_, app_);
    add_look_actions(actions_, app_, looks_);
    add_cue_actions(actions_, cues_);
    add_fan_actions(actions_, app_);
    add_palette_actions(actions_, palettes_);
    add_export_actions(actions_, app_, exporter_);
    add_print_actions(actions_, app_, document_, *this);
    add_patch_actions(actions_, app_, document_);
    add_hang_action(actions_, app_, document_);
    auto* aiming = new Aiming(app_, actions_, this);
    add_aim_actions(actions_, app_, *aiming);
    view_->on_aim = [aiming, edit_refused](const glm::vec2& place) {
        if (const auto done = aiming->aim_through(place); !done.ok()) edit_refused(done.error());
    };
    view_->on_move = [this, edit_refused](const glm::vec3& by_m) {
        if (const auto done = PatchEdit(app_, document_).move_by(by_m); !done.ok())
            edit_refused(done.error());
    };
    view_->on_move_object = [this, edit_refused](std::size_t object, const glm::vec3& by_m) {
        if (const auto done = move_object(app_, document_, object, by_m); !done.ok())
            edit_refused(done.error());
    };
    add_object_actions(actions_, app_, document_);
    auto* hiding = new Hiding(app_, actions_, this);
    hiding->on_done = [this](const QString& what) { say_step(what); };
    add_hide_action(actions_, *hiding);
    add_air_actions(actions_, app_, document_);
    add_bounce_actions(actions_, app_, document_);
    add_document_actions(actions_, document_);
    add_show_actions(actions_, app_, document_, options_.docs, *this);
    add_selection_actions(actions_, app_);
    add_plot_actions(actions_, app_, document_, plot_report_);
    add_rdm_action(actions_, *rdm_);
    rdm_->complain = edit_refused;
    rdm_->on_done = [this](const QString& what) { say_step(what); };
    rdm_->set_access(options_.rdm);
    connect(&plot_report_, &PlotReport::changed, this, &Window::show_plot_page);
    new FocusGuide(view_);
    menus_.fill(*menuBar());
    menuBar()->setCornerWidget(new ViewBar(app_, actions_, menuBar()), Qt::TopRightCorner);
    auto* context_menus = new ContextMenus(menus_, app_, view_);
    context_menus->serve_fixtures(fixtures_->table());
    context_menus->serve(look_list_->list(), [this](QMenu& menu) { look_list_->fill_menu(menu); });
    auto* const strip = strip_->findChild<CameraStrip*>();
    context_menus->serve(strip, [strip](QMenu& menu) { strip->fill_menu(menu); });
    context_menus->serve(cue_table_->table(), [this](QMenu& menu) { cue_table_->fill_menu(menu); });
    PaletteBox& palettes = programmer_->palettes();
    context_menus->serve(palettes.list(), [&palettes](QMenu& menu) { palettes.fill_menu(menu); });
    connect(&app_.undo_stack(), &QUndoStack::indexChanged, this, [this](int index) {
        ++steps_;
        if (index < step_said_) step_said_ = -1; // what comes there now is another one
        toast_->allow_undo(index == step_said_);
        say_hand_taken();
    });
    actions_.count_steps = [this] { return steps_; };
    actions_.on_done = [this](const Action& action, bool made_step) {
        forget_refused();
        say_done(action, made_step);
    };
    // Also where another show has none; what hands take is said once its step is in the undo list.
    connect(&app_, &AppModel::look_changed, this,
            [this] { had_hand_ = had_hand_ && !app_.look().fixtures.empty(); });
    transport_ = new QToolBar(translated("Panel", "Transport"), this);
    transport_->setObjectName("transport");
    transport_->setMovable(false);
    transport_->addWidget(new TransportPanel(app_, actions_, transport_));
    addToolBar(Qt::BottomToolBarArea, transport_);
    addToolBarBreak(Qt::BottomToolBarArea); // the later one lies above
    addToolBar(Qt::BottomToolBarArea, strip_);
    strip_->hide();
    notice_ = new NoticeBar(actions_, document_, app_, view_);
    fixtures_->complain = edit_refused;
    connect(&document_, &ShowDocument::changed, this, &Window::show_title);
    connect(&document_, &ShowDocument::fixtures_renamed, &looks_, &Looks::rename_fixtures);
    connect(&looks_, &Looks::renamed, this, [this, edit_refused](const QString& name, const QString& to) {
        if (const auto done = cues_.rename_look(name.toStdString(), to.toStdString()); !done.ok())
            edit_refused(done.error());
    });
    connect(&app_, &AppModel::opened_show, this, &Window::name_cameras);
    connect(&app_, &AppModel::opened_show, this, [this] {
        show_title();
        if (app_.opened().is_edit) return;
        forget_refused();
        plot_is_new_ = !app_.opened().again && !app_.show()->plot_file.empty();
        rail_->wait_for_show(false);
        transport_shown_ = true;
        if (!isFullScreen()) transport_->show();
        begin_where_show_says();
        view_->setFocus();
        if (!options_.remembers || !QSettings().contains("layout version"))
            say(options_.takes_desk && app_.request().input == Input::automatic
                    ? translated("Notice", "Press ? for all keys. A desk that sends sACN or Art-Net takes "
                                           "over by itself.")
                    : translated("Notice", "Press ? for all keys."),
                20000);
    });
    connect(&app_, &AppModel::failed, this, [this](const QString& what) { say(what, 15000); });
    connect(&app_, &AppModel::plot_came, this, [this] {
        const ReceivedPlot& plot = app_.plot();
        say(translated("Notice", "%1 sent a plot (%2): Show, Take the received plot, Ctrl+T")
                .arg(QString::fromStdString(plot.from),
                     QString::fromStdString(plot.comment.empty() ? plot.file : plot.comment)));
    });
    connect(&app_, &AppModel::request_changed, this, [this] { actions_.refresh(); });
    connect(&app_, &AppModel::rig_came, this, &Window::show_status);
    connect(&app_, &AppModel::picture_came, this, [this] {
        const QString supply = said(app_.picture().supply);
        if (supply != status_supply_->text()) status_supply_->setText(supply);
        if (has_work_light() != actions_.item("work-light")->isChecked()) actions_.refresh();
    });
    connect(&app_, &AppModel::picture_saved, this, [this](const QString& error) {
        say(error.isEmpty() ? translated("Notice", "The picture is saved") : error, 8000);
    });
    connect(&app_, &AppModel::recording_ended, this, [this] {
        const Recorded& recorded = app_.recorded();
        say(recorded.error ? said(recorded.error->text())
                           : translated("Notice", "Recorded %1 s to %2: Play, Play what was recorded last")
                                 .arg(recorded.seconds, 0, 'f', 1)
                                 .arg(QString::fromStdString(recorded.file)),
            20000);
        actions_.refresh();
    });
    second_.on_key = [this](const QKeyEvent& key) { return press_shortcut(*this, key); };
    connect(&second_, &SecondDisplay::changed, this, [this](const QString& what) {
        if (!what.isEmpty()) say(what, 15000);
        actions_.refresh();
    });
    connect(&reach_, &OnScreen::moved, this, [this](const QString& what) { say(what, 15000); });
    connect(&app_.jobs(), &Jobs::changed, this, &Window::show_jobs);
    connect(&app_.jobs(), &Jobs::ended, this,
            [this](const Job& job) { say(job.title + ": " + outcome_words(job), 15000); });
    const QSize room = screen()->availableSize();
    resize(room.isEmpty() ? QSize(1280, 760) : room);
    if (options_.width == 0) setWindowState(Qt::WindowMaximized);
    QSettings settings;
    if (const auto tone = image::tone_from(settings.value("tone").toString().toStdString());
        options_.remembers && tone.ok())
        app_.change_request([&](ViewRequest& request) { request.tone = *tone; });
    if (options_.remembers && settings.value("layout version").toInt() == kLayoutVersion) {
        (void)place_.put_back(settings);
        restoreState(settings.value("docks").toByteArray(), kLayoutVersion);
        if (options_.width > 0) {
            setWindowState(Qt::WindowNoState);
            resize(options_.width, options_.height);
        }
    } else {
        if (options_.width > 0) resize(options_.width, options_.height);
        const QSize asked = size();
        has_first_layout_ = true;
        lay_out();
        layout()->activate();
        resize(asked); // while panels changed places they needed more
    }
    new Welcome(actions_, app_, recent_, !options_.demo.empty(), view_);
    notice_->raise();
    connect(rail_, &PanelRail::came_back, this, [this] {
        if (has_first_layout_) share_columns();
    });
    if (options_.show.empty()) {
        rail_->wait_for_show(true);
        transport_->hide();
    }
    rail_->fit();
    actions_.refresh();
}

// Qt closes a window that goes, and its panels would speak to what went before them.
Window::~Window() {
    app_.undo_stack().disconnect(this); // it tells of its end
    delete rail_;
    strip_->disconnect(this);
    delete strip_; // while there are panels: it says that it goes
    for (QDockWidget* const panel : findChildren<QDockWidget*>()) {
        panel->disconnect(this);
        delete panel;
    }
    delete takeCentralWidget();
}

QDockWidget* Window::add_panel(const QString& name, const QString& title, QWidget* panel,
                               Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name); // the layout is remembered by it
    auto* const holder = new PanelArea(panel, dock);
    dock->setWidget(holder);
    // What needs a show waits for one. Network and messages do not, and jobs have their Cancel in Export.
    if (static const std::set<QString> kNeedNoShow{"network", "messages", "browsers", "export"};
        !kNeedNoShow.contains(name)) {
        holder->setEnabled(false);
        connect(&app_, &AppModel::opened_show, holder, [holder] { holder->setEnabled(true); });
    }
    new TearOff(*dock);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    rail_->add(*dock);
    const QString key = docks_.size() <= 9 ? QString("Ctrl+%1").arg(docks_.size()) : QString();
    actions_.add({"panel-" + name, "Panels", title, key, "[on|off]",
                  [this, dock](const QStringList& words) -> Result<void> {
                      // One that lies behind another's tab counts as visible, but nobody sees it.
                      const bool is_seen = dock->isVisible() && !dock->visibleRegion().isEmpty();
                      dock->setVisible(words.isEmpty() ? !is_seen : words[0] == "on");
                      if (dock->isVisible()) dock->raise();
                      if (dock->isVisible()) rail_->make_room(*dock);
                      return {};
                  },
                  [dock] { return dock->isVisible(); }});
    connect(dock, &QDockWidget::visibilityChanged, this, [this] { actions_.refresh(); });
    return dock;
}

void Window::add_panels() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    fixtures_ = new FixturePanel(app_, document_, this);
    add_panel("fixtures", translated("Panel", "Fixtures"), fixtures_, Qt::LeftDockWidgetArea);
    QDockWidget* values = add_panel("values", translated("Panel", "Values"), new ValuePanel(app_, this),
                                    Qt::RightDockWidgetArea);
    programmer_ = new ProgrammerPanel(app_, palettes_, actions_, this);
    QDockWidget* hand =
        add_panel("programmer", translated("Panel", "Programmer"), programmer_, Qt::RightDockWidgetArea);
    auto* scene_panel = new ScenePanel(app_, this);
    QDockWidget* scene =
        add_panel("scene", translated("Panel", "Scene"), scene_panel, Qt::RightDockWidgetArea);
    tabifyDockWidget(values, hand);
    tabifyDockWidget(hand, scene);
    hand->raise();
    QDockWidget* network = add_panel("network", translated("Panel", "Network"),
                                     new NetworkPanel(app_, actions_, this), Qt::BottomDockWidgetArea);
    QDockWidget* messages = add_panel("messages", translated("Panel", "Messages"),
                                      new MessagePanel(app_, this), Qt::BottomDockWidgetArea);
    tabifyDockWidget(network, messages);
    // Behind the others, whose keys people know.
    look_list_ = new LookPanel(app_, looks_, actions_, this);
    QDockWidget* looks =
        add_panel("looks", translated("Panel", "Looks"), look_list_, Qt::RightDockWidgetArea);
    tabifyDockWidget(scene, looks);
    auto* export_panel = new ExportPanel(app_, actions_, this);
    export_panel->can_begin = [this] {
        const Result<void> saved = exporter_.check_saved();
        if (!saved.ok()) say_refused(saved.error(), true, "save");
        return saved.ok();
    };
    QDockWidget* exports =
        add_panel("export", translated("Panel", "Export"), export_panel, Qt::RightDockWidgetArea);
    tabifyDockWidget(looks, exports);
    auto* air_panel = new AirPanel(app_, document_, actions_, this);
    air_panel->complain = [this](const Error& error) { say_refused(error, true); };
    QDockWidget* air = add_panel("air", translated("Panel", "Air"), air_panel, Qt::RightDockWidgetArea);
    tabifyDockWidget(exports, air);
    connect(scene_panel, &ScenePanel::asks_for_air, this, [this] { actions_.choose("panel-air on"); });
    connect(scene_panel, &ScenePanel::asks_for, this, [this](const QString& line) { actions_.choose(line); });
    connect(scene_panel, &ScenePanel::asks_to_hang, this, [this](std::size_t object) {
        if (const Result<void> done = hang_under(app_, document_, object); !done.ok())
            say_refused(done.error(), true);
    });
    cue_table_ = new CuePanel(app_, cues_, looks_, actions_, this);
    QDockWidget* cues = add_panel("cues", translated("Panel", "Cues"), cue_table_, Qt::RightDockWidgetArea);
    tabifyDockWidget(looks, cues);
    QDockWidget* plot = add_panel("plot", translated("Panel", "Plot"),
                                  new PlotPanel(app_, plot_report_, actions_, this), Qt::RightDockWidgetArea);
    tabifyDockWidget(hand, plot);
    actions_.item("panel-plot")->setText(translated("Action", "What this plot has"));
    QDockWidget* const browsers = options_.browsers ? add_browsers(*options_.browsers) : nullptr;
    if (browsers) tabifyDockWidget(air, browsers);
    exports->hide();
    air->hide();
    cues->hide();
    plot->hide();
    if (browsers) browsers->hide();
    hand->raise();
    network->hide();
    messages->hide();
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    for (const char* const name : {"fixtures", "programmer", "values", "looks", "cues", "scene", "air",
                                   "plot", "network", "messages", "export", "browsers"})
        if (QAction* const toggle = actions_.item(QString("panel-") + name)) rail_->add_button(name, *toggle);
    // Where the window manager draws the title of a torn-off panel, nothing on it puts it back.
    actions_.add({"panels-dock", "Panels", translated("Action", "Put torn-off panels back"), "", "",
                  [this](const QStringList&) -> Result<void> {
                      for (QDockWidget* const dock : docks_)
                          if (dock->isFloating()) dock->setFloating(false); // TearOff brings it to the front
                      return {};
                  }});
}

QDockWidget* Window::add_browsers(web::Browsers& browsers) {
    add_browser_actions(actions_, browsers);
    auto* panel = new BrowserPanel(browsers, actions_, this);
    QDockWidget* dock =
        add_panel("browsers", translated("Panel", "In browsers"), panel, Qt::RightDockWidgetArea);
    actions_.add({"in-browsers",
                  "View",
                  translated("Action", "In browsers..."),
                  "",
                  "",
                  [this](const QStringList&) { return actions_.run("panel-browsers on"); },
                  {}});
    return dock;
}

// Below the picture, where it is wanted.
void Window::add_strip() {
    strip_ = new QToolBar(translated("Panel", "Cameras"), this);
    strip_->setObjectName("cameras");
    strip_->setMovable(false);
    strip_->addWidget(new CameraStrip(app_, actions_, strip_));
    actions_.add({"camera-strip", "Camera", translated("Action", "Strip of the cameras' pictures"),
                  "Ctrl+Shift+K", "",
                  [this](const QStringList&) -> Result<void> {
                      strip_->setVisible(!strip_->isVisible());
                      return {};
                  },
                  [this] { return strip_->isVisible(); }});
    connect(strip_, &QToolBar::visibilityChanged, this, [this] { actions_.refresh(); });
}

// The picture first: of a window of 1366x768, 1920x1080 and 2560x1440 it has 60, 70 and 75 %.
void Window::lay_out() {
    const auto dock = [this](const char* name) { return findChild<QDockWidget*>(name); };
    if (width() < kTwoColumnsFrom_px) {
        splitDockWidget(docks_.front(), dock("values"), Qt::Vertical);
        for (const char* const name :
             {"programmer", "plot", "scene", "looks", "cues", "export", "air", "browsers"})
            if (dock(name)) tabifyDockWidget(dock("values"), dock(name));
        dock("programmer")->raise();
    }
    share_columns();
}

void Window::share_columns() {
    QDockWidget* const list = docks_.front();
    auto* const below = findChild<QDockWidget*>("programmer");
    if (width() < kTwoColumnsFrom_px) {
        resizeDocks({list}, {std::clamp(width() * 16 / 100, 275, 330)}, Qt::Horizontal);
        resizeDocks({list, below}, {height() * 4 / 10, height() * 5 / 10}, Qt::Vertical);
    } else {
        resizeDocks({list, below}, {235, 261}, Qt::Horizontal);
    }
}

// One that plays already stays where it is.
void Window::begin_where_show_says() {
    const double begin_s = app_.show()->begin_s;
    if (app_.opened().again || begin_s <= 0) return;
    app_.change_request([&](ViewRequest& request) {
        ++request.transport.seeks;
        request.transport.at_s = begin_s;
    });
}

// By itself where something is lost, dark or guessed that a designer should know of; in its place among the
// panels, so that the picture keeps its own.
void Window::show_plot_page() {
    const scene::PlotPage* const page = plot_report_.page();
    if (!page || !std::exchange(plot_is_new_, false)) return;
    if (page->matters() && !isFullScreen())
        if (const auto done = actions_.run("panel-plot on"); !done.ok()) actions_.complain(done.error());
}

void Window::name_cameras() {
    const std::vector<scene::Camera>& cameras = app_.show()->cameras;
    for (std::size_t number = 1; number <= 9; ++number) {
        QAction* item = actions_.item(QString("camera-%1").arg(number));
        item->setVisible(number <= cameras.size());
        if (number <= cameras.size()) item->setText(QString::fromStdString(cameras[number - 1].name));
    }
    status_device_->setText(QString::fromStdString(app_.opened().device));
}

void Window::closeEvent(QCloseEvent* event) {
    // By the window manager; close() of a script, or of an answer, is not spontaneous.
    if (event->spontaneous() && asks_to_close()) {
        event->ignore();
        return;
    }
    if (const Result<void> kept = document_.keep(); !kept.ok() && !closes_anyway_) {
        Q_EMIT document_.keep_failed(
            translated("Notice", "Not closed, for changes are not saved and cannot be kept: %1")
                .arg(said(kept.error().text())));
        event->ignore();
        return;
    }
    if (options_.remembers)
        QSettings().setValue("tone", QString::fromStdString(image::name_of(app_.request().tone)));
    if (options_.remembers && !isFullScreen()) {
        rail_->put_back(); // panels that waited are part of the layout
        QSettings settings;
        settings.setValue("layout version", kLayoutVersion);
        place_.keep(settings);
        settings.setValue("docks", saveState(kLayoutVersion));
    }
    second_.close(); // the last window that closes ends the program
    document_.let_go();
    event->accept();
}

void Window::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); }))
        event->acceptProposedAction();
}

void Window::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    const QPoint at = view_->mapFrom(this, event->position().toPoint());
    std::optional<glm::vec3> floor_m;
    if (app_.show() && view_->rect().contains(at)) floor_m = view_->floor_at(at);
    // Later: who drags waits for this, and a file may take a while.
    const auto take = [this, urls = event->mimeData()->urls(), floor_m] {
        for (const QUrl& url : urls)
            if (url.isLocalFile()) take_file(url.toLocalFile(), floor_m);
    };
    QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
}

// Of an open show a fixture, a model or a plot becomes a part; all else is opened.
void Window::take_file(const QString& file, const std::optional<glm::vec3>& floor_m) {
    const QString ending = QFileInfo(file).suffix().toLower();
    const bool is_fixture = ending == "gdtf" || ending == "qxf" || (ending == "json" && app_.show());
    const bool is_model_file = is_model(file.toStdString());
    const bool is_plot = ending == "mvr" && document_.can_edit() && app_.show()->plot_file.empty();
    const bool has_stage =
        app_.show() && (!app_.show()->stage_file.empty() || !app_.show()->plot_file.empty());
    const QString action = is_fixture                   ? "add-fixture"
                           : is_model_file && has_stage ? "add-model"
                           : is_model_file              ? "set-stage"
                                                        : "set-plot";
    if (!is_fixture && !is_model_file && !is_plot) {
        app_.open(file.toStdString());
        return;
    }
    QString line = action + " " + quoted(file);
    if (is_fixture && floor_m) line += QString(" %1 %2").arg(floor_m->x).arg(floor_m->y);
    actions_.choose(line);
}

} // namespace ghost::ui
