#pragma once
// SPDX-License-Identifier: Apache-2.0
// TearOff: a panel that is torn off stands a step beside the place that it had, inside of the display, so
// that one sees that it is a window now, as large as what is in it needs, for a column is narrow; where a
// hand drags it, it stays where it was put. Put back it is the front one of its tabs. Lives as long as the
// panel. Window thread.

#include <QDockWidget>
#include <QTimer>

namespace ghost::ui {

class TearOff : public QObject {
    Q_OBJECT
public:
    explicit TearOff(QDockWidget& panel);

    // A step towards the middle of the display, whole in it where it fits. Pure.
    static QRect beside(const QRect& docked, const QRect& display);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void step_aside();
    QSize least() const; // as a window

    QDockWidget& panel_;
    QRect docked_; // where it was last, in its window
    QTimer waits_; // for the mouse to let go
};

} // namespace ghost::ui
