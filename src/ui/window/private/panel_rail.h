#pragma once
// SPDX-License-Identifier: Apache-2.0
// PanelRail: where the window's panels are. While there is no show they are away. In a window with room they
// stand round the picture; in one of few logical pixels a rail of buttons stands at its left instead, and one
// panel at a time opens beside the picture, until its button or Esc gives the room back. Torn-off panels are
// left alone. Window thread.

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>

#include <vector>

namespace ghost::ui {

class PanelRail : public QToolBar {
    Q_OBJECT
public:
    explicit PanelRail(QMainWindow& window);
    // Panels first, then what opens and closes each by hand: its button.
    void add(QDockWidget& panel);
    void add_button(const QString& panel, QAction& toggle);
    // Of a panel that was just opened: as much room as it needs, the picture keeps more. Once for each.
    void make_room(QDockWidget& panel);
    void wait_for_show(bool waits);
    // What waited for a show that was opened in full screen comes back.
    void leave_full_screen();
    // After the window was laid out or became another one.
    void fit();
    // For good, as they belong into a layout that is kept; a window that closes.
    void put_back();

Q_SIGNALS:
    void came_back(); // with other shares than they had

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void set_narrow(bool narrow);
    void show_where_due();
    void take_away();
    void bring_back();
    bool is_beside(const QDockWidget& panel) const;
    QDockWidget* open_panel() const; // of a narrow window; null: none

    QMainWindow& window_;
    std::vector<QDockWidget*> panels_;
    std::vector<QDockWidget*> away_;     // come back with room and a show
    std::vector<QDockWidget*> in_front_; // of those behind one another
    std::vector<const QDockWidget*> had_room_;
    bool waits_ = false, is_narrow_ = false;
};

} // namespace ghost::ui
