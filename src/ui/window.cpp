// SPDX-License-Identifier: Apache-2.0
#include "ui/window.h"

#include "base/files.h"
#include "image/ldr.h"
#include "ui/fixture_panel.h"
#include "ui/hand.h"
#include "ui/hand_panel.h"
#include "ui/message_panel.h"
#include "ui/network_panel.h"
#include "ui/notice_bar.h"
#include "ui/patch_actions.h"
#include "ui/scene_panel.h"
#include "ui/shortcut_sheet.h"
#include "ui/state_json.h"
#include "ui/transport_panel.h"
#include "ui/value_panel.h"

#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonDocument>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

namespace ghost::ui {
namespace {

constexpr int kLayoutVersion = 1; // another number: a layout of an older program is not taken

const char* const kHint = "Drop a show folder, a show.toml or an .mvr here, or press Ctrl+O.\n"
                          "The demo is assets/demo. Press ? for all keys.";

} // namespace

Window::Window(Link& link, const WindowOptions& options)
    : options_(options), studio_(link), document_(studio_), actions_(*this), view_(new View(studio_, this)),
      status_input_(new QLabel(this)), status_device_(new QLabel(this)) {
    setWindowTitle("Ghostlight");
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setCentralWidget(view_);
    view_->hint = kHint;
    statusBar()->addWidget(status_input_, 1);
    statusBar()->addPermanentWidget(status_device_);
    actions_.complain = [this](const Error& error) {
        statusBar()->showMessage(QString::fromStdString(error.text()), 8000);
    };
    add_panels();
    add_window_actions();
    add_view_switches();
    add_hand_actions(actions_, studio_);
    add_camera_actions(actions_, studio_);
    add_play_actions(actions_, studio_);
    add_patch_actions(actions_, studio_, document_);
    add_document_actions(actions_, document_);
    make_menus();
    auto* transport = new QToolBar("Transport", this);
    transport->setObjectName("transport");
    transport->setMovable(false);
    transport->addWidget(new TransportPanel(studio_, actions_, transport));
    addToolBar(Qt::BottomToolBarArea, transport);
    addToolBar(Qt::TopToolBarArea, new NoticeBar(actions_, document_, this));
    fixtures_->model().complain = actions_.complain;
    connect(&document_, &ShowDocument::changed, this, [this] { setWindowModified(document_.is_changed()); });
    connect(&studio_, &Studio::opened_show, this, &Window::name_cameras);
    connect(&studio_, &Studio::opened_show, this, [this] {
        setWindowTitle(QString::fromStdString(studio_.show()->name.empty() ? studio_.show()->file.string()
                                                                           : studio_.show()->name) +
                       "[*] - Ghostlight");
        if (studio_.opened().is_edit) return;
        view_->setFocus();
        if (!options_.remembers || !QSettings().contains("layout version"))
            statusBar()->showMessage(
                "Press ? for all keys. A desk that sends sACN or Art-Net to this machine takes over by "
                "itself.",
                20000);
    });
    connect(&studio_, &Studio::failed, this, [this](const QString& what) {
        view_->hint = what + "\n\n" + kHint;
        statusBar()->showMessage(what, 15000);
        view_->update();
    });
    connect(&studio_, &Studio::plot_came, this, [this] {
        const ReceivedPlot& plot = studio_.plot();
        statusBar()->showMessage(QString::fromStdString(plot.from + " sent a plot (" +
                                                        (plot.comment.empty() ? plot.file : plot.comment) +
                                                        "): Show, Take the received plot, Ctrl+T"));
    });
    connect(&studio_, &Studio::wishes_changed, this, [this] { actions_.refresh(); });
    connect(&studio_, &Studio::rig_came, this, &Window::show_status);
    resize(1280, 760);
    QSettings settings;
    if (options_.remembers && settings.value("layout version").toInt() == kLayoutVersion) {
        restoreGeometry(settings.value("geometry").toByteArray());
        restoreState(settings.value("docks").toByteArray(), kLayoutVersion);
    }
    if (options_.width > 0) resize(options_.width, options_.height);
    actions_.refresh();
}

// Qt closes a window that goes, and its panels would speak to what went before them.
Window::~Window() {
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
    dock->setWidget(panel);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    const QString key = docks_.size() <= 8 ? QString("Ctrl+%1").arg(docks_.size()) : QString();
    actions_.add({"panel-" + name, "Panels", title, key, "[on|off]",
                  [dock](const QStringList& words) -> Result<void> {
                      dock->setVisible(words.isEmpty() ? !dock->isVisible() : words[0] == "on");
                      if (dock->isVisible()) dock->raise();
                      return {};
                  },
                  [dock] { return dock->isVisible(); }});
    connect(dock, &QDockWidget::visibilityChanged, this, [this] { actions_.refresh(); });
    return dock;
}

void Window::add_panels() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    fixtures_ = new FixturePanel(studio_, document_, this);
    add_panel("fixtures", "Fixtures", fixtures_, Qt::LeftDockWidgetArea);
    QDockWidget* values =
        add_panel("values", "Values", new ValuePanel(studio_, this), Qt::RightDockWidgetArea);
    QDockWidget* hand = add_panel("hand", "By hand", new HandPanel(studio_, this), Qt::RightDockWidgetArea);
    QDockWidget* scene = add_panel("scene", "Scene", new ScenePanel(studio_, this), Qt::RightDockWidgetArea);
    tabifyDockWidget(values, hand);
    tabifyDockWidget(hand, scene);
    hand->raise();
    QDockWidget* network =
        add_panel("network", "Network", new NetworkPanel(studio_, this), Qt::BottomDockWidgetArea);
    QDockWidget* messages =
        add_panel("messages", "Messages", new MessagePanel(studio_, this), Qt::BottomDockWidgetArea);
    tabifyDockWidget(network, messages);
    network->hide();
    messages->hide();
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    resizeDocks({docks_.front(), values}, {310, 360}, Qt::Horizontal);
}

void Window::add_window_actions() {
    actions_.add({"open",
                  "Show",
                  "Open a show...",
                  "Ctrl+O",
                  "[PATH]",
                  [this](const QStringList& words) { return choose_show(words); },
                  {}});
    actions_.add({"take-plot",
                  "Show",
                  "Take the received plot",
                  "Ctrl+T",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (studio_.plot().number == 0)
                          return Error{"no plot came from the network (MVR-xchange)", ""};
                      studio_.wish([&](Wishes& wishes) { wishes.take_plot = studio_.plot().number; });
                      statusBar()->clearMessage();
                      return {};
                  },
                  {}});
    actions_.add({"save-picture",
                  "Show",
                  "Save the picture...",
                  "Ctrl+Shift+S",
                  "[FILE]",
                  [this](const QStringList& words) { return save_picture(words); },
                  {}});
    actions_.add({"screenshot",
                  "Show",
                  "Save a picture of the window...",
                  "",
                  "[FILE]",
                  [this](const QStringList& words) { return save_screenshot(words); },
                  {}});
    actions_.add({"state",
                  "",
                  "state",
                  "",
                  "FILE",
                  [this](const QStringList& words) { return save_state(words); },
                  {}});
    actions_.add({"quit",
                  "Show",
                  "Quit",
                  "Ctrl+Q",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      close();
                      return {};
                  },
                  {}});
    actions_.add({"undo",
                  "Edit",
                  "Undo",
                  "Ctrl+Z",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (!studio_.undo_stack().canUndo()) return Error{"there is nothing to undo", ""};
                      studio_.undo_stack().undo();
                      return {};
                  },
                  {}});
    actions_.add({"redo",
                  "Edit",
                  "Redo",
                  "Ctrl+Shift+Z; Ctrl+Y",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      if (!studio_.undo_stack().canRedo()) return Error{"there is nothing to redo", ""};
                      studio_.undo_stack().redo();
                      return {};
                  },
                  {}});
    actions_.add({"find",
                  "Edit",
                  "Find a fixture",
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
                  "Keys",
                  "?; F1",
                  "",
                  [this](const QStringList&) -> Result<void> {
                      show_shortcuts();
                      return {};
                  },
                  {}});
}

void Window::add_view_switches() {
    actions_.add({"full-screen", "View", "Full screen, the picture alone", "F11", "",
                  [this](const QStringList&) -> Result<void> {
                      set_full_screen(!isFullScreen());
                      return {};
                  },
                  [this] { return isFullScreen(); }});
    actions_.add({"black-out", "View", "Black-out", "B", "",
                  [this](const QStringList&) -> Result<void> {
                      studio_.wish([](Wishes& wishes) { wishes.black_out = !wishes.black_out; });
                      return {};
                  },
                  [this] { return studio_.wishes().black_out; }});
    actions_.add({"master",
                  "",
                  "master",
                  "",
                  "SHARE",
                  [this](const QStringList& words) -> Result<void> {
                      TRY(const double share, number_of(words, 0, "share", 0, 1));
                      studio_.wish([&](Wishes& wishes) { wishes.master = static_cast<float>(share); });
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
    add("figures", "Frame time and latency", "I", &OverlayChoice::figures);
    add("names", "Names of fixtures", "N", &OverlayChoice::names);
    add("addresses", "Addresses of fixtures", "U", &OverlayChoice::addresses);
    add("aims", "Where fixtures point", "L", &OverlayChoice::aims);
    add("marks", "Marks of the selection", "M", &OverlayChoice::marks);
}

void Window::make_menus() {
    // Panels come first in the table, for their docks do; people look for the show first.
    for (const char* const title : {"Show", "Edit", "View", "Camera", "Play", "Quality", "Panels", "Help"}) {
        QMenu* menu = menuBar()->addMenu(title);
        for (const Action& action : actions_.all())
            if (action.menu == title) menu->addAction(actions_.item(action.name));
    }
}

void Window::name_cameras() {
    const std::vector<scene::Camera>& cameras = studio_.show()->cameras;
    for (std::size_t number = 1; number <= 9; ++number) {
        QAction* item = actions_.item(QString("camera-%1").arg(number));
        item->setVisible(number <= cameras.size());
        if (number <= cameras.size()) item->setText(QString::fromStdString(cameras[number - 1].name));
    }
    status_device_->setText(QString::fromStdString(studio_.opened().device));
}

void Window::show_status() {
    const RigNow& rig = studio_.rig();
    const bool listens = options_.takes_desk;
    QString text;
    if (rig.from_desk)
        text = rig.universes.list.empty() ? QString(listens ? "Listening for a desk: nothing has come yet"
                                                            : "No input: started with --no-desk")
                                          : QString("A desk: %1 universes").arg(rig.universes.list.size());
    else
        text = QString("Recording, %1 of %2 s")
                   .arg(rig.at_s, 0, 'f', 1)
                   .arg(studio_.opened().recording_s, 0, 'f', 1);
    status_input_->setText(text);
}

void Window::set_full_screen(bool full) {
    if (full) {
        docks_shown_.clear();
        for (QDockWidget* dock : docks_) docks_shown_.push_back(dock->isVisible());
        for (QDockWidget* dock : docks_) dock->hide();
        showFullScreen();
    } else {
        showNormal();
        for (std::size_t i = 0; i < docks_shown_.size(); ++i) docks_[i]->setVisible(docks_shown_[i]);
    }
    menuBar()->setVisible(!full);
    statusBar()->setVisible(!full);
    view_->setFocus();
}

void Window::show_shortcuts() {
    auto* sheet = new ShortcutSheet(actions_, this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

Result<void> Window::choose_show(const QStringList& arguments) {
    QString path = arguments.value(0);
    if (path.isEmpty())
        path = QFileDialog::getOpenFileName(this, "Open a show", QDir::currentPath(),
                                            "Shows (show.toml *.mvr);;All files (*)");
    if (!path.isEmpty()) studio_.open(path.toStdString());
    return {};
}

Result<void> Window::save_screenshot(const QStringList& arguments) {
    const QString file = arguments.isEmpty()
                             ? QFileDialog::getSaveFileName(this, "Save a picture of the window",
                                                            "window.png", "Pictures (*.png)")
                             : arguments[0];
    if (file.isEmpty() || grab().save(file, "PNG")) return {};
    return Error{"the picture cannot be written", file.toStdString()};
}

Result<void> Window::save_picture(const QStringList& arguments) {
    if (!studio_.picture().image) return Error{"there is no picture yet", ""};
    const QString file = arguments.isEmpty() ? QFileDialog::getSaveFileName(this, "Save the picture",
                                                                            "picture.png", "Pictures (*.png)")
                                             : arguments[0];
    if (file.isEmpty()) return {};
    return image::write_png(file.toStdString(), *studio_.picture().image);
}

Result<void> Window::save_state(const QStringList& arguments) {
    QJsonObject state = state_json(studio_, *view_);
    state["unsaved"] = document_.is_changed();
    state["changes_wait"] = document_.has_draft();
    const QByteArray text = QJsonDocument(state).toJson();
    return write_file_atomic(arguments.value(0).toStdString(), text.toStdString());
}

void Window::closeEvent(QCloseEvent* event) {
    if (options_.remembers && !isFullScreen()) {
        QSettings settings;
        settings.setValue("layout version", kLayoutVersion);
        settings.setValue("geometry", saveGeometry());
        settings.setValue("docks", saveState(kLayoutVersion));
    }
    event->accept();
}

void Window::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls[0].isLocalFile()) event->acceptProposedAction();
}

void Window::dropEvent(QDropEvent* event) {
    const QString file = event->mimeData()->urls().value(0).toLocalFile();
    event->acceptProposedAction();
    const bool is_fixture =
        file.endsWith(".gdtf", Qt::CaseInsensitive) || file.endsWith(".qxf", Qt::CaseInsensitive);
    if (!is_fixture || !studio_.show()) {
        studio_.open(file.toStdString());
        return;
    }
    if (const Result<void> done = actions_.run("add-fixture \"" + file + "\""); !done.ok())
        actions_.complain(done.error());
}

} // namespace ghost::ui
