#pragma once
// SPDX-License-Identifier: Apache-2.0
// WheelGuard: the wheel turns a slider, a number or a list only where it has the focus; elsewhere it scrolls
// the panel below. A parameter that was passed by the mouse must not be taken by hand. Window thread.

#include <QObject>

namespace ghost::ui {

class WheelGuard : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override; // of the application
};

} // namespace ghost::ui
