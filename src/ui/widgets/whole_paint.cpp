// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/whole_paint.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace ghost::ui {
namespace {

constexpr int kOver_ms = 150;

bool changes_window(QEvent::Type type) {
    return type == QEvent::Resize || type == QEvent::WindowStateChange || type == QEvent::FontChange ||
           type == QEvent::ScreenChangeInternal;
}

} // namespace

WholePaint::WholePaint() {
    timer_.setSingleShot(true);
    timer_.setInterval(kOver_ms);
    connect(&timer_, &QTimer::timeout, this, [] {
        for (QWidget* const window : QApplication::topLevelWidgets()) {
            if (!window->isVisible()) continue;
            window->update();
            for (QWidget* const part : window->findChildren<QWidget*>()) part->update();
        }
    });
}

bool WholePaint::eventFilter(QObject* object, QEvent* event) {
    if (changes_window(event->type()) && object->isWidgetType() && static_cast<QWidget*>(object)->isWindow())
        timer_.start();
    return false;
}

} // namespace ghost::ui
