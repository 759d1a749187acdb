// SPDX-License-Identifier: Apache-2.0
#include "ui/window/second_display.h"

#include "ui/language/language.h"
#include "ui/picture/overlays.h"

#include <QAction>
#include <QCloseEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QWindow>

#include <cmath>

namespace ghost::ui {
namespace {

constexpr QSize kWindow(960, 540);

QString names_of_screens() {
    QStringList names;
    for (const QScreen* screen : QGuiApplication::screens())
        names << QString("%1 (%2, %3x%4)")
                     .arg(names.size() + 1)
                     .arg(screen->name())
                     .arg(screen->size().width())
                     .arg(screen->size().height());
    return names.join(", ");
}

} // namespace

bool press_shortcut(const QWidget& window, const QKeyEvent& key) {
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    QList<QKeySequence> keys{QKeySequence(QKeyCombination(held, Qt::Key(key.key())))};
    // "?" is called so whatever has to be held for it.
    if (!key.text().isEmpty() && key.text()[0].isPrint() && !key.text()[0].isLetter())
        keys.append(QKeySequence(QKeyCombination(held & ~Qt::ShiftModifier, Qt::Key(key.key()))));
    for (const QKeySequence& one : keys)
        for (QAction* const action : window.actions())
            if (action->isEnabled() && action->shortcuts().contains(one)) {
                // Not at once: it may close the window that has the key.
                QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
                return true;
            }
    return false;
}

PictureWindow::PictureWindow(AppModel& app, const std::function<bool(const QKeyEvent&)>& keys)
    : app_(app), keys_(keys) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setWindowTitle(translated("Notice", "Ghostlight, the picture"));
    setMinimumSize(16, 16);
    resize_timer_.setSingleShot(true);
    resize_timer_.setInterval(kResizeRest_ms);
    connect(&resize_timer_, &QTimer::timeout, this, [this] {
        const double ratio = asked_ratio_ = devicePixelRatioF();
        app_.set_second_size({static_cast<int>(std::lround(width() * ratio)),
                              static_cast<int>(std::lround(height() * ratio))});
    });
    connect(&app_, &AppModel::picture_came, this, qOverload<>(&QWidget::update));
}

void PictureWindow::paintEvent(QPaintEvent*) {
    if (asked_ratio_ > 0 && asked_ratio_ != devicePixelRatioF() && !resize_timer_.isActive())
        resize_timer_.start();
    QPainter painter(this);
    const PictureSurface::Painting what = surface_.painting();
    const Picture& picture = app_.picture();
    const bool is_empty = !app_.show() || !picture.image;
    if (what != PictureSurface::Painting::covers || is_empty) painter.fillRect(rect(), Qt::black);
    if (what == PictureSurface::Painting::nothing || is_empty) return;
    if (what == PictureSurface::Painting::all)
        paint_picture(painter, picture_rect(size(), picture.camera, picture.framed), *picture.image);
    if (picture.false_colour.measure != Measure::none) paint_legend(painter, size(), picture.false_colour);
}

void PictureWindow::resizeEvent(QResizeEvent*) {
    resize_timer_.start();
}

void PictureWindow::keyPressEvent(QKeyEvent* event) {
    // Esc takes one thing after the other, as in the main window.
    const bool lets_go = app_.marked() || !app_.selection().empty();
    if (event->key() == Qt::Key_Escape && !lets_go)
        close();
    else if (!keys_ || !keys_(*event))
        QWidget::keyPressEvent(event);
}

void PictureWindow::closeEvent(QCloseEvent* event) {
    event->accept();
    Q_EMIT closed();
}

SecondDisplay::SecondDisplay(AppModel& app) : app_(app) {
    auto* application = qGuiApp;
    connect(application, &QGuiApplication::screenAdded, this, &SecondDisplay::look_for_screen);
    connect(application, &QGuiApplication::screenRemoved, this, &SecondDisplay::leave_screen);
}

Result<void> SecondDisplay::open(const QString& which, const QScreen* main) {
    const QList<QScreen*> screens = QGuiApplication::screens();
    if (which == "window") {
        wanted_.clear();
        show_on(nullptr);
        return {};
    }
    bool is_number = false;
    const int number = which.toInt(&is_number);
    for (int i = 0; i < screens.size(); ++i) {
        const bool meant = which.isEmpty() ? screens[i] != main
                           : is_number     ? number == i + 1
                                           : screens[i]->name().compare(which, Qt::CaseInsensitive) == 0;
        if (!meant) continue;
        wanted_ = screens[i]->name();
        show_on(screens[i]);
        return {};
    }
    if (which.isEmpty())
        return Error{"there is one display only; View has 'The picture in a second window' (in a script: "
                     "second-display window)",
                     ""};
    return Error{"there is no display '" + which.toStdString() + "'; there are " +
                     names_of_screens().toStdString(),
                 ""};
}

void SecondDisplay::close() {
    wanted_.clear();
    screen_.clear();
    window_.reset();
    app_.set_second_size({});
    Q_EMIT changed("");
}

void SecondDisplay::show_on(QScreen* screen) {
    if (!window_) {
        window_ = std::make_unique<PictureWindow>(app_, on_key);
        // Not at once: it is in the middle of its own event.
        connect(window_.get(), &PictureWindow::closed, this, &SecondDisplay::close, Qt::QueuedConnection);
    }
    screen_ = screen;
    // Keys stay with who works; on the same display it would come behind that window.
    const QWindow* const front = QGuiApplication::focusWindow();
    window_->setAttribute(Qt::WA_ShowWithoutActivating, screen && front && front->screen() != screen);
    if (screen) {
        window_->setCursor(Qt::BlankCursor);
        window_->setWindowFlag(Qt::FramelessWindowHint);
        window_->setGeometry(screen->geometry());
        window_->showFullScreen();
    } else {
        window_->unsetCursor();
        window_->setWindowFlag(Qt::FramelessWindowHint, false);
        window_->setWindowState(window_->windowState() & ~Qt::WindowFullScreen);
        window_->resize(kWindow);
        window_->show();
    }
    Q_EMIT changed(translated("Notice", "The picture is on %1").arg(words()));
}

QString SecondDisplay::words() const {
    if (screen_) return screen_->name();
    if (window_) return translated("Notice", "a window of its own");
    return wanted_.isEmpty() ? QString() : translated("Notice", "%1, which is unplugged").arg(wanted_);
}

void SecondDisplay::look_for_screen(QScreen* screen) {
    if (waits() && screen->name() == wanted_) show_on(screen);
}

void SecondDisplay::leave_screen(QScreen* screen) {
    if (!window_ || screen_ != screen) return;
    screen_.clear();
    // A window that covers what is left would hide the desk of who works there.
    window_.reset();
    app_.set_second_size({});
    Q_EMIT changed(
        translated("Notice", "The display %1 is gone; the picture comes back with it").arg(wanted_));
}

} // namespace ghost::ui
