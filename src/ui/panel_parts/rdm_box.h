#pragma once
// SPDX-License-Identifier: Apache-2.0
// RdmBox: the switch of RDM, what desks know of each fixture, and which ones identify themselves. Window
// thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>

namespace ghost::ui {

class RdmBox : public QWidget {
    Q_OBJECT
public:
    RdmBox(AppModel& app, Actions& actions, QWidget* parent);

protected:
    void showEvent(QShowEvent*) override;

private:
    void show_switch();
    void refresh();
    void fill_table();

    AppModel& app_;
    QComboBox* access_;
    QLabel* words_;
    QTableWidget* heads_;
};

// "12 of 24 fixtures were found, 300 messages; 'Spot 1' identifies itself"; "" while it is off.
QString words_of(const RdmNow& rdm, const scene::Show& show);

} // namespace ghost::ui
