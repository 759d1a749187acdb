#pragma once
// SPDX-License-Identifier: Apache-2.0
// Window: the picture in the middle, panels around it, menus made from the table of actions. It remembers its
// layout and its place. Window thread.

#include "ui/actions/actions.h"
#include "ui/actions/cue_list.h"
#include "ui/actions/exporter.h"
#include "ui/actions/palette_list.h"
#include "ui/model/app_model.h"
#include "ui/model/looks.h"
#include "ui/model/plot_report.h"
#include "ui/model/show_document.h"
#include "ui/picture/view.h"
#include "ui/widgets/loop_watch.h"
#include "ui/widgets/on_screen.h"
#include "ui/widgets/toast.h"
#include "ui/widgets/window_place.h"
#include "ui/window/context_menus.h"
#include "ui/window/menus.h"
#include "ui/window/open_window.h"
#include "ui/window/rdm_edits.h"
#include "ui/window/recent_shows.h"
#include "ui/window/second_display.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QToolBar>

#include <functional>

namespace ghost::ui {

class CuePanel;
class FixturePanel;
class LookPanel;
class NoticeBar;
class PanelRail;
class ProgrammerPanel;

class Window : public QMainWindow {
    Q_OBJECT
public:
    Window(Link& link, const WindowOptions& options);
    ~Window() override;

    AppModel& app() { return app_; }
    Actions& actions() { return actions_; }

protected:
    void closeEvent(QCloseEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    // floor_m: where it was dropped on the picture.
    void take_file(const QString& file, const std::optional<glm::vec3>& floor_m);
    QDockWidget* add_panel(const QString& name, const QString& title, QWidget* panel,
                           Qt::DockWidgetArea area);
    void add_panels();
    QDockWidget* add_browsers(web::Browsers& browsers);
    void add_strip();
    void add_window_actions();
    void add_view_switches();
    void add_languages();
    bool asks_to_close();
    void lay_out();
    void share_columns();
    void begin_where_show_says();
    void say_done(const Action& action, bool made_step);
    void say_hand_taken();
    // That the last step was done, with its way back as long as it is the last one.
    void say_step(const QString& what, std::function<void()> name = {});
    // Over the picture, too, where it was an edit; helps: an action that lets it be done.
    void say_refused(const Error& error, bool is_of_edit, const QString& helps = {});
    void forget_refused();
    void show_title();
    void name_steps();
    void name_cameras();
    void show_plot_page();
    void show_status();
    void show_jobs();
    // In the status line, whole as its tool tip.
    void say(const QString& what, int for_ms = 0);
    void set_full_screen(bool full);
    void give_sizes_back(); // to panels, after full screen
    void show_shortcuts();
    bool has_work_light() const;
    Result<void> save_picture(const QString& file);
    Result<void> save_state(const QStringList& arguments);

    WindowOptions options_;
    std::size_t steps_ = 0; // done or undone so far; the list counts one more when it goes
    AppModel app_;
    ShowDocument document_;
    Looks looks_;
    PlotReport plot_report_;
    CueList cues_;
    PaletteList palettes_;
    Exporter exporter_;
    RdmEdits* const rdm_ = new RdmEdits(app_, document_, this);
    SecondDisplay second_;
    OnScreen reach_;
    WindowPlace place_{*this};
    Actions actions_;
    LoopWatch* const loop_ = new LoopWatch(this);
    View* view_;
    RecentShows recent_;
    Menus menus_;
    Toast* toast_;
    bool plot_is_new_ = false; // its page was not looked at yet
    QString language_;         // for the next start; empty: the desktop's
    int step_said_ = -1;       // place in the undo list of what the toast offers to undo; -1: none
    QString refused_;          // the last that was, in the status line
    bool had_hand_ = false;    // something was set by hand when it was last looked at
    FixturePanel* fixtures_ = nullptr;
    ProgrammerPanel* programmer_ = nullptr;
    LookPanel* look_list_ = nullptr;
    CuePanel* cue_table_ = nullptr;
    std::vector<QDockWidget*> docks_;
    PanelRail* rail_ = nullptr;
    bool has_first_layout_ = false;     // not that of an earlier time
    std::vector<bool> docks_shown_;     // before full screen
    QList<QDockWidget*> in_front_;      // likewise, of those behind one another
    std::vector<QSize> sizes_in_front_; // likewise, of them
    QSize size_before_;                 // likewise; empty: they have theirs
    NoticeBar* notice_ = nullptr;
    QToolBar* transport_ = nullptr;
    QToolBar* strip_ = nullptr;                         // of cameras
    bool transport_shown_ = true, strip_shown_ = false; // likewise
    bool closes_anyway_ = false;                        // with changes that can be written nowhere
    QLabel* status_input_;
    QLabel* status_supply_;
    QLabel* status_jobs_;
    QLabel* status_device_;
};

} // namespace ghost::ui
