#pragma once
// SPDX-License-Identifier: Apache-2.0
// ContextMenus: what the right button brings up: over the picture where it was not dragged, over the list of
// fixtures, and over the lists of looks, palettes and cues. All of it are actions of the one table. Window
// thread.

#include "ui/window/menus.h"

#include <QAbstractItemView>
#include <QPoint>
#include <QPointer>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class ContextMenus : public QObject {
    Q_OBJECT
public:
    ContextMenus(Menus& menus, AppModel& app, QWidget* view);
    // A table or list; fill gets the menu once the row under the mouse is the current one; where it leaves
    // it empty none comes up.
    void serve(QAbstractItemView* list, std::function<void(QMenu&)> fill);
    // One whose selection is that of the model.
    void serve_fixtures(QAbstractItemView* list);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    static void pop_up(QWidget* over, const QPoint& at, const std::function<void(QMenu&)>& fill);

    // Over the picture; at: in the view.
    void pop_up_at(const QPointF& at);

    Menus& menus_;
    AppModel& app_;
    QWidget* view_;
    QPoint pressed_;
};

// "select-similar": all fixtures of the type and mode of one that is selected.
void add_selection_actions(Actions& actions, AppModel& app);

} // namespace ghost::ui
