// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays.h"

#include "scene/camera_moves.h"
#include "ui/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr double kReach_px = 22;
constexpr float kAim_m = 4;
constexpr double kMuchFiner = 1.5; // pixels of the picture to one of the display

QFont small_font(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.9);
    return font;
}

QString address_of(const scene::PatchedFixture& fixture) {
    return fixture.address > 0 ? QString("%1.%2").arg(fixture.universe).arg(fixture.address)
                               : QString("no address");
}

void paint_label(QPainter& painter, const QPointF& lamp, const QStringList& lines, const QColor& colour) {
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    const double height = metrics.height() * static_cast<double>(lines.size());
    const QRectF box(lamp.x() - width / 2 - 4, lamp.y() - 12 - height - 2, width + 8, height + 2);
    painter.fillRect(box, QColor(0, 0, 0, 150));
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, lines.join('\n'));
}

} // namespace

QRectF frame_rect(const QSizeF& widget, const glm::ivec2& frame) {
    if (frame.x <= 0 || frame.y <= 0) return {QPointF(0, 0), widget};
    const double scale = std::min(widget.width() / frame.x, widget.height() / frame.y);
    const QSizeF size(scale * frame.x, scale * frame.y);
    return {{(widget.width() - size.width()) / 2, (widget.height() - size.height()) / 2}, size};
}

QRectF picture_rect(const QSizeF& widget, const scene::Camera& camera, const Framed& framed) {
    const glm::ivec2 size = glm::max(glm::ivec2(camera.width, camera.height), 1);
    if (framed.frame.x <= 0 || framed.frame.y <= 0) return frame_rect(widget, size);
    const QRectF frame = frame_rect(widget, framed.frame);
    const double height = frame.height() / static_cast<double>(framed.share);
    const QSizeF whole(height * size.x / size.y, height);
    return {frame.center() - QPointF(whole.width() / 2, whole.height() / 2), whole};
}

void paint_picture(QPainter& painter, const QRectF& place, const image::Image8& picture) {
    const QImage image(picture.samples.data(), picture.width, picture.height, 4 * picture.width,
                       QImage::Format_RGBX8888);
    const double ratio = painter.device()->devicePixelRatioF();
    const QSize pixels = (place.size() * ratio).toSize();
    const bool fits = pixels == image.size();
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !fits);
    // The painter's own scaling knows four neighbours and leaves out the others.
    const bool is_much_finer = !pixels.isEmpty() && image.width() > kMuchFiner * pixels.width();
    if (is_much_finer)
        painter.drawImage(place, image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    else if (fits)
        painter.drawImage(QRectF(place.topLeft().toPoint(), place.size()), image);
    else
        painter.drawImage(place, image);
    painter.restore();
}

void paint_frame(QPainter& painter, const QRectF& picture, const QRectF& frame) {
    constexpr double kSame_px = 1.5;
    if (std::abs(picture.width() - frame.width()) < kSame_px &&
        std::abs(picture.height() - frame.height()) < kSame_px)
        return;
    painter.save();
    painter.setBrush(Qt::NoBrush);
    // Seen on black and on white.
    painter.setPen(QPen(QColor(0, 0, 0, 120), 3));
    painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setPen(QPen(QColor(235, 235, 235, 150), 1));
    painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.restore();
}

std::optional<QPointF> to_widget(const QRectF& picture, const scene::Camera& camera, const glm::vec3& at_m) {
    const auto seen = scene::project(camera, at_m);
    if (!seen) return std::nullopt;
    return QPointF(picture.x() + picture.width() * static_cast<double>(seen->at.x),
                   picture.y() + picture.height() * static_cast<double>(seen->at.y));
}

std::optional<std::size_t> fixture_at(const QRectF& picture, const scene::Camera& camera, const RigNow& rig,
                                      const QPointF& place) {
    std::optional<std::size_t> nearest;
    double nearest_px = kReach_px;
    for (std::size_t i = 0; i < rig.fixtures.size(); ++i) {
        const auto at = to_widget(picture, camera, rig.fixtures[i].light_m);
        if (!at) continue;
        const double px = QLineF(*at, place).length();
        if (px >= nearest_px) continue;
        nearest_px = px;
        nearest = i;
    }
    return nearest;
}

std::set<std::size_t> fixtures_in(const QRectF& picture, const scene::Camera& camera, const RigNow& rig,
                                  const QRectF& box) {
    std::set<std::size_t> inside;
    for (std::size_t i = 0; i < rig.fixtures.size(); ++i)
        if (const auto at = to_widget(picture, camera, rig.fixtures[i].light_m); at && box.contains(*at))
            inside.insert(i);
    return inside;
}

void paint_fixtures(QPainter& painter, const QRectF& picture, const scene::Camera& camera,
                    const scene::Show& show, const RigNow& rig, const std::set<std::size_t>& selection,
                    const OverlayChoice& choice) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font(painter));
    const std::size_t count = std::min(rig.fixtures.size(), show.fixtures.size());
    for (std::size_t i = 0; i < count; ++i) {
        const FixtureNow& now = rig.fixtures[i];
        const bool selected = selection.contains(i);
        const auto lamp = to_widget(picture, camera, now.light_m);
        if (!lamp) continue;
        if (choice.aims || (selected && choice.marks)) {
            const auto end = to_widget(picture, camera, now.light_m + kAim_m * now.direction);
            QColor colour = now.candela > 0 ? QColor::fromRgbF(now.colour.x, now.colour.y, now.colour.z)
                                            : QColor(130, 130, 130);
            colour.setAlpha(selected ? 230 : 150);
            if (end) {
                painter.setPen(QPen(colour, selected ? 2.0 : 1.2, Qt::DashLine));
                painter.drawLine(*lamp, *end);
            }
        }
        if (selected && choice.marks) {
            painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
            painter.drawEllipse(*lamp, 10, 10);
            painter.setPen(QPen(accent(), 2));
            painter.drawEllipse(*lamp, 10, 10);
        }
        QStringList lines;
        if (choice.names || (selected && choice.marks))
            lines << QString::fromStdString(show.fixtures[i].name);
        if (choice.addresses) lines << address_of(show.fixtures[i]);
        if (!lines.isEmpty()) paint_label(painter, *lamp, lines, selected ? accent() : QColor(225, 225, 225));
    }
    painter.restore();
}

void paint_object(QPainter& painter, const QRectF& picture, const scene::Camera& camera,
                  const Object& object) {
    const auto middle = to_widget(picture, camera, object.centre_m);
    if (!middle) return;
    // Its radius as seen: that of a point beside its middle, across the view.
    const glm::vec3 forward = glm::normalize(object.centre_m - camera.position_m);
    const glm::vec3 beside = glm::abs(forward.z) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 across = glm::normalize(glm::cross(forward, beside));
    const auto edge = to_widget(picture, camera, object.centre_m + object.radius_m * across);
    if (!edge) return;
    const double radius = std::max(QLineF(*middle, *edge).length(), 10.0);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font(painter));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
    painter.drawEllipse(*middle, radius, radius);
    painter.setPen(QPen(accent(), 2, Qt::DashLine));
    painter.drawEllipse(*middle, radius, radius);
    paint_label(painter, *middle, {QString::fromStdString(object.name)}, accent());
    painter.restore();
}

double paint_figures(QPainter& painter, const QSizeF& widget, const QStringList& lines) {
    if (lines.isEmpty()) return 0;
    painter.save();
    painter.setFont(small_font(painter));
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    const double height = metrics.height() * static_cast<double>(lines.size());
    const QRectF box(8, widget.height() - height - 18, width + 16, height + 10);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(215, 215, 215));
    painter.drawText(box.adjusted(8, 5, -8, -5), Qt::AlignLeft | Qt::AlignVCenter, lines.join('\n'));
    painter.restore();
    return widget.height() - box.top() - 8;
}

void paint_notice(QPainter& painter, const QSizeF& widget, const QString& title, const QString& text) {
    painter.save();
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 1.7);
    painter.setFont(font);
    painter.setPen(QColor(225, 225, 225));
    const QRectF all(QPointF(0, 0), widget);
    const double half = widget.height() / 2;
    painter.drawText(all.adjusted(24, 0, -24, -half - 6),
                     Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, title);
    font.setPointSizeF(font.pointSizeF() / 1.55);
    painter.setFont(font);
    painter.setPen(QColor(165, 165, 165));
    painter.drawText(all.adjusted(24, half + 6, -24, 0), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                     text);
    painter.restore();
}

} // namespace ghost::ui
