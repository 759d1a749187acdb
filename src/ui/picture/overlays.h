#pragma once
// SPDX-License-Identifier: Apache-2.0
// Overlays: what is painted above the picture: marks of the fixtures, names, addresses, aiming lines,
// figures. Pixels of the widget; stateless. Window thread.

#include "link/link.h"

#include <QPainter>
#include <QRectF>
#include <QString>

#include <optional>
#include <set>

namespace ghost::ui {

inline constexpr int kResizeRest_ms = 150; // of a window that is being resized

struct OverlayChoice {
    bool chips = true;    // what somebody must know to believe the picture
    bool figures = false; // frame time, latency, what is shown
    bool names = false;
    bool addresses = false;
    bool aims = false;  // a line from each lamp along its beam
    bool marks = true;  // of what is selected
    bool movers = true; // their ways, and where they go
    bool frame = true;  // of the camera, where the picture shows more
    bool probe = false; // cd/m^2 and lux of what is under the mouse
    bool operator==(const OverlayChoice&) const = default;
};

// Where a frame lies in the widget: in its middle, as large as all of it fits. Without pixels: all of it.
QRectF frame_rect(const QSizeF& widget, const glm::ivec2& frame);
// Where the picture lies in the widget: so that its frame lies there, all of it.
QRectF picture_rect(const QSizeF& widget, const scene::Camera& camera, const Framed& framed = {});
// Smoothly scaled to the pixels of the display, whichever has more.
void paint_picture(QPainter& painter, const QRectF& place, const image::Image8& picture);
// Nothing where the frame is the picture.
void paint_frame(QPainter& painter, const QRectF& picture, const QRectF& frame);
// Nothing: behind the camera.
std::optional<QPointF> to_widget(const QRectF& picture, const scene::Camera& camera, const glm::vec3& at_m);
// The fixture whose lamp is nearest to that place, within reach of a finger.
std::optional<std::size_t> fixture_at(const QRectF& picture, const scene::Camera& camera, const RigNow& rig,
                                      const QPointF& place);
std::set<std::size_t> fixtures_in(const QRectF& picture, const scene::Camera& camera, const RigNow& rig,
                                  const QRectF& box);

// What the mouse points at, and why it shines or not; empty: that comes.
struct Hovered {
    std::optional<std::size_t> fixture;
    QString why;
};
// The heads as they are seen, wherever the picture lies in the widget.
struct SeenHeads {
    const QRectF& picture;
    const scene::Camera& camera;
    const RigNow& rig;
    const std::set<std::size_t>& selection;
};
// Labels do not lie on each other; what is hovered has more words.
void paint_fixtures(QPainter& painter, const SeenHeads& heads, const scene::Show& show,
                    const Hovered& hovered, const OverlayChoice& choice);
// Where the selection would go, with words beside the mouse.
void paint_moved(QPainter& painter, const SeenHeads& heads, const glm::vec3& by_m, const QPointF& mouse,
                 const QString& words);
// A ring round an object, and its name; by_m: as far from where it stands.
void paint_object(QPainter& painter, const QRectF& picture, const scene::Camera& camera, const Object& object,
                  const glm::vec3& by_m);
// What an object is dragged by.
void paint_handle(QPainter& painter, const QPointF& at);
void paint_words(QPainter& painter, const QPointF& beside, const QString& words);
// Lines of text on a dark ground, in the lower left corner. Returns the height that they take.
double paint_figures(QPainter& painter, const QSizeF& widget, const QStringList& lines);
// What the colours of the picture mean, in the lower right corner.
void paint_legend(QPainter& painter, const QSizeF& widget, const FalseColour& colours);
// A cross where it was measured, its figures beside it.
void paint_probe(QPainter& painter, const QRectF& picture, const QSizeF& widget, const Probed& probed);
// "0.35", "12.4", "1230": as many digits as a meter has.
QString meter_text(float value);
// One sentence in the middle, for a picture that is not there.
void paint_notice(QPainter& painter, const QSizeF& widget, const QString& title, const QString& text);

} // namespace ghost::ui
