// SPDX-License-Identifier: Apache-2.0
// The mouse in the picture: it selects, aims, drags lamps, and moves the camera.
#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/actions/object_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/fixture_groups.h"
#include "ui/picture/view.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::ui {
namespace {

constexpr double kClick_px = 4;
constexpr float kAround_m = 2;
constexpr double kHandle_px = 16;
constexpr double kBeside_px = 8;  // of a thin set piece
constexpr float kFloorSteps = 10; // of a set piece that is dragged, to the metre
constexpr float kOrbit_rad_px = 0.006f;
constexpr float kTurn_rad_px = 0.003f;

} // namespace

glm::vec3 View::way_of_mouse(const QPointF& place) const {
    const QRectF picture = rect_of_picture();
    return scene::way_through(
        camera_of_picture(),
        {static_cast<float>((place.x() - picture.left()) / std::max(picture.width(), 1.0)),
         static_cast<float>((place.y() - picture.top()) / std::max(picture.height(), 1.0))});
}

glm::vec3 View::floor_at(const QPointF& place) const {
    return scene::floor_along(camera_of_picture(), way_of_mouse(place));
}

std::optional<std::size_t> View::lamp_at(const QPointF& place) const {
    return fixture_at(rect_of_picture(), camera_of_picture(), app_.rig(), place);
}

void View::mousePressEvent(QMouseEvent* event) {
    drag_from_ = drag_at_ = event->position();
    if (event->button() == Qt::MiddleButton)
        drag_ = Drag::pan;
    else if (event->button() == Qt::RightButton)
        drag_ = Drag::turn;
    else if (event->button() == Qt::LeftButton)
        drag_ = wipe_.is_near(size(), event->position().x()) ? Drag::wipe : Drag::undecided;
}

// What a drag with the left button is that has begun: of a selected lamp, of a box, of the camera.
View::Drag View::drag_of_left(Qt::KeyboardModifiers keys) {
    if (keys & Qt::ControlModifier) return Drag::box;
    if (mover_ = mover_handle_at(drag_from_); mover_) {
        mover_value_ = mover_goals(app_, mover_->mover)[mover_->axis];
        return Drag::mover;
    }
    const QRectF picture = rect_of_picture();
    const scene::Camera camera = camera_of_picture();
    const MoverScene now{app_.opened(), app_.rig(), picture, camera};
    if (is_on_handle(drag_from_)) {
        const Object object = object_now(now, *app_.marked());
        lamp_ = LampDrag(object.centre_m, object.centre_m, {});
        moved_by_m_ = glm::vec3(0);
        dragged_turn_ = glm::mat3(moved_now(now, object.mover));
        return Drag::object;
    }
    const auto hit = lamp_at(drag_from_);
    if (hit && on_move && app_.selection().contains(*hit)) {
        std::vector<Object> objects;
        for (std::size_t i = 0; i < app_.opened().objects.size(); ++i) objects.push_back(object_now(now, i));
        const auto drag_of = [&](std::size_t index) {
            const auto& fixture = app_.show()->fixtures[index];
            const glm::vec3 light_m = app_.rig().fixtures[index].light_m;
            const glm::vec3 hangs_m(moved_now(now, fixture.mover) * glm::vec4(fixture.position_m, 1));
            return LampDrag(light_m, fixture.track ? light_m : hangs_m, objects);
        };
        dragged_turn_ = glm::mat3(moved_now(now, app_.show()->fixtures[*hit].mover));
        lamp_ = drag_of(*hit);
        for (const std::size_t index : app_.selection())
            if (index < app_.rig().fixtures.size()) lamp_->take_along(drag_of(index));
        moved_by_m_ = glm::vec3(0);
        return Drag::lamp;
    }
    return keys & Qt::ShiftModifier ? Drag::pan : Drag::orbit;
}

std::vector<std::string> View::names_of_dragged() const {
    std::vector<std::string> names;
    if (drag_ == Drag::lamp)
        for (const std::size_t index : app_.selection()) names.push_back(app_.show()->fixtures[index].name);
    if (const auto object = app_.marked(); drag_ == Drag::object && object)
        names.push_back(app_.opened().objects[*object].name);
    if (drag_ == Drag::mover && mover_ && mover_->mover < app_.show()->movers.size()) {
        const scene::Mover& mover = app_.show()->movers[mover_->mover];
        names.push_back(mover.name);
        if (mover_->axis < mover.axes.size()) names.push_back(mover.axes[mover_->axis].name);
    }
    return names;
}

void View::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - drag_at_;
    if (drag_ == Drag::undecided && QLineF(drag_from_, event->position()).length() > kClick_px) {
        drag_ = drag_of_left(event->modifiers());
        dragged_ = names_of_dragged();
    }
    if (drag_ != Drag::none) set_hovered(std::nullopt);
    if (drag_ == Drag::none) {
        if (overlays.probe) probe_at(event->position());
        hover_at(event->position());
    }
    if (drag_ == Drag::none || drag_ == Drag::undecided) return;
    drag_at_ = event->position();
    const auto x = static_cast<float>(moved.x()), y = static_cast<float>(moved.y());
    const scene::Camera camera = app_.camera_to_move();
    const auto height = static_cast<float>(std::max(frame_rect(size(), app_.request().frame).height(), 1.0));
    if (drag_ == Drag::orbit)
        app_.set_camera(scene::orbited(camera, kOrbit_rad_px * x, kOrbit_rad_px * y));
    else if (drag_ == Drag::turn)
        app_.set_camera(scene::turned(camera, -kTurn_rad_px * x, -kTurn_rad_px * y));
    else if (drag_ == Drag::pan)
        app_.set_camera(scene::panned(camera, -x / height, y / height));
    else if (drag_ == Drag::lamp)
        drag_lamp(event->modifiers() & Qt::ShiftModifier);
    else if (drag_ == Drag::object)
        drag_object(event->modifiers() & Qt::ShiftModifier);
    else if (drag_ == Drag::mover)
        drag_mover();
    else if (drag_ == Drag::wipe)
        wipe_.set_share(drag_at_.x() / std::max(width(), 1));
    if (drag_ == Drag::lamp || drag_ == Drag::object || drag_ == Drag::mover || drag_ == Drag::box ||
        drag_ == Drag::wipe)
        update();
}

// The place that was taken hold of stays under the mouse.
void View::drag_lamp(bool upright) {
    const glm::vec3 eye_m = camera_of_picture().position_m;
    moved_by_m_ = lamp_->by_m(eye_m, way_of_mouse(drag_from_), way_of_mouse(drag_at_), upright);
}

glm::vec3 View::dragged_by_m() const {
    if (dragged_turn_ == glm::mat3(1)) return moved_by_m_;
    return glm::round(glm::transpose(dragged_turn_) * moved_by_m_ * 1000.0f) / 1000.0f;
}

std::optional<QPointF> View::handle_of_object() const {
    const auto object = app_.marked();
    if (!object || !on_move_object || !overlays.marks) return std::nullopt;
    const QRectF picture = rect_of_picture();
    const scene::Camera camera = camera_of_picture();
    return to_widget(picture, camera,
                     object_now({app_.opened(), app_.rig(), picture, camera}, *object).centre_m);
}

bool View::is_on_handle(const QPointF& place) const {
    const auto handle = handle_of_object();
    return handle && QLineF(*handle, place).length() < kHandle_px;
}

// Over the floor, its height stays.
void View::drag_object(bool freely) {
    drag_lamp(false);
    if (!freely) moved_by_m_ = glm::round(moved_by_m_ * kFloorSteps) / kFloorSteps;
}

std::optional<MoverHandle> View::mover_handle_at(const QPointF& place) const {
    if (!app_.show() || !overlays.movers || app_.show()->movers.empty()) return std::nullopt;
    const QRectF picture = rect_of_picture();
    const scene::Camera camera = camera_of_picture();
    return handle_at({app_.opened(), app_.rig(), picture, camera}, place);
}

// What a hand asks for; the machine follows as fast as it can.
void View::drag_mover() {
    if (!mover_ || !app_.show() || mover_->mover >= app_.show()->movers.size()) return;
    const QRectF picture = rect_of_picture();
    const scene::Camera camera = camera_of_picture();
    const float value =
        dragged_value({app_.opened(), app_.rig(), picture, camera}, *mover_, drag_at_, mover_value_);
    if (value == mover_value_) return;
    mover_value_ = value;
    std::vector<float> values = mover_goals(app_, mover_->mover);
    if (mover_->axis >= values.size()) return;
    values[mover_->axis] = value;
    drive_mover(app_, mover_->mover, std::move(values));
}

void View::hover_at(const QPointF& place) {
    const auto hit = app_.show() ? lamp_at(place) : std::nullopt;
    const auto mover = mover_handle_at(place);
    if (mover != std::exchange(mover_, mover)) update();
    const bool moves = mover || is_on_handle(place) || (hit && on_move && app_.selection().contains(*hit));
    setCursor(wipe_.is_near(size(), place.x()) ? Qt::SplitHCursor
              : moves                          ? Qt::SizeAllCursor
                                               : Qt::ArrowCursor);
    set_hovered(hit);
}

void View::set_hovered(std::optional<std::size_t> fixture) {
    if (fixture == std::exchange(hovered_, fixture)) return;
    app_.hover(std::nullopt);
    if (fixture)
        hover_timer_.start();
    else
        hover_timer_.stop();
    update();
}

QString View::why_hovered() const {
    const std::optional<Explained>& explained = app_.hovered();
    if (!explained || explained->fixture != hovered_) return QString();
    const QString held = held_back(app_.request(), app_.rig().remote, app_.look(), explained->fixture);
    return held.isEmpty() ? said(explained->explanation.verdict) : held;
}

void View::leaveEvent(QEvent*) {
    set_hovered(std::nullopt);
    if (drag_ == Drag::none && std::exchange(mover_, std::nullopt)) update();
}

void View::probe_at(const QPointF& place) {
    const QRectF picture = rect_of_picture();
    if (!app_.show() || picture.isEmpty()) return;
    overlays.probe = true;
    app_.change_request([&](ViewRequest& request) {
        request.probe = glm::clamp(glm::vec2((place.x() - picture.left()) / picture.width(),
                                             (place.y() - picture.top()) / picture.height()),
                                   0.0f, 1.0f);
    });
}

void View::end_probe() {
    overlays.probe = false;
    app_.change_request([](ViewRequest& request) { request.probe.reset(); });
    update();
}

// Where no lamp is near, whatever is met there may be the body of one: the engine says it (select_picked).
void View::click(const QPointF& place, Qt::KeyboardModifiers keys) {
    if (!app_.show()) return;
    const QRectF picture = rect_of_picture();
    if (keys & Qt::ShiftModifier) {
        if (on_aim && !picture.isEmpty())
            on_aim(glm::clamp(glm::vec2((place.x() - picture.left()) / picture.width(),
                                        (place.y() - picture.top()) / picture.height()),
                              0.0f, 1.0f));
        return;
    }
    const bool adds = keys & Qt::ControlModifier;
    let_go_.clear();
    if (const auto hit = lamp_at(place)) {
        select_one(*hit, adds);
        return;
    }
    let_go_ = app_.selected_in_order();
    if (!adds) app_.select({});
    adds_picked_ = adds;
    chooses_picked_ = false;
    selected_then_ = app_.selection();
    picked_ = app_.pick(camera_of_picture().position_m, way_of_mouse(place));
}

void View::select_one(std::size_t fixture, bool adds) {
    std::set<std::size_t> selection = adds ? app_.selection() : std::set<std::size_t>{};
    if (!selection.insert(fixture).second) selection.erase(fixture);
    app_.select(std::move(selection));
}

void View::select_picked() {
    const Picked& picked = app_.picked();
    if (picked.number != picked_) return;
    if (chooses_picked_ && picked.hit && !picked.fixture) {
        picked_ = 0;
        app_.mark(object_met(app_, picked));
        return;
    }
    if (!picked.fixture) return;
    picked_ = 0;
    if (app_.selection() != selected_then_) return; // who selects something meanwhile means that
    if (*picked.fixture < app_.show()->fixtures.size()) select_one(*picked.fixture, adds_picked_);
}

void View::mouseReleaseEvent(QMouseEvent* event) {
    const Drag drag = std::exchange(drag_, Drag::none);
    if (drag == Drag::undecided) {
        click(event->position(), event->modifiers());
    } else if (drag == Drag::lamp) {
        if (moved_by_m_ != glm::vec3(0)) on_move(dragged_by_m());
        update();
    } else if (drag == Drag::object) {
        if (const auto object = app_.marked(); object && moved_by_m_ != glm::vec3(0))
            on_move_object(*object, dragged_by_m());
        update();
    } else if (drag == Drag::mover) {
        update();
    } else if (drag == Drag::box) {
        std::set<std::size_t> selection =
            event->modifiers() & Qt::ControlModifier ? app_.selection() : std::set<std::size_t>{};
        selection.merge(fixtures_in(rect_of_picture(), camera_of_picture(), app_.rig(),
                                    QRectF(drag_from_, event->position()).normalized()));
        app_.select(std::move(selection));
        update();
    }
}

void View::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        mousePressEvent(event); // two quick turns of the camera are no choice
        return;
    }
    if (!app_.show()) return;
    if (const auto hit = lamp_at(event->position())) {
        app_.look_at(app_.rig().fixtures[*hit].light_m, kAround_m);
        return;
    }
    // Its first click was no wish to let go of the heads that shall hang at what is chosen.
    if (app_.selection().empty()) app_.select_in_order(std::exchange(let_go_, {}));
    chooses_picked_ = true;
    selected_then_ = app_.selection();
    const glm::vec3 way = way_of_mouse(event->position());
    const glm::vec3 beside = way_of_mouse(event->position() + QPointF(kBeside_px, 0));
    picked_ = app_.pick(camera_of_picture().position_m, way, glm::length(glm::cross(way, beside)));
}

void View::wheelEvent(QWheelEvent* event) {
    const float notches = static_cast<float>(event->angleDelta().y()) / 120.0f;
    app_.set_camera(scene::dollied(app_.camera_to_move(), std::pow(0.88f, notches)));
}

} // namespace ghost::ui
