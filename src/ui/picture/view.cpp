// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/view.h"

#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/picture/private/chips.h"
#include "ui/widgets/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kFly_ms = 16;
constexpr int kHover_ms = 150; // a mouse that only passes asks nothing
constexpr float kFly_m_s = 4;
constexpr float kFastFly = 4;

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

View::View(AppModel& app, QWidget* parent) : QWidget(parent), app_(app), figures_(app) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 90);
    setMouseTracking(true); // for the probe
    setAccessibleName(translated("Picture", "Picture of the stage"));
    resize_timer_.setSingleShot(true);
    resize_timer_.setInterval(kResizeRest_ms);
    connect(&resize_timer_, &QTimer::timeout, this, &View::ask_for_size);
    rest_timer_.setSingleShot(true);
    connect(&rest_timer_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    fly_timer_.setInterval(kFly_ms);
    connect(&fly_timer_, &QTimer::timeout, this, &View::fly);
    connect(&app_, &AppModel::picture_came, this, &View::take_picture);
    connect(&app_, &AppModel::opened_show, this, [this] {
        if (app_.opened().is_edit) return;
        // A newer version of what was open: the picture goes on from where it was seen.
        if (!app_.opened().again) app_.cut_to(app_.show()->cameras.front());
        ask_for_size();
    });
    // Marks and aims move with the rig, figures with everything.
    connect(&app_, &AppModel::rig_came, this, [this] {
        if ((overlays.movers && !app_.show()->movers.empty()) || overlays.aims || overlays.names ||
            overlays.addresses || hovered_ || !app_.selection().empty())
            update();
    });
    connect(&app_, &AppModel::picked_came, this, &View::select_picked);
    hover_timer_.setSingleShot(true);
    hover_timer_.setInterval(kHover_ms);
    connect(&hover_timer_, &QTimer::timeout, this, [this] { app_.hover(hovered_); });
    connect(&app_, &AppModel::opened_show, this, [this] {
        set_hovered(std::nullopt);
        if (!app_.opened().is_edit && !app_.opened().again) wipe_.end();
        // An edit is heard of twice, the second time when the engine has read it, which may be in the middle
        // of the next drag.
        const bool goes_on = app_.opened().is_edit && names_of_dragged() == dragged_;
        const bool moves = drag_ == Drag::lamp || drag_ == Drag::object || drag_ == Drag::mover;
        if (moves && !goes_on) drag_ = Drag::none;
        if (drag_ != Drag::mover) mover_.reset();
    });
    for (const auto signal :
         {&AppModel::selection_changed, &AppModel::marked_changed, &AppModel::activity_came,
          &AppModel::opened_show, &AppModel::probe_came, &AppModel::hovered_came})
        connect(&app_, signal, this, qOverload<>(&QWidget::update));
}

void View::ask_for_size() {
    if (!app_.show()) return;
    const double ratio = asked_ratio_ = devicePixelRatioF();
    app_.set_size(std::max(static_cast<int>(std::lround(width() * ratio)), 16),
                  std::max(static_cast<int>(std::lround(height() * ratio)), 16));
}

void View::take_picture() {
    // A packet that a picture is late for because time stands still says nothing of its way.
    if (app_.request().frozen)
        arrival_ = {};
    else if (arrival_.count() == 0)
        arrival_ = app_.picture().arrival;
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
    const PictureSurface::Painting what = surface_.painting();
    if (what == PictureSurface::Painting::nothing) {
        painter.fillRect(rect(), Qt::black); // what a window shows that grows before its surface does
        return;
    }
    const Picture& picture = app_.picture();
    if (!app_.show() || !picture.image) {
        painter.fillRect(rect(), QColor(12, 12, 13));
        paint_notice(painter, size(),
                     !app_.activity().empty() ? said(app_.activity())
                     : app_.show()            ? translated("Picture", "The first picture is being drawn")
                                              : translated("Picture", "No show is open"),
                     QString());
        paint_box(painter);
        return;
    }
    const QRectF place = rect_of_picture();
    if (what == PictureSurface::Painting::all) {
        if (!place.adjusted(-1, -1, 1, 1).contains(rect())) painter.fillRect(rect(), Qt::black);
        paint_picture(painter, place, *picture.image);
    }
    wipe_.paint(painter, size());
    if (overlays.frame) paint_frame(painter, place, frame_rect(size(), app_.request().frame));
    if (overlays.movers && !app_.show()->movers.empty())
        paint_movers(painter, {app_.opened(), app_.rig(), place, picture.camera}, mover_);
    const SeenHeads heads{place, picture.camera, app_.rig(), app_.selection()};
    paint_fixtures(painter, heads, *app_.show(), {hovered_, why_hovered()}, overlays);
    if (drag_ == Drag::lamp) paint_moved(painter, heads, moved_by_m_, drag_at_, lamp_->words(moved_by_m_));
    if (const auto object = app_.marked(); object && overlays.marks)
        paint_object(painter, place, picture.camera,
                     object_now({app_.opened(), app_.rig(), place, picture.camera}, *object),
                     drag_ == Drag::object ? moved_by_m_ : glm::vec3(0));
    if (const auto handle = handle_of_object(); handle && drag_ != Drag::object)
        paint_handle(painter, *handle);
    if (drag_ == Drag::mover && mover_)
        paint_words(painter, drag_at_, value_words(*app_.show(), *mover_, mover_value_));
    if (drag_ == Drag::object) paint_words(painter, drag_at_, lamp_->words(moved_by_m_));
    if (picture.false_colour.measure != Measure::none) paint_legend(painter, size(), picture.false_colour);
    const double figures_px = overlays.figures ? paint_figures(painter, size(), figure_lines()) : 0;
    if (overlays.chips) paint_chips(painter, size(), chips_of(app_), figures_px);
    if (overlays.probe && app_.probed()) paint_probe(painter, place, size(), *app_.probed());
    paint_box(painter);
    painter.end();
    if (surface_.is_measuring()) return;
    paint_ms_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    if (std::exchange(picture_waits_, false))
        app_.count_window(std::chrono::nanoseconds(clock.nsecsElapsed()));
    if (arrival_.count() > 0) {
        const auto latency =
            std::chrono::steady_clock::now().time_since_epoch() - std::exchange(arrival_, {});
        figures_.take_latency(latency);
        app_.count_latency(latency);
    }
}

QStringList View::figure_lines() const {
    QStringList lines = figures_.lines();
    const ShowerNow& now = surface_.shower();
    if (!now.words.empty()) lines << said(now.words);
    if (!now.format.empty()) lines.back() += ", " + QString::fromStdString(now.format);
    return lines;
}

QStringList View::chip_words() const {
    QStringList words;
    for (const Chip& chip : chips_of(app_)) words << chip.text;
    return words;
}

Result<void> View::begin_wipe(double share) {
    if (!app_.picture().image) return Error{"there is no picture yet", ""};
    if (!wipe_.is_on()) wipe_.keep(app_.picture());
    wipe_.set_share(share);
    update();
    return {};
}

void View::end_wipe() {
    wipe_.end();
    update();
}

void View::paint_box(QPainter& painter) const {
    if (drag_ != Drag::box) return;
    painter.setPen(QPen(accent(), 1));
    painter.setBrush(QColor(255, 179, 71, 40));
    painter.drawRect(QRectF(drag_from_, drag_at_).normalized());
}

scene::Camera View::camera_of_picture() const {
    return app_.picture().image ? app_.picture().camera
                                : scene::with_frame(app_.camera(), app_.request().frame);
}

QRectF View::rect_of_picture() const {
    const Picture& picture = app_.picture();
    if (picture.image) return picture_rect(size(), picture.camera, picture.framed);
    const scene::Camera& camera = app_.camera();
    const glm::ivec2& frame = app_.request().frame;
    return picture_rect(size(), camera, {frame, scene::share_of_frame(camera, frame)});
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
    app_.set_camera(scene::flown(app_.camera_to_move(), way * (dt_s * kFly_m_s * (fast ? kFastFly : 1.0f))));
}

} // namespace ghost::ui
