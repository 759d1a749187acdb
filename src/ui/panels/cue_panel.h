#pragma once
// SPDX-License-Identifier: Apache-2.0
// CuePanel: the cue list of the show: what is called next, go and back, and every cue's times, look, camera
// and notes, edited where they stand. Window thread.

#include "ui/actions/cue_list.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>

namespace ghost::ui {

class CuePanel : public QWidget {
    Q_OBJECT
public:
    CuePanel(AppModel& app, CueList& cues, Looks& looks, Actions& actions, QWidget* parent);

    QTableWidget* table() { return table_; }
    // What the right button brings up over the table.
    void fill_menu(QMenu& menu);

private:
    QPushButton* add_button(const QString& text, const QString& tip, std::function<QString()> line);
    void fill();
    void show_next();
    void choose(int row);   // none where there is none
    QString chosen() const; // number of the row that is current, from 1; empty: none

    AppModel& app_;
    CueList& cues_;
    Looks& looks_;
    Actions& actions_;
    QLabel* next_;
    QTableWidget* table_;
    QPushButton *go_, *back_, *call_, *up_, *down_, *remove_;
    QTimer countdown_;
    bool follows_ = false;
};

} // namespace ghost::ui
