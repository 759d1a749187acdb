#pragma once
// SPDX-License-Identifier: Apache-2.0
// SecondDisplay: a second window with the picture alone, for the director or the house: full screen on one
// display, or a window of its own. Where its display is unplugged it goes, and comes back with it. Window
// thread.

#include "base/result.h"
#include "ui/model/app_model.h"
#include "ui/picture/surfaces.h"

#include <QKeyEvent>
#include <QPointer>
#include <QScreen>
#include <QString>
#include <QWidget>

#include <functional>
#include <memory>

namespace ghost::ui {

// Does what that key does in another window. False: nothing there has it.
bool press_shortcut(const QWidget& window, const QKeyEvent& key);

class PictureWindow : public QWidget {
    Q_OBJECT
public:
    // keys: of whoever works; it may have the focus although nobody wants it there.
    PictureWindow(AppModel& app, const std::function<bool(const QKeyEvent&)>& keys);

Q_SIGNALS:
    void closed(); // by a person

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void closeEvent(QCloseEvent*) override;

private:
    AppModel& app_;
    const std::function<bool(const QKeyEvent&)>& keys_;
    QTimer resize_timer_;
    double asked_ratio_ = 0; // as in View
    PictureSurface surface_{app_, *this};
};

class SecondDisplay : public QObject {
    Q_OBJECT
public:
    explicit SecondDisplay(AppModel& app);

    // What keys do that are pressed in it; false: nothing.
    std::function<bool(const QKeyEvent&)> on_key;
    // "2", a display's name, "window"; empty: the first display that the main window is not on.
    Result<void> open(const QString& which, const QScreen* main);
    void close();
    bool is_open() const { return window_ != nullptr; }
    // Where it is, in words; where it waits for its display, that too.
    QString words() const;
    // Waits for a display that was unplugged.
    bool waits() const { return window_ == nullptr && !wanted_.isEmpty(); }

Q_SIGNALS:
    void changed(const QString& what);

private:
    void show_on(QScreen* screen);
    void look_for_screen(QScreen* screen);
    void leave_screen(QScreen* screen);

    AppModel& app_;
    std::unique_ptr<PictureWindow> window_;
    QPointer<QScreen> screen_; // it covers; null: a window
    QString wanted_;           // name of the display; empty: none, or a window
};

} // namespace ghost::ui
