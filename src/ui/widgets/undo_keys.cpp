// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/undo_keys.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>

namespace ghost::ui {

namespace {

// The text of a spin box or an editable list is in a field inside of it, which gets their keys.
QLineEdit* field_of(QObject* object) {
    if (auto* const list = qobject_cast<QComboBox*>(object)) return list->lineEdit();
    if (auto* const number = qobject_cast<QAbstractSpinBox*>(object))
        return number->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    return qobject_cast<QLineEdit*>(object);
}

// The number, where it stands alone in a panel.
QWidget* alone(QObject* object) {
    auto* const number = qobject_cast<QAbstractSpinBox*>(object);
    if (!number || qobject_cast<QDialog*>(number->window())) return nullptr;
    const QWidget* const around = number->parentWidget() ? number->parentWidget()->parentWidget() : nullptr;
    return qobject_cast<const QAbstractItemView*>(around) ? nullptr : number;
}

// No number has them, and its field would take them all the same.
bool is_letter(const QKeyEvent& key) {
    const bool is_plain = (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    return is_plain && ((key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z) || key.key() == Qt::Key_Space);
}

} // namespace

bool UndoKeys::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    const auto& key = *static_cast<const QKeyEvent*>(event);
    if (event->type() == QEvent::KeyPress) {
        // Qt counts what was entered as typed until another text is set.
        if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)
            if (QLineEdit* const field = field_of(object)) {
                field->setModified(false);
                if (QWidget* const number = alone(field->parentWidget())) Q_EMIT entered(number);
            }
        return false;
    }
    QLineEdit* const field = field_of(object);
    if (!field || field->isModified()) return false;
    const bool is_of_window = key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo) ||
                              (is_letter(key) && alone(field->parentWidget()) != nullptr);
    return is_of_window; // nobody overrides the shortcut
}

} // namespace ghost::ui
