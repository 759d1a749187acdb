#pragma once
// SPDX-License-Identifier: Apache-2.0
// Marks of the show's movers in the picture: the way of each axis with its end stops, a handle to drag it by,
// and the outline of what a mover carries where it goes. World metres, pixels of the widget; pure. Window
// thread.

#include "link/link.h"

#include <QPainter>
#include <QRectF>

#include <cstddef>
#include <optional>
#include <vector>

namespace ghost::ui {

struct MoverScene {
    const Opened& opened;
    const RigNow& rig;
    const QRectF& picture;
    const scene::Camera& camera;
};

struct MoverHandle {
    std::size_t mover = 0, axis = 0;
    bool operator==(const MoverHandle&) const = default;
};

// From where the model has what a mover carries to where it is now; of scene::kNoMover: none.
glm::mat4 moved_now(const MoverScene& scene, int mover);
// An object, of Opened::objects, where it is now.
Object object_now(const MoverScene& scene, std::size_t object);

// What an axis is dragged by, where it is for that value of the axis; all else as it is now.
glm::vec3 handle_at_m(const MoverScene& scene, const MoverHandle& handle, float value);
// The one that the mouse is on.
std::optional<MoverHandle> handle_at(const MoverScene& scene, const QPointF& place);
// The value of its axis that has the handle nearest to the mouse, between its end stops. near: the value
// before, for a disc may go round more than once.
float dragged_value(const MoverScene& scene, const MoverHandle& handle, const QPointF& place, float near);
// "-2.35 m of -4.00 to 0.00".
QString value_words(const scene::Show& show, const MoverHandle& handle, float value);
// hot: has the mouse, and words for its end stops.
void paint_movers(QPainter& painter, const MoverScene& scene, const std::optional<MoverHandle>& hot);

} // namespace ghost::ui
