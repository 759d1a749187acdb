#pragma once
// SPDX-License-Identifier: Apache-2.0
// ViewBar: in the line of the menus, so that it takes nothing of the picture: cameras, exposure and tone
// curve. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QToolButton>
#include <QWidget>

namespace ghost::ui {

class ViewBar : public QWidget {
    Q_OBJECT
public:
    ViewBar(AppModel& app, Actions& actions, QMenuBar* menus);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    // Menus come first in a narrow window: what they have, too, goes from here.
    void leave_room();
    void name_cameras();
    void refresh();

    AppModel& app_;
    QMenuBar& menus_;
    QComboBox* camera_;
    QDoubleSpinBox* exposure_;
    QToolButton* strip_;
    QToolButton* automatic_;
    QComboBox* tone_;
    bool follows_ = false; // it is being set, not moved
};

} // namespace ghost::ui
