#pragma once
// SPDX-License-Identifier: Apache-2.0
// View: the picture with its overlays, and the mouse and keys that move the camera in it. It scales the
// newest picture to its size at once; the engine draws the new size when the window rests. Window thread.

#include "ui/model/app_model.h"
#include "ui/model/figures.h"
#include "ui/model/lamp_drag.h"
#include "ui/picture/mover_marks.h"
#include "ui/picture/overlays.h"
#include "ui/picture/surfaces.h"
#include "ui/picture/wipe.h"

#include <QElapsedTimer>
#include <QImage>
#include <QSet>
#include <QWidget>

#include <set>
#include <string>
#include <vector>

namespace ghost::ui {

class View : public QWidget {
    Q_OBJECT
public:
    View(AppModel& app, QWidget* parent);

    OverlayChoice overlays;
    // The selected fixtures were dragged so far, in metres of the world; none: they cannot be.
    std::function<void(const glm::vec3& by_m)> on_move;
    // The chosen object of the stage was dragged so far over the floor.
    std::function<void(std::size_t object, const glm::vec3& by_m)> on_move_object;
    // Shift and a click: the selected heads shall point at what the picture shows there, (0, 0) its top left
    // corner.
    std::function<void(const glm::vec2& place)> on_aim;
    // What is seen now stays left of a line that the mouse drags; Error: there is no picture.
    Result<void> begin_wipe(double share);
    void end_wipe();
    const Wipe& wipe() const { return wipe_; }
    const Figures& figures() const { return figures_; }
    void reset_figures() { figures_.reset(); }
    double paint_ms() const { return paint_ms_; }
    // Who shows the picture.
    const ShowerNow& shower() const { return surface_.shower(); }
    // What AppModel has of it may be one before.
    bool is_picture_on_device() const { return surface_.shower().is_device && !app_.is_settled(); }
    // What the chips say, from left to right.
    QStringList chip_words() const;
    // Of the stage, under the mouse when it is there.
    glm::vec3 floor_at(const QPointF& place) const;
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
    void leaveEvent(QEvent*) override;

private:
    enum class Drag { none, undecided, orbit, turn, pan, box, lamp, object, mover, wipe };

    void take_picture();
    QStringList figure_lines() const;
    void ask_for_size();
    void fly();
    // Of the picture that is shown; before the first one, that which is asked for.
    scene::Camera camera_of_picture() const;
    QRectF rect_of_picture() const;
    void paint_box(QPainter& painter) const;
    glm::vec3 way_of_mouse(const QPointF& place) const; // unit vector, from the eye
    std::optional<std::size_t> lamp_at(const QPointF& place) const;
    Drag drag_of_left(Qt::KeyboardModifiers keys);
    void drag_lamp(bool upright);
    glm::vec3 dragged_by_m() const; // where the model has it
    // What a drag of the left button moves: lamps, an object, an axis of a mover.
    std::vector<std::string> names_of_dragged() const;
    // Of the chosen object; nothing: none is, or it is not in sight.
    std::optional<QPointF> handle_of_object() const;
    bool is_on_handle(const QPointF& place) const;
    void drag_object(bool freely);
    // Of the movers in sight; nothing: they have no marks.
    std::optional<MoverHandle> mover_handle_at(const QPointF& place) const;
    void drag_mover();
    void hover_at(const QPointF& place);
    void set_hovered(std::optional<std::size_t> fixture);
    QString why_hovered() const;
    void click(const QPointF& place, Qt::KeyboardModifiers keys);
    void select_one(std::size_t fixture, bool adds);
    void select_picked();

    AppModel& app_;
    QTimer resize_timer_;
    double asked_ratio_ = 0; // pixels of the display to one of the window, when the size was asked for
    Drag drag_ = Drag::none;
    QPointF drag_from_, drag_at_;
    std::vector<std::string> dragged_; // when it began
    Wipe wipe_;
    std::optional<LampDrag> lamp_; // that is dragged
    glm::vec3 moved_by_m_{0};
    glm::mat3 dragged_turn_{1};          // of what it is that a mover carries
    std::optional<MoverHandle> mover_;   // whose handle has the mouse
    float mover_value_ = 0;              // that it was dragged to
    std::optional<std::size_t> hovered_; // fixture
    QTimer hover_timer_;                 // until the mouse rests on it
    std::uint64_t picked_ = 0;           // number of the pick that a click waits for; 0: none
    bool adds_picked_ = false;
    std::set<std::size_t> selected_then_; // when it was asked for
    std::vector<std::size_t> let_go_;     // fixtures that the last click beside them let go of
    bool chooses_picked_ = false;         // an object that was met there
    QSet<int> held_;                      // keys that fly
    QTimer fly_timer_;
    QElapsedTimer fly_clock_;

    bool picture_waits_ = false;          // a new one, to be painted
    std::chrono::nanoseconds arrival_{0}; // of the first packet that no painted picture shows; 0: none waits
    double paint_ms_ = 0;
    Figures figures_;
    PictureSurface surface_{app_, *this};
    QTimer rest_timer_; // until the figures may say that it rests
};

} // namespace ghost::ui
