#pragma once
// SPDX-License-Identifier: Apache-2.0
// LookPanel: the looks of the show in a list, to store, recall, rename and remove, with the seconds of their
// crossfade; solo and what-if for the selected fixtures. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/looks.h"
#include "ui/widgets/colour_row.h"
#include "ui/widgets/value_row.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QWidget>

namespace ghost::ui {

class LookPanel : public QWidget {
    Q_OBJECT
public:
    // Buttons run actions, so that what goes wrong is said where it is for keys.
    LookPanel(AppModel& app, Looks& looks, Actions& actions, QWidget* parent);

    QListWidget* list() { return list_; }
    // What the right button brings up over the list.
    void fill_menu(QMenu& menu);

private:
    QPushButton* add_button(const QString& text, const QString& tip, std::function<QString()> line);
    void add_what_if(QLayout* layout);
    void store_new(const QString& action);
    void run(const QString& line);
    void fill();
    void list_names();
    void refresh();
    QString chosen() const;   // name of the row that is current; empty: none
    QString new_name() const; // that nobody has

    AppModel& app_;
    Looks& looks_;
    Actions& actions_;
    QListWidget* list_;
    QDoubleSpinBox* fade_;
    QPushButton *store_, *update_, *recall_, *remove_, *solo_;
    QLabel* what_if_;
    ColourRow* gel_;
    ValueRow *lamp_, *lamp_k_;
    bool follows_ = false;
};

} // namespace ghost::ui
