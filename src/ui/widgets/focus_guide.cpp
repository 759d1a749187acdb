// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/focus_guide.h"

#include "ui/widgets/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTabBar>
#include <QTextEdit>

namespace ghost::ui {
namespace {

class Ring : public QFocusFrame {
public:
    using QFocusFrame::QFocusFrame;

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(accent(), 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
};

bool gets_ring(const QWidget* widget) {
    return qobject_cast<const QSlider*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractButton*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QTabBar*>(widget);
}

// Letters mean something else there.
bool types(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const QTextEdit*>(widget);
}

bool flies(int key) {
    return key == Qt::Key_W || key == Qt::Key_A || key == Qt::Key_S || key == Qt::Key_D || key == Qt::Key_Q ||
           key == Qt::Key_E;
}

} // namespace

FocusGuide::FocusGuide(QWidget* view) : QObject(view), view_(view) {
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { show_ring(now); });
    qApp->installEventFilter(this);
}

FocusGuide::~FocusGuide() {
    delete ring_;
}

void FocusGuide::show_ring(QWidget* control) {
    // In dialogs and torn-off panels, too; a list that drops down says by itself where it is.
    const bool is_ours = control && control->window()->windowType() != Qt::Popup && gets_ring(control);
    if (!ring_ && is_ours) ring_ = new Ring(control->window());
    if (!ring_) return;
    ring_->setWidget(is_ours ? control : nullptr);
}

bool FocusGuide::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) return false;
    const auto* const key = static_cast<QKeyEvent*>(event);
    const auto* const widget = qobject_cast<QWidget*>(object);
    if (!flies(key->key()) || (key->modifiers() & ~Qt::ShiftModifier) != 0 || !widget || widget == view_ ||
        widget != QApplication::focusWidget() || widget->window() != view_->window() || types(widget))
        return false;
    QCoreApplication::sendEvent(view_, event);
    return true;
}

} // namespace ghost::ui
