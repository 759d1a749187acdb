// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/popup_keys.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QRadioButton>

#include <utility>

namespace ghost::ui {

namespace {

bool opens_its_list(const QObject* object, const QKeyEvent& key) {
    const auto* const combo = qobject_cast<const QComboBox*>(object);
    if (!combo) return false;
    const bool is_arrow = key.key() == Qt::Key_Down || key.key() == Qt::Key_Up;
    return (key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier && !combo->isEditable()) ||
           (is_arrow && (key.modifiers() & ~Qt::KeypadModifier) == Qt::AltModifier);
}

bool is_return(const QKeyEvent& key) {
    return (key.key() == Qt::Key_Return && key.modifiers() == Qt::NoModifier) ||
           (key.key() == Qt::Key_Enter && (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier);
}

bool is_by_keys(Qt::FocusReason reason) {
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
           reason == Qt::ShortcutFocusReason;
}

} // namespace

// One that the mouse pressed has the focus as well, and leaves Space to the window. Qt tells the style, too,
// who gets the focus.
void PopupKeys::follow_focus(QObject* object, const QEvent& event) {
    auto* const button = qobject_cast<QAbstractButton*>(object);
    if (event.type() == QEvent::FocusIn && object->isWidgetType())
        reached_ = is_by_keys(static_cast<const QFocusEvent&>(event).reason()) ? button : nullptr;
    if (button && button == reached_ && event.type() == QEvent::MouseButtonPress) reached_ = nullptr;
}

bool PopupKeys::presses(const QObject* object, const QKeyEvent& key) const {
    if (!reached_ || object != reached_) return false;
    const bool is_space = key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier;
    const bool is_box = qobject_cast<const QCheckBox*>(object) || qobject_cast<const QRadioButton*>(object);
    return is_space || (is_return(key) && !is_box);
}

// Qt sends ShortcutOverride, then either Shortcut or KeyPress.
bool PopupKeys::eventFilter(QObject* object, QEvent* event) {
    follow_focus(object, *event);
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<const QKeyEvent*>(event);
        if (opens_its_list(object, key) || presses(object, key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && presses(object, *static_cast<const QKeyEvent*>(event)) &&
        is_return(*static_cast<const QKeyEvent*>(event))) { // Space is Qt's
        reached_->click();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget()) popup_had_it_ = true;
    if (event->type() == QEvent::KeyPress) popup_had_it_ = false;
    return event->type() == QEvent::Shortcut && std::exchange(popup_had_it_, false);
}

} // namespace ghost::ui
