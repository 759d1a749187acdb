#pragma once
// SPDX-License-Identifier: Apache-2.0
// View: the picture with its overlays, and the mouse and keys that move the camera in it. It scales the
// newest picture to its size at once; the engine draws the new size when the window rests. Window thread.

#include "ui/figures.h"
#include "ui/overlays.h"
#include "ui/studio.h"

#include <QElapsedTimer>
#include <QImage>
#include <QSet>
#include <QWidget>

namespace ghost::ui {

class View : public QWidget {
    Q_OBJECT
public:
    View(Studio& studio, QWidget* parent);

    OverlayChoice overlays;
    QString hint; // shown where no show is open
    const Figures& figures() const { return figures_; }
    void reset_figures() { figures_.reset(); }
    double paint_ms() const { return paint_ms_; }
    // Measures there from now on, until the mouse moves.
    void probe_at(const QPointF& place);
    void end_probe();

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    enum class Drag { none, undecided, orbit, turn, pan, box };

    void take_picture();
    void ask_for_size();
    void fly();
    // Of the picture that is shown; before the first one, that which is asked for.
    scene::Camera camera_of_picture() const;
    QRectF rect_of_picture() const;
    void paint_box(QPainter& painter) const;

    Studio& studio_;
    QTimer resize_timer_;
    double asked_ratio_ = 0; // pixels of the display to one of the window, when the size was asked for
    Drag drag_ = Drag::none;
    QPointF drag_from_, drag_at_;
    QSet<int> held_; // keys that fly
    QTimer fly_timer_;
    QElapsedTimer fly_clock_;

    bool picture_waits_ = false;          // a new one, to be painted
    std::chrono::nanoseconds arrival_{0}; // of the first packet that no painted picture shows; 0: none waits
    double paint_ms_ = 0;
    Figures figures_;
    QTimer rest_timer_; // until the figures may say that it rests
};

} // namespace ghost::ui
