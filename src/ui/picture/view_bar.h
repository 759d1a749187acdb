#pragma once
// SPDX-License-Identifier: Apache-2.0
// ViewBar: in the line of the menus, so that it takes nothing of the picture: cameras, exposure and tone
// curve. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QToolButton>
#include <QWidget>

namespace ghost::ui {

class ViewBar : public QWidget {
    Q_OBJECT
public:
    ViewBar(AppModel& app, Actions& actions, QWidget* parent);

private:
    void name_cameras();
    void refresh();

    AppModel& app_;
    QComboBox* camera_;
    QDoubleSpinBox* exposure_;
    QToolButton* automatic_;
    QComboBox* tone_;
    bool follows_ = false; // it is being set, not moved
};

} // namespace ghost::ui
