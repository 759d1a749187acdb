// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/tear_off.h"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kStep_px = 60, kAsBefore_px = 24, kLook_ms = 30;

// As windows, in letters and lines: all columns of their lists, or rows with long sliders, are seen.
constexpr struct {
    const char* name;
    int letters, lines;
} kLeastSizes[] = {
    {"fixtures", 80, 36}, {"values", 80, 40},    {"programmer", 56, 44}, {"scene", 56, 36},
    {"network", 140, 32}, {"messages", 110, 20}, {"looks", 56, 30},      {"cues", 120, 28},
    {"export", 60, 30},   {"air", 60, 36},       {"plot", 80, 40},       {"browsers", 60, 30},
};

} // namespace

TearOff::TearOff(QDockWidget& panel) : QObject(&panel), panel_(panel) {
    panel_.installEventFilter(this);
    waits_.setSingleShot(true);
    waits_.setInterval(kLook_ms);
    connect(&waits_, &QTimer::timeout, this, &TearOff::step_aside);
    connect(&panel_, &QDockWidget::topLevelChanged, this, [this](bool floats) {
        waits_.stop();
        if (floats)
            waits_.start();
        else
            QMetaObject::invokeMethod(&panel_, &QWidget::raise, Qt::QueuedConnection); // after the layout
    });
}

QRect TearOff::beside(const QRect& docked, const QRect& display) {
    QRect place(docked.topLeft(),
                docked.size().boundedTo(display.size() - QSize(2 * kStep_px, 2 * kStep_px)));
    place.translate(docked.center().x() > display.center().x() ? -kStep_px : kStep_px, kStep_px);
    place.moveLeft(std::clamp(place.left(), display.left(),
                              std::max(display.left(), display.right() - place.width() - kStep_px / 2)));
    place.moveTop(std::clamp(place.top(), display.top() + kStep_px / 2,
                             std::max(display.top(), display.bottom() - place.height() - kStep_px / 2)));
    return place;
}

bool TearOff::eventFilter(QObject* object, QEvent* event) {
    if (object == &panel_ && !panel_.isFloating() && panel_.isVisible() &&
        (event->type() == QEvent::Move || event->type() == QEvent::Resize || event->type() == QEvent::Show))
        docked_ = panel_.geometry();
    return QObject::eventFilter(object, event);
}

void TearOff::step_aside() {
    if (!panel_.isFloating() || docked_.isEmpty()) return;
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        waits_.start();
        return;
    }
    const QRect docked(panel_.parentWidget()->mapToGlobal(docked_.topLeft()), docked_.size());
    const QRect display = panel_.screen()->availableGeometry();
    const QSize size = docked.size().expandedTo(least());
    if ((panel_.pos() - docked.topLeft()).manhattanLength() > kAsBefore_px) { // a hand put it there
        if (panel_.size() == docked.size()) // as Qt makes it, not as somebody had it before
            panel_.resize(size.boundedTo(QSize(std::max(display.right() - panel_.x(), docked.width()),
                                               std::max(display.bottom() - panel_.y(), docked.height()))));
        return;
    }
    panel_.setGeometry(beside(QRect(docked.topLeft(), size), display));
}

QSize TearOff::least() const {
    const QFontMetrics metrics = panel_.fontMetrics();
    for (const auto& [name, letters, lines] : kLeastSizes)
        if (panel_.objectName() == name)
            return {letters * metrics.averageCharWidth(), lines * metrics.lineSpacing()};
    return {};
}

} // namespace ghost::ui
