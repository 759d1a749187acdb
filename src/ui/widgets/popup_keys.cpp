// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/popup_keys.h"

#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

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

} // namespace

// Qt sends ShortcutOverride, then either Shortcut or KeyPress.
bool PopupKeys::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        opens_its_list(object, *static_cast<const QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget()) popup_had_it_ = true;
    if (event->type() == QEvent::KeyPress) popup_had_it_ = false;
    return event->type() == QEvent::Shortcut && std::exchange(popup_had_it_, false);
}

} // namespace ghost::ui
