#pragma once
// SPDX-License-Identifier: Apache-2.0
// WholePaint: a window whose size, state or resolution changed is painted whole once that is over. Qt paints
// what it takes for stale: on Wayland that leaves panels empty that come back from full screen, on X11 such
// as had another resolution. A filter on the application. Window thread.

#include <QObject>
#include <QTimer>

namespace ghost::ui {

class WholePaint : public QObject {
    Q_OBJECT
public:
    WholePaint();
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QTimer timer_; // the last of many changes
};

} // namespace ghost::ui
