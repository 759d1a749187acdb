#pragma once
// SPDX-License-Identifier: Apache-2.0
// WindowPlace: where a window stood when it was closed, and back there. Kept is the place inside of its
// frame, for of that Qt knows nothing before the window is shown. (Qt's own restoreGeometry keeps 20 pixels
// free for a title above every window, also where nobody draws one.) Logical pixels of the desktop. Window
// thread.

#include <QSettings>
#include <QWidget>

namespace ghost::ui {

class WindowPlace {
public:
    explicit WindowPlace(QWidget& window) : window_(window) {}

    // Before it is shown; as far as it is in reach of the displays there are now. False: none is kept.
    bool put_back(const QSettings& settings);
    void keep(QSettings& settings) const;

private:
    bool is_maximized() const;

    QWidget& window_;
};

} // namespace ghost::ui
