#pragma once
// SPDX-License-Identifier: Apache-2.0
// ContextMenus: what the right button brings up: over the picture where it was not dragged, over the list of
// fixtures and of looks. All of it are actions of the one table. Window thread.

#include "ui/window/menus.h"

#include <QPoint>
#include <QPointer>
#include <QWidget>

namespace ghost::ui {

class ContextMenus : public QObject {
    Q_OBJECT
public:
    ContextMenus(Menus& menus, AppModel& app, QWidget* view);
    // A table or list whose selection is that of the model.
    void serve(QWidget* list);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void pop_up(QWidget* over, const QPoint& at);

    Menus& menus_;
    AppModel& app_;
    QWidget* view_;
    QPoint pressed_;
};

// "select-similar": all fixtures of the type and mode of one that is selected.
void add_selection_actions(Actions& actions, AppModel& app);

} // namespace ghost::ui
