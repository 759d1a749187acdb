#pragma once
// SPDX-License-Identifier: Apache-2.0
// OnScreen: windows and torn-off panels whose display is unplugged or gets fewer pixels come to one that is
// there. Most window managers leave them where nobody sees them. Logical pixels. Window thread.

#include <QList>
#include <QObject>
#include <QRect>
#include <QTimer>

class QScreen;

namespace ghost::ui {

// Where a window may stay as it is: half of it and its title are on a display, and it is not larger than that
// one, but for a frame. Else it is moved, and made smaller where it does not fit, into the display that has
// most of it, or the first one.
QRect in_reach(const QRect& frame, const QList<QRect>& displays);

// Every window of the program that is shown. How many were moved.
int bring_into_reach(const QList<QRect>& displays);

class OnScreen : public QObject {
    Q_OBJECT
public:
    OnScreen();
    // Soon: also for who gives a window back the place that it had long ago.
    void look() { timer_.start(); }

Q_SIGNALS:
    void moved(const QString& what);

private:
    void watch(QScreen* screen);

    QTimer timer_; // the window manager goes first
};

} // namespace ghost::ui
