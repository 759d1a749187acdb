#pragma once
// SPDX-License-Identifier: Apache-2.0
// Welcome: what is seen before a show is open: three ways to one, and the shows of the last time with their
// pictures. It lies over the picture and goes with the first show. Window thread.

#include "ui/actions/actions.h"
#include "ui/window/recent_shows.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

namespace ghost::ui {

class Welcome : public QWidget {
    Q_OBJECT
public:
    // over: all of which it covers. has_demo: the demo came with the program.
    Welcome(Actions& actions, AppModel& app, RecentShows& recent, bool has_demo, QWidget* over);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QPushButton* add_button(const QString& action, const QString& text, const QString& words);
    void fill();
    void refresh();

    Actions& actions_;
    AppModel& app_;
    RecentShows& recent_;
    QLabel* says_;
    QWidget* ways_;
    QLabel* recent_title_;
    QListWidget* recent_list_;
};

} // namespace ghost::ui
