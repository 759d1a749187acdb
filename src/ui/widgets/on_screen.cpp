// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/on_screen.h"

#include "ui/language/language.h"

#include <QApplication>
#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kSettle_ms = 400;
constexpr int kTitle_px = 24;

qint64 area(const QRect& rect) {
    return rect.isEmpty() ? 0 : qint64{rect.width()} * rect.height();
}

bool is_window(const QWidget& widget) {
    const Qt::WindowType type = widget.windowType();
    return widget.isVisible() && (type == Qt::Window || type == Qt::Dialog || type == Qt::Tool);
}

void place(QWidget& widget, const QRect& frame) {
    const QSize border = widget.frameGeometry().size() - widget.size();
    const Qt::WindowStates states = widget.windowState();
    const bool covers = states & (Qt::WindowFullScreen | Qt::WindowMaximized);
    if (covers) widget.showNormal();
    widget.resize(frame.size() - border);
    widget.move(frame.topLeft());
    if (covers) widget.setWindowState(states);
}

} // namespace

QRect in_reach(const QRect& frame, const QList<QRect>& displays) {
    if (displays.isEmpty() || frame.isEmpty()) return frame;
    const QRect title(frame.left(), frame.top(), frame.width(), std::min(kTitle_px, frame.height()));
    qint64 seen = 0, seen_title = 0, most = 0;
    QRect display = displays.front();
    for (const QRect& one : displays) {
        const qint64 here = area(frame & one);
        seen += here;
        seen_title += area(title & one);
        if (here <= most) continue;
        most = here;
        display = one;
    }
    const bool fits = seen == area(frame) || (frame.width() <= display.width() + kTitle_px &&
                                              frame.height() <= display.height() + kTitle_px);
    if (fits && 2 * seen >= area(frame) && 2 * seen_title >= area(title)) return frame;
    QRect moved(frame.topLeft(), frame.size().boundedTo(display.size()));
    moved.moveLeft(std::clamp(moved.left(), display.left(), display.right() + 1 - moved.width()));
    moved.moveTop(std::clamp(moved.top(), display.top(), display.bottom() + 1 - moved.height()));
    return moved;
}

int bring_into_reach(const QList<QRect>& displays) {
    // There nobody but the compositor knows where a window is, or moves it.
    if (QGuiApplication::platformName().startsWith("wayland")) return 0;
    int count = 0;
    for (QWidget* const widget : QApplication::topLevelWidgets()) {
        if (!is_window(*widget)) continue;
        const QRect frame = widget->frameGeometry();
        const QRect wanted = in_reach(frame, displays);
        if (wanted == frame) continue;
        place(*widget, wanted);
        ++count;
    }
    return count;
}

OnScreen::OnScreen() {
    timer_.setSingleShot(true);
    timer_.setInterval(kSettle_ms);
    connect(&timer_, &QTimer::timeout, this, [this] {
        QList<QRect> displays;
        for (const QScreen* screen : QGuiApplication::screens()) displays << screen->availableGeometry();
        if (bring_into_reach(displays) > 0)
            Q_EMIT moved(translated("Notice", "The displays changed: what was out of sight is here now"));
    });
    connect(qGuiApp, &QGuiApplication::screenRemoved, this, &OnScreen::look);
    connect(qGuiApp, &QGuiApplication::screenAdded, this, &OnScreen::watch);
    for (QScreen* screen : QGuiApplication::screens()) watch(screen);
}

void OnScreen::watch(QScreen* screen) {
    connect(screen, &QScreen::availableGeometryChanged, this, &OnScreen::look);
}

} // namespace ghost::ui
