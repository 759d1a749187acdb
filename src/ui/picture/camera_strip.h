#pragma once
// SPDX-License-Identifier: Apache-2.0
// CameraStrip: the cameras of the show as small pictures with their names; a click goes there, F2 gives
// another name. The engine makes the pictures while nothing moves, and only while the strip is seen. Window
// thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QListWidget>
#include <QMenu>

namespace ghost::ui {

class CameraStrip : public QListWidget {
    Q_OBJECT
public:
    // Clicks run actions.
    CameraStrip(AppModel& app, Actions& actions, QWidget* parent);
    // Of the current one.
    void fill_menu(QMenu& menu);

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void list_cameras();
    void show_pictures();
    void mark_current();

    AppModel& app_;
    Actions& actions_;
    bool follows_ = false;
};

} // namespace ghost::ui
