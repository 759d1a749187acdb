// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace ghost::ui {
namespace {

bool has_a_value(const QObject* object) {
    return qobject_cast<const QSlider*>(object) || qobject_cast<const QAbstractSpinBox*>(object) ||
           qobject_cast<const QComboBox*>(object);
}

} // namespace

bool WheelGuard::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Polish && has_a_value(object)) {
        // Else the wheel itself would bring the focus.
        auto* widget = static_cast<QWidget*>(object);
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    }
    if (event->type() != QEvent::Wheel || !has_a_value(object)) return false;
    if (static_cast<QWidget*>(object)->hasFocus()) return false;
    event->ignore(); // whoever is below may want it
    return true;
}

} // namespace ghost::ui
