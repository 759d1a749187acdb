// SPDX-License-Identifier: Apache-2.0
#include "ui/view.h"

#include "scene/camera_moves.h"
#include "ui/chips.h"
#include "ui/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kRest_ms = 150; // of a window that is being resized
constexpr int kFly_ms = 16;
constexpr float kFly_m_s = 4;
constexpr float kFastFly = 4;
constexpr double kClick_px = 4;
constexpr float kAround_m = 2;
constexpr float kOrbit_rad_px = 0.006f;
constexpr float kTurn_rad_px = 0.003f;

// Right, forward, up of a key that flies.
glm::vec3 way_of(int key) {
    switch (key) {
    case Qt::Key_W:
    case Qt::Key_Up:
        return {0, 1, 0};
    case Qt::Key_S:
    case Qt::Key_Down:
        return {0, -1, 0};
    case Qt::Key_D:
    case Qt::Key_Right:
        return {1, 0, 0};
    case Qt::Key_A:
    case Qt::Key_Left:
        return {-1, 0, 0};
    case Qt::Key_E:
    case Qt::Key_PageUp:
        return {0, 0, 1};
    case Qt::Key_Q:
    case Qt::Key_PageDown:
        return {0, 0, -1};
    default:
        return {0, 0, 0};
    }
}

} // namespace

View::View(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio), figures_(studio) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 90);
    setMouseTracking(true); // for the probe
    setAccessibleName("Picture of the stage");
    resize_timer_.setSingleShot(true);
    resize_timer_.setInterval(kRest_ms);
    connect(&resize_timer_, &QTimer::timeout, this, &View::ask_for_size);
    rest_timer_.setSingleShot(true);
    connect(&rest_timer_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    fly_timer_.setInterval(kFly_ms);
    connect(&fly_timer_, &QTimer::timeout, this, &View::fly);
    connect(&studio_, &Studio::picture_came, this, &View::take_picture);
    connect(&studio_, &Studio::opened_show, this, [this] {
        if (studio_.opened().is_edit) return;
        // A newer version of what was open: the picture goes on from where it was seen.
        if (!studio_.opened().again) studio_.cut_to(studio_.show()->cameras.front());
        ask_for_size();
    });
    // Marks and aims move with the rig, figures with everything.
    connect(&studio_, &Studio::rig_came, this, [this] {
        if (overlays.aims || overlays.names || overlays.addresses || !studio_.selection().empty()) update();
    });
    for (const auto signal : {&Studio::selection_changed, &Studio::marked_changed, &Studio::activity_came,
                              &Studio::opened_show, &Studio::probe_came})
        connect(&studio_, signal, this, qOverload<>(&QWidget::update));
}

void View::ask_for_size() {
    if (!studio_.show()) return;
    const double ratio = asked_ratio_ = devicePixelRatioF();
    studio_.set_size(std::max(static_cast<int>(std::lround(width() * ratio)), 16),
                     std::max(static_cast<int>(std::lround(height() * ratio)), 16));
}

void View::take_picture() {
    if (arrival_.count() == 0) arrival_ = studio_.picture().arrival;
    picture_waits_ = true;
    figures_.count_picture();
    rest_timer_.start(figures_.rest_ms());
    update();
}

void View::resizeEvent(QResizeEvent*) {
    resize_timer_.start();
}

void View::paintEvent(QPaintEvent*) {
    QElapsedTimer clock;
    clock.start();
    // Another display, or another scale of this one, often leaves the window its size.
    if (asked_ratio_ > 0 && asked_ratio_ != devicePixelRatioF() && !resize_timer_.isActive())
        resize_timer_.start();
    QPainter painter(this);
    const Picture& picture = studio_.picture();
    if (!studio_.show() || !picture.image) {
        painter.fillRect(rect(), QColor(12, 12, 13));
        const bool waits = !studio_.activity().empty() || studio_.show();
        paint_notice(painter, size(),
                     waits ? QString::fromStdString(studio_.activity()) : QString("No show is open"),
                     waits ? QString() : hint);
        paint_box(painter);
        return;
    }
    const QRectF place = rect_of_picture();
    if (!place.adjusted(-1, -1, 1, 1).contains(rect())) painter.fillRect(rect(), Qt::black);
    paint_picture(painter, place, *picture.image);
    if (overlays.frame) paint_frame(painter, place, frame_rect(size(), studio_.wishes().frame));
    paint_fixtures(painter, place, picture.camera, *studio_.show(), studio_.rig(), studio_.selection(),
                   overlays);
    if (const auto object = studio_.marked(); object && overlays.marks)
        paint_object(painter, place, picture.camera, studio_.opened().objects[*object]);
    if (picture.false_colour.measure != Measure::none) paint_legend(painter, size(), picture.false_colour);
    const double figures_px = overlays.figures ? paint_figures(painter, size(), figures_.lines()) : 0;
    if (overlays.chips) paint_chips(painter, size(), chips_of(studio_), figures_px);
    if (overlays.probe && studio_.probed()) paint_probe(painter, place, size(), *studio_.probed());
    paint_box(painter);
    painter.end();
    paint_ms_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    if (std::exchange(picture_waits_, false))
        studio_.count_window(std::chrono::nanoseconds(clock.nsecsElapsed()));
    if (arrival_.count() > 0) {
        const auto latency =
            std::chrono::steady_clock::now().time_since_epoch() - std::exchange(arrival_, {});
        figures_.take_latency(latency);
        studio_.count_latency(latency);
    }
}

void View::paint_box(QPainter& painter) const {
    if (drag_ != Drag::box) return;
    painter.setPen(QPen(accent(), 1));
    painter.setBrush(QColor(255, 179, 71, 40));
    painter.drawRect(QRectF(drag_from_, drag_at_).normalized());
}

scene::Camera View::camera_of_picture() const {
    return studio_.picture().image ? studio_.picture().camera
                                   : scene::with_frame(studio_.camera(), studio_.wishes().frame);
}

QRectF View::rect_of_picture() const {
    const Picture& picture = studio_.picture();
    if (picture.image) return picture_rect(size(), picture.camera, picture.framed);
    const scene::Camera& camera = studio_.camera();
    const glm::ivec2& frame = studio_.wishes().frame;
    return picture_rect(size(), camera, {frame, scene::share_of_frame(camera, frame)});
}

void View::mousePressEvent(QMouseEvent* event) {
    drag_from_ = drag_at_ = event->position();
    const bool shift = event->modifiers() & Qt::ShiftModifier,
               control = event->modifiers() & Qt::ControlModifier;
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift && !control))
        drag_ = Drag::pan;
    else if (event->button() == Qt::RightButton)
        drag_ = Drag::turn;
    else if (event->button() == Qt::LeftButton)
        drag_ = Drag::undecided;
}

void View::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - drag_at_;
    if (drag_ == Drag::undecided && QLineF(drag_from_, event->position()).length() > kClick_px)
        drag_ = event->modifiers() & Qt::ControlModifier ? Drag::box : Drag::orbit;
    if (drag_ == Drag::none && overlays.probe) probe_at(event->position());
    if (drag_ == Drag::none || drag_ == Drag::undecided) return;
    drag_at_ = event->position();
    const auto x = static_cast<float>(moved.x()), y = static_cast<float>(moved.y());
    const scene::Camera& camera = studio_.camera();
    const auto height =
        static_cast<float>(std::max(frame_rect(size(), studio_.wishes().frame).height(), 1.0));
    if (drag_ == Drag::orbit)
        studio_.set_camera(scene::orbited(camera, kOrbit_rad_px * x, kOrbit_rad_px * y));
    else if (drag_ == Drag::turn)
        studio_.set_camera(scene::turned(camera, -kTurn_rad_px * x, -kTurn_rad_px * y));
    else if (drag_ == Drag::pan)
        studio_.set_camera(scene::panned(camera, -x / height, y / height));
    else
        update();
}

void View::probe_at(const QPointF& place) {
    const QRectF picture = rect_of_picture();
    if (!studio_.show() || picture.isEmpty()) return;
    overlays.probe = true;
    studio_.wish([&](Wishes& wishes) {
        wishes.probe = glm::clamp(glm::vec2((place.x() - picture.left()) / picture.width(),
                                            (place.y() - picture.top()) / picture.height()),
                                  0.0f, 1.0f);
    });
}

void View::end_probe() {
    overlays.probe = false;
    studio_.wish([](Wishes& wishes) { wishes.probe.reset(); });
    update();
}

void View::mouseReleaseEvent(QMouseEvent* event) {
    const bool adds = event->modifiers() & Qt::ControlModifier;
    std::set<std::size_t> selection = adds ? studio_.selection() : std::set<std::size_t>{};
    const scene::Camera camera = camera_of_picture();
    if (drag_ == Drag::undecided) {
        const auto hit = fixture_at(rect_of_picture(), camera, studio_.rig(), event->position());
        if (hit && adds && selection.contains(*hit))
            selection.erase(*hit);
        else if (hit)
            selection.insert(*hit);
        studio_.select(std::move(selection));
    } else if (drag_ == Drag::box) {
        selection.merge(fixtures_in(rect_of_picture(), camera, studio_.rig(),
                                    QRectF(drag_from_, event->position()).normalized()));
        studio_.select(std::move(selection));
        update();
    }
    drag_ = Drag::none;
}

void View::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!studio_.show()) return;
    const auto hit = fixture_at(rect_of_picture(), camera_of_picture(), studio_.rig(), event->position());
    if (hit) studio_.look_at(studio_.rig().fixtures[*hit].light_m, kAround_m);
}

void View::wheelEvent(QWheelEvent* event) {
    const float notches = static_cast<float>(event->angleDelta().y()) / 120.0f;
    studio_.set_camera(scene::dollied(studio_.camera(), std::pow(0.88f, notches)));
}

void View::keyPressEvent(QKeyEvent* event) {
    if (way_of(event->key()) == glm::vec3(0) ||
        event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->isAutoRepeat()) return;
    held_.insert(event->key());
    if (fly_timer_.isActive()) return;
    fly_clock_.start();
    fly_timer_.start();
}

void View::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat() || !held_.contains(event->key())) {
        QWidget::keyReleaseEvent(event);
        return;
    }
    fly(); // what is left of the way
    held_.remove(event->key());
    if (held_.isEmpty()) fly_timer_.stop();
}

void View::focusOutEvent(QFocusEvent*) {
    held_.clear();
    fly_timer_.stop();
}

void View::fly() {
    const float dt_s = static_cast<float>(fly_clock_.restart()) * 1e-3f;
    glm::vec3 way(0);
    for (const int key : held_) way += way_of(key);
    if (way == glm::vec3(0) || dt_s <= 0) return;
    const bool fast = QGuiApplication::keyboardModifiers() & Qt::ShiftModifier;
    studio_.set_camera(scene::flown(studio_.camera(), way * (dt_s * kFly_m_s * (fast ? kFastFly : 1.0f))));
}

} // namespace ghost::ui
