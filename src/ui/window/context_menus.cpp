// SPDX-License-Identifier: Apache-2.0
#include "ui/window/context_menus.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/picture/overlays.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMouseEvent>

#include <algorithm>
#include <utility>

namespace ghost::ui {

ContextMenus::ContextMenus(Menus& menus, AppModel& app, QWidget* view)
    : QObject(view), menus_(menus), app_(app), view_(view) {
    view->installEventFilter(this);
}

void ContextMenus::serve(QAbstractItemView* list, std::function<void(QMenu&)> fill) {
    list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list, &QWidget::customContextMenuRequested, this,
            [list, fill = std::move(fill)](const QPoint& at) {
                pop_up(list, list->viewport()->mapToGlobal(at), fill);
            });
}

void ContextMenus::serve_fixtures(QAbstractItemView* list) {
    serve(list, [this](QMenu& menu) { menus_.fill_for_fixtures(menu); });
}

// The right button also looks around: only where it stayed is a menu meant.
bool ContextMenus::eventFilter(QObject* object, QEvent* event) {
    if (object != view_ || !app_.show()) return false;
    if (event->type() == QEvent::ContextMenu) {
        const auto* const asked = static_cast<QContextMenuEvent*>(event);
        if (asked->reason() != QContextMenuEvent::Keyboard) return false;
        pop_up_at(view_->rect().center());
        return true;
    }
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto* const mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::RightButton) return false;
    const QPoint at = mouse->position().toPoint();
    if (event->type() == QEvent::MouseButtonPress) {
        pressed_ = at;
        return false;
    }
    if ((at - pressed_).manhattanLength() >= QApplication::startDragDistance()) return false;
    const Picture& picture = app_.picture();
    const auto lamp = fixture_at(picture_rect(view_->size(), picture.camera, picture.framed), picture.camera,
                                 app_.rig(), mouse->position());
    if (lamp && !app_.selection().contains(*lamp)) app_.select({*lamp});
    // After the view has ended its drag.
    QMetaObject::invokeMethod(
        this, [this, where = mouse->position()] { pop_up_at(where); }, Qt::QueuedConnection);
    return false;
}

void ContextMenus::pop_up_at(const QPointF& at) {
    const Picture& picture = app_.picture();
    const QRectF shown = picture_rect(view_->size(), picture.camera, picture.framed);
    const glm::vec2 place = shown.isEmpty() ? glm::vec2(0.5f)
                                            : glm::clamp(glm::vec2((at.x() - shown.left()) / shown.width(),
                                                                   (at.y() - shown.top()) / shown.height()),
                                                         0.0f, 1.0f);
    pop_up(view_, view_->mapToGlobal(at.toPoint()),
           [&](QMenu& menu) { menus_.fill_for_picture(menu, place); });
}

void ContextMenus::pop_up(QWidget* over, const QPoint& at, const std::function<void(QMenu&)>& fill) {
    auto* menu = new QMenu(over);
    menu->setObjectName("context");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fill(*menu);
    if (menu->isEmpty())
        delete menu;
    else
        menu->popup(at);
}

void add_selection_actions(Actions& actions, AppModel& app) {
    actions.add(
        {"select-similar",
         "Edit",
         translated("Action", "Select all of this type"),
         "Ctrl+Shift+A",
         "",
         [&app](const QStringList&) -> Result<void> {
             if (app.selection().empty()) return Error{"no fixture is selected", ""};
             const std::vector<scene::PatchedFixture>& fixtures = app.show()->fixtures;
             std::set<std::size_t> similar;
             for (std::size_t i = 0; i < fixtures.size(); ++i)
                 if (std::any_of(app.selection().begin(), app.selection().end(), [&](std::size_t one) {
                         return fixtures[one].gdtf == fixtures[i].gdtf &&
                                fixtures[one].type == fixtures[i].type;
                     }))
                     similar.insert(i);
             app.select(std::move(similar));
             return {};
         },
         {}});
}

} // namespace ghost::ui
