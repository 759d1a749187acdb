// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/mover_marks.h"

#include "show/mover_pose.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/picture/overlays.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr double kHandleReach_px = 14;
constexpr int kSteps = 64;           // of a way
constexpr float kFarthest_m = 30;    // of a way from where it is, that is drawn
constexpr float kMostTurn_deg = 180; // likewise
constexpr float kNextTurn_deg = 120; // that a mouse goes round at once
constexpr float kLeast_m = 0.02f;    // between where a mover is and where it goes
constexpr float kLeast_deg = 0.5f;   // likewise
constexpr float kArm_m = 0.8f;       // of the handles of what flies
constexpr float kLeastRadius_m = 0.5f;

using Values = std::vector<float> MoverNow::*;

std::vector<double> values_of(const MoverScene& scene, std::size_t mover, Values which) {
    std::vector<double> values(scene.opened.show->movers[mover].axes.size(), 0.0);
    if (mover >= scene.rig.movers.size()) return values;
    const std::vector<float>& now = scene.rig.movers[mover].*which;
    std::copy_n(now.begin(), std::min(now.size(), values.size()), values.begin());
    return values;
}

// From where the model has what it carries to where that is, or will be. own: of the mover itself.
glm::dmat4 moved(const MoverScene& scene, std::size_t mover, const std::vector<double>& own, Values which) {
    const std::vector<scene::Mover>& movers = scene.opened.show->movers;
    glm::dmat4 by = scene::pose_of(movers[mover], own);
    for (int on = movers[mover].parent; on != scene::kNoMover;
         on = movers[static_cast<std::size_t>(on)].parent) {
        const auto parent = static_cast<std::size_t>(on);
        by = scene::pose_of(movers[parent], values_of(scene, parent, which)) * by;
    }
    return by;
}

std::array<glm::vec3, 8> corners_of(const Object& object) {
    std::array<glm::vec3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] =
            object.centre_m + object.half_size_m * glm::vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    return corners;
}

// All that a mover carries itself, where the model has it.
std::vector<glm::vec3> load_of(const MoverScene& scene, std::size_t mover) {
    std::vector<glm::vec3> load;
    for (const Object& object : scene.opened.objects)
        if (object.mover == static_cast<int>(mover))
            for (const glm::vec3& corner : corners_of(object)) load.push_back(corner);
    for (const scene::PatchedFixture& fixture : scene.opened.show->fixtures)
        if (fixture.mover == static_cast<int>(mover)) load.push_back(fixture.position_m);
    return load;
}

glm::vec3 middle_of(const std::vector<glm::vec3>& load) {
    if (load.empty()) return glm::vec3(0);
    glm::vec3 low_m = load.front(), high_m = low_m;
    for (const glm::vec3& place : load) {
        low_m = glm::min(low_m, place);
        high_m = glm::max(high_m, place);
    }
    return 0.5f * (low_m + high_m);
}

// On its rim, towards the house.
glm::vec3 rim_of(const scene::Mover& mover, const std::vector<glm::vec3>& load) {
    float radius_m = kLeastRadius_m, along_m = 0;
    for (const glm::vec3& place : load) {
        const glm::vec3 from = place - mover.centre_m;
        const float along = glm::dot(from, mover.direction);
        radius_m = std::max(radius_m, glm::length(from - along * mover.direction));
        along_m += along / static_cast<float>(load.size());
    }
    const glm::vec3 side = std::abs(mover.direction.y) < 0.9f ? glm::vec3(0, -1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 out = glm::normalize(side - glm::dot(side, mover.direction) * mover.direction);
    return mover.centre_m + along_m * mover.direction + radius_m / std::sqrt(2.0f) * out;
}

// Of an axis, where the model has it.
glm::vec3 home_of(const MoverScene& scene, const MoverHandle& handle) {
    static constexpr float kHalf = 0.7071f * kArm_m;
    static constexpr std::array<glm::vec3, 6> kArms{
        glm::vec3(kArm_m, 0, 0),    {0, kArm_m, 0},    {0, 0, kArm_m}, // x, y, z
        glm::vec3(0, kHalf, kHalf), {kHalf, 0, kHalf}, {kHalf, kHalf, 0}};
    const scene::Mover& mover = scene.opened.show->movers[handle.mover];
    const scene::MoverAxis& axis = mover.axes[handle.axis];
    switch (mover.kind) {
    case scene::MoverKind::hoists:
        return axis.point_m;
    case scene::MoverKind::linear:
        return middle_of(load_of(scene, handle.mover));
    case scene::MoverKind::revolve:
        return rim_of(mover, load_of(scene, handle.mover));
    case scene::MoverKind::path:
        return mover.path_m.front();
    case scene::MoverKind::flown:
        break;
    }
    return mover.centre_m + kArms[static_cast<std::size_t>(axis.degree)];
}

bool is_axis(const MoverScene& scene, const MoverHandle& handle) {
    const std::vector<scene::Mover>& movers = scene.opened.show->movers;
    return handle.mover < movers.size() && handle.axis < movers[handle.mover].axes.size();
}

float value_now(const MoverScene& scene, const MoverHandle& handle) {
    return static_cast<float>(values_of(scene, handle.mover, &MoverNow::values)[handle.axis]);
}

// home_m: of the handle, which is not cheap to find.
glm::vec3 place_m(const MoverScene& scene, const MoverHandle& handle, const glm::vec3& home_m, float value) {
    std::vector<double> own = values_of(scene, handle.mover, &MoverNow::values);
    own[handle.axis] = static_cast<double>(value);
    return glm::vec3(moved(scene, handle.mover, own, &MoverNow::values) *
                     glm::dvec4(glm::dvec3(home_m), 1.0));
}

// What of the way between the end stops is drawn and dragged along.
struct Reach {
    float low, high;
};

Reach reach_about(const scene::MoverAxis& axis, float value, float most) {
    return {std::clamp(value - most, axis.low, axis.high), std::clamp(value + most, axis.low, axis.high)};
}

template <class F>
void for_each_axis(const MoverScene& scene, F&& f) {
    const std::vector<scene::Mover>& movers = scene.opened.show->movers;
    for (std::size_t m = 0; m < movers.size(); ++m)
        for (std::size_t a = 0; a < movers[m].axes.size(); ++a) f(MoverHandle{m, a}, movers[m].axes[a]);
}

// Seen on black and on white.
void paint_line(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour,
                Qt::PenStyle style) {
    painter.setPen(QPen(QColor(0, 0, 0, 130), 3));
    painter.drawLine(from, to);
    painter.setPen(QPen(colour, 1.4, style));
    painter.drawLine(from, to);
}

void paint_stop(QPainter& painter, const QPointF& at, const QPointF& beside, const QColor& colour) {
    constexpr double kHalf_px = 7;
    const QLineF way(at, beside);
    if (way.length() < 1e-3) return;
    const QPointF across(-way.dy() / way.length() * kHalf_px, way.dx() / way.length() * kHalf_px);
    painter.setPen(QPen(QColor(0, 0, 0, 160), 5));
    painter.drawLine(at - across, at + across);
    painter.setPen(QPen(colour, 2.4));
    painter.drawLine(at - across, at + across);
}

void paint_way(QPainter& painter, const MoverScene& scene, const MoverHandle& handle, bool is_hot) {
    const scene::MoverAxis& axis = scene.opened.show->movers[handle.mover].axes[handle.axis];
    const Reach reach =
        reach_about(axis, value_now(scene, handle), axis.is_angle ? kMostTurn_deg : kFarthest_m);
    const QColor colour = is_hot ? accent() : QColor(205, 205, 205, 170);
    const glm::vec3 home_m = home_of(scene, handle);
    std::vector<std::optional<QPointF>> places;
    for (int k = 0; k <= kSteps; ++k)
        places.push_back(
            to_widget(scene.picture, scene.camera,
                      place_m(scene, handle, home_m,
                              std::lerp(reach.low, reach.high, static_cast<float>(k) / kSteps))));
    for (std::size_t k = 0; k + 1 < places.size(); ++k)
        if (places[k] && places[k + 1])
            paint_line(painter, *places[k], *places[k + 1], colour, Qt::SolidLine);
    const auto stop = [&](const std::optional<QPointF>& at, const std::optional<QPointF>& beside, float value,
                          float end) {
        if (!at || !beside || value != end) return;
        paint_stop(painter, *at, *beside, colour);
        if (is_hot) paint_words(painter, *at, value_words(*scene.opened.show, handle, end));
    };
    stop(places.front(), places[1], reach.low, axis.low);
    stop(places.back(), places[places.size() - 2], reach.high, axis.high);
    const auto at =
        to_widget(scene.picture, scene.camera, place_m(scene, handle, home_m, value_now(scene, handle)));
    if (!at) return;
    constexpr double kHalf_px = 6;
    const QPointF diamond[] = {*at + QPointF(0, -kHalf_px), *at + QPointF(kHalf_px, 0),
                               *at + QPointF(0, kHalf_px), *at + QPointF(-kHalf_px, 0)};
    painter.setPen(QPen(QColor(0, 0, 0, 200), 2));
    painter.setBrush(colour);
    painter.drawPolygon(diamond, 4);
}

// Of a mover and of all that it hangs on.
bool is_on_its_way(const MoverScene& scene, std::size_t mover) {
    for (int on = static_cast<int>(mover); on != scene::kNoMover;
         on = scene.opened.show->movers[static_cast<std::size_t>(on)].parent) {
        const auto index = static_cast<std::size_t>(on);
        const auto values = values_of(scene, index, &MoverNow::values);
        const auto goals = values_of(scene, index, &MoverNow::goals);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool is_angle = scene.opened.show->movers[index].axes[k].is_angle;
            if (std::abs(values[k] - goals[k]) > static_cast<double>(is_angle ? kLeast_deg : kLeast_m))
                return true;
        }
    }
    return false;
}

// The outline of its load where it goes.
void paint_ghost(QPainter& painter, const MoverScene& scene, std::size_t mover) {
    const glm::mat4 by(moved(scene, mover, values_of(scene, mover, &MoverNow::goals), &MoverNow::goals));
    const auto seen = [&](const glm::vec3& home_m) {
        return to_widget(scene.picture, scene.camera, glm::vec3(by * glm::vec4(home_m, 1.0f)));
    };
    for (const Object& object : scene.opened.objects) {
        if (object.mover != static_cast<int>(mover)) continue;
        const std::array<glm::vec3, 8> corners = corners_of(object);
        for (std::size_t k = 0; k < corners.size(); ++k)
            for (std::size_t side = 1; side < corners.size(); side *= 2) {
                if (k & side) continue; // each edge once
                const auto from = seen(corners[k]), to = seen(corners[k | side]);
                if (from && to) paint_line(painter, *from, *to, accent(), Qt::DashLine);
            }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent(), 1.4, Qt::DashLine));
    for (const scene::PatchedFixture& fixture : scene.opened.show->fixtures)
        if (fixture.mover == static_cast<int>(mover))
            if (const auto at = seen(fixture.position_m)) painter.drawEllipse(*at, 6, 6);
}

} // namespace

glm::mat4 moved_now(const MoverScene& scene, int mover) {
    const auto index = static_cast<std::size_t>(mover);
    if (mover == scene::kNoMover || index >= scene.opened.show->movers.size()) return glm::mat4(1);
    return glm::mat4(moved(scene, index, values_of(scene, index, &MoverNow::values), &MoverNow::values));
}

Object object_now(const MoverScene& scene, std::size_t object) {
    Object now = scene.opened.objects[object];
    const glm::mat4 by = moved_now(scene, now.mover);
    const auto put = [&](glm::vec3& place_m) { place_m = glm::vec3(by * glm::vec4(place_m, 1.0f)); };
    put(now.centre_m);
    if (now.bar) {
        put(now.bar->from_m);
        put(now.bar->to_m);
    }
    return now;
}

glm::vec3 handle_at_m(const MoverScene& scene, const MoverHandle& handle, float value) {
    return place_m(scene, handle, home_of(scene, handle), value);
}

std::optional<MoverHandle> handle_at(const MoverScene& scene, const QPointF& place) {
    std::optional<MoverHandle> nearest;
    double nearest_px = kHandleReach_px;
    for_each_axis(scene, [&](const MoverHandle& handle, const scene::MoverAxis&) {
        const auto at =
            to_widget(scene.picture, scene.camera, handle_at_m(scene, handle, value_now(scene, handle)));
        if (!at || QLineF(*at, place).length() >= nearest_px) return;
        nearest_px = QLineF(*at, place).length();
        nearest = handle;
    });
    return nearest;
}

float dragged_value(const MoverScene& scene, const MoverHandle& handle, const QPointF& place, float near) {
    if (!is_axis(scene, handle)) return near;
    const scene::MoverAxis& axis = scene.opened.show->movers[handle.mover].axes[handle.axis];
    const Reach reach = reach_about(axis, near, axis.is_angle ? kNextTurn_deg : kFarthest_m);
    const glm::vec3 home_m = home_of(scene, handle);
    float value = near;
    double nearest_px = INFINITY;
    std::optional<QPointF> before;
    for (int k = 0; k <= kSteps; ++k) {
        const float share = static_cast<float>(k) / kSteps;
        const auto at = to_widget(scene.picture, scene.camera,
                                  place_m(scene, handle, home_m, std::lerp(reach.low, reach.high, share)));
        if (at && before) {
            // The nearest place of the piece of way.
            const QPointF way = *at - *before, from = place - *before;
            const double length2 = QPointF::dotProduct(way, way);
            const double along =
                length2 > 0 ? std::clamp(QPointF::dotProduct(from, way) / length2, 0.0, 1.0) : 0.0;
            const double px = QLineF(*before + along * way, place).length();
            if (px < nearest_px) {
                nearest_px = px;
                value = std::lerp(reach.low, reach.high,
                                  (static_cast<float>(k - 1) + static_cast<float>(along)) / kSteps);
            }
        }
        before = at;
    }
    const float steps = axis.is_angle ? 2.0f : 100.0f; // to the degree, to the metre
    return std::clamp(std::round(value * steps) / steps, axis.low, axis.high);
}

QString value_words(const scene::Show& show, const MoverHandle& handle, float value) {
    const scene::MoverAxis& axis = show.movers[handle.mover].axes[handle.axis];
    const auto number = [&](float one) {
        return QString::number(static_cast<double>(one), 'f', axis.is_angle ? 1 : 2);
    };
    return (axis.is_angle ? translated("Movers", "%1 %2° of %3 to %4")
                          : translated("Movers", "%1 %2 m of %3 to %4"))
        .arg(QString::fromStdString(axis.name), number(value), number(axis.low), number(axis.high));
}

void paint_movers(QPainter& painter, const MoverScene& scene, const std::optional<MoverHandle>& hot) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t m = 0; m < scene.opened.show->movers.size(); ++m)
        if (is_on_its_way(scene, m)) paint_ghost(painter, scene, m);
    for_each_axis(scene, [&](const MoverHandle& handle, const scene::MoverAxis&) {
        paint_way(painter, scene, handle, hot == handle);
    });
    painter.restore();
}

} // namespace ghost::ui
