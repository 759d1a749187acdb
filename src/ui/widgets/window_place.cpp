// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/window_place.h"

#include "ui/widgets/on_screen.h"

#include <QGuiApplication>
#include <QScreen>

#include <cstdlib>

namespace ghost::ui {
namespace {

constexpr const char* kPlace = "place";
constexpr const char* kMaximized = "maximized";
constexpr int kNear_px = 40; // a frame of which the desktop hides a part

bool are_near(const QRect& a, const QRect& b) {
    return (a.topLeft() - b.topLeft()).manhattanLength() <= kNear_px &&
           std::abs(a.width() - b.width()) <= kNear_px && std::abs(a.height() - b.height()) <= kNear_px;
}

} // namespace

// Without a window manager nobody tells a window that it is not maximized any more.
bool WindowPlace::is_maximized() const {
    return window_.isMaximized() && are_near(window_.frameGeometry(), window_.screen()->availableGeometry());
}

bool WindowPlace::put_back(const QSettings& settings) {
    if (!settings.contains(kMaximized)) return false;
    window_.setWindowState(Qt::WindowNoState);
    bool is_cut = false;
    if (const QRect kept = settings.value(kPlace).toRect(); kept.isValid()) {
        QList<QRect> displays;
        for (const QScreen* const screen : QGuiApplication::screens())
            displays << screen->availableGeometry();
        const QRect place = in_reach(kept, displays);
        window_.setGeometry(place);
        is_cut = place.size() != kept.size();
    }
    // One that was larger than the display takes all of it: how much its frame needs nobody knows yet.
    if (is_cut || settings.value(kMaximized).toBool()) window_.setWindowState(Qt::WindowMaximized);
    return true;
}

void WindowPlace::keep(QSettings& settings) const {
    const bool maximized = is_maximized();
    QRect place = maximized ? window_.normalGeometry() : window_.geometry();
    const QRect display = window_.screen()->availableGeometry();
    if (maximized && !display.contains(place.center()))
        place.moveCenter(display.center()); // it covers that one
    settings.setValue(kMaximized, maximized);
    settings.setValue(kPlace, place);
}

} // namespace ghost::ui
