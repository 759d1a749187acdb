#pragma once
// SPDX-License-Identifier: Apache-2.0
// FanBox: spreads a value over the selected heads, and gives all of them that of the first or the last one.
// Folded until it is wanted. It begins with what the heads have; each change of a number is done at once.
// Window thread.

#include "ui/actions/fan_actions.h"
#include "ui/model/head_parameters.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

namespace ghost::ui {

class FanBox : public QWidget {
    Q_OBJECT
public:
    FanBox(AppModel& app, Actions& actions, QWidget* parent);
    // What else the selected heads have.
    void set_parameters(const std::vector<HeadParameter>& parameters);

private:
    void add_rows(QWidget& inside);
    void begin();
    void fan(bool between_them);
    QString word() const;
    double per_unit() const; // of the numbers: 0.01 for percent
    bool is_being_typed() const;

    AppModel& app_;
    Actions& actions_;
    QToolButton* unfold_;
    QComboBox *what_, *kind_, *order_;
    QLabel *a_name_, *b_name_;
    QDoubleSpinBox *a_, *b_;
    QPushButton *as_first_, *as_last_, *between_;
    bool follows_ = false; // it is being set, not changed
    bool fans_ = false;    // what changes is its own
};

} // namespace ghost::ui
