// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/overlays.h"

#include "link/picture_place.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/fixture_list.h"
#include "ui/picture/fixture_labels.h"
#include "ui/widgets/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ghost::ui {
namespace {

constexpr double kReach_px = 22;
constexpr float kAim_m = 4;
constexpr std::size_t kMostNamed = 40; // selected ones: of more there are rings alone
constexpr double kMuchFiner = 1.5;     // pixels of the picture to one of the display

QFont small_font(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.9);
    return font;
}

QString address_of(const scene::PatchedFixture& fixture) {
    return fixture.address > 0 ? address_words(fixture.universe, fixture.address)
                               : translated("Picture", "no address");
}

// Lines that are no longer than a person reads at a glance, but for single long words.
QStringList wrapped(const QString& words) {
    constexpr int kLetters = 48;
    QStringList lines{QString()};
    for (const QString& word : words.split(' ', Qt::SkipEmptyParts)) {
        QString& line = lines.back();
        if (!line.isEmpty() && line.size() + 1 + word.size() > kLetters)
            lines << word;
        else
            line += (line.isEmpty() ? "" : " ") + word;
    }
    return lines;
}

// What there is to be known of a fixture at a glance.
QStringList words_about(const scene::PatchedFixture& fixture, const FixtureNow& now, const QString& why) {
    QStringList lines{QString::fromStdString(fixture.name)};
    const QString type =
        fixture.type ? QString::fromStdString(fixture.type->name) : translated("Picture", "no type");
    lines << type + ", " + address_of(fixture);
    if (!why.isEmpty()) return lines + wrapped(why);
    lines << (now.candela > 0 ? QString("%1 cd").arg(static_cast<double>(now.candela), 0, 'f', 0)
                              : translated("Picture", "dark"));
    return lines;
}

// small: of many.
void paint_ring(QPainter& painter, const QPointF& lamp, const QColor& colour, bool small = false) {
    const double radius_px = small ? 4 : 10;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 160), small ? 2.5 : 4));
    painter.drawEllipse(lamp, radius_px, radius_px);
    painter.setPen(QPen(colour, small ? 1.2 : 2));
    painter.drawEllipse(lamp, radius_px, radius_px);
}

// Of a head that has no fixture file, so that it is seen where it hangs.
void paint_bodiless(QPainter& painter, const QPointF& at) {
    constexpr double kHalf_px = 4;
    painter.setPen(QPen(QColor(235, 235, 235, 200), 1));
    painter.setBrush(QColor(90, 90, 95, 160));
    painter.drawRect(QRectF(at.x() - kHalf_px, at.y() - kHalf_px, 2 * kHalf_px, 2 * kHalf_px));
}

void paint_aim(QPainter& painter, const QRectF& picture, const scene::Camera& camera, const FixtureNow& now,
               bool selected) {
    const auto lamp = to_widget(picture, camera, now.light_m),
               end = to_widget(picture, camera, now.light_m + kAim_m * now.direction);
    if (!lamp || !end) return;
    QColor colour =
        now.candela > 0 ? QColor::fromRgbF(now.colour.x, now.colour.y, now.colour.z) : QColor(130, 130, 130);
    colour.setAlpha(selected ? 230 : 150);
    painter.setPen(QPen(colour, selected ? 2.0 : 1.2, Qt::DashLine));
    painter.drawLine(*lamp, *end);
}

// A lamp that has words beside it.
struct Marked {
    int rank = 0; // the least first
    float away_m = 0;
    QPointF lamp;
    QStringList lines;
    QColor colour;
};

} // namespace

QRectF frame_rect(const QSizeF& widget, const glm::ivec2& frame) {
    const Rect at = place_of_frame(widget.width(), widget.height(), frame);
    return {at.x, at.y, at.width, at.height};
}

QRectF picture_rect(const QSizeF& widget, const scene::Camera& camera, const Framed& framed) {
    const Rect at = place_of_picture(widget.width(), widget.height(), {camera.width, camera.height}, framed);
    return {at.x, at.y, at.width, at.height};
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

void paint_fixtures(QPainter& painter, const SeenHeads& heads, const scene::Show& show,
                    const Hovered& hovered, const OverlayChoice& choice) {
    const auto& [picture, camera, rig, selection] = heads;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font(painter));
    const std::size_t count = std::min(rig.fixtures.size(), show.fixtures.size());
    const bool many = selection.size() > kMostNamed;
    const bool names_selection = choice.marks && !many;
    std::vector<Marked> marked;
    for (std::size_t i = 0; i < count; ++i) {
        const FixtureNow& now = rig.fixtures[i];
        const bool selected = selection.contains(i);
        const auto lamp = to_widget(picture, camera, now.light_m);
        if (!lamp) continue;
        if (choice.aims || (selected && names_selection)) paint_aim(painter, picture, camera, now, selected);
        if (!show.fixtures[i].type) paint_bodiless(painter, *lamp);
        if (selected && choice.marks)
            paint_ring(painter, *lamp, accent(), many);
        else if (hovered.fixture == i)
            paint_ring(painter, *lamp, QColor(225, 225, 225));
        QStringList lines;
        if (hovered.fixture == i)
            lines = words_about(show.fixtures[i], now, hovered.why);
        else if ((choice.names && !(selected && many)) || (selected && names_selection))
            lines << QString::fromStdString(show.fixtures[i].name);
        if (choice.addresses && hovered.fixture != i && !(selected && many))
            lines << address_of(show.fixtures[i]);
        if (lines.isEmpty()) continue;
        const int rank = hovered.fixture == i ? 0 : selected ? 1 : 2;
        marked.push_back({rank, glm::distance(now.light_m, camera.position_m), *lamp, lines,
                          selected ? accent() : QColor(225, 225, 225)});
    }
    std::stable_sort(marked.begin(), marked.end(), [](const Marked& a, const Marked& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.away_m < b.away_m;
    });
    FixtureLabels labels(painter, painter.window());
    for (const Marked& one : marked) labels.paint(one.lamp, one.lines, one.colour);
    painter.restore();
}

void paint_moved(QPainter& painter, const SeenHeads& heads, const glm::vec3& by_m, const QPointF& mouse,
                 const QString& words) {
    const auto& [picture, camera, rig, selection] = heads;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font(painter));
    for (const std::size_t index : selection) {
        if (index >= rig.fixtures.size()) continue;
        const glm::vec3& at_m = rig.fixtures[index].light_m;
        const auto from = to_widget(picture, camera, at_m), to = to_widget(picture, camera, at_m + by_m);
        if (!from || !to) continue;
        painter.setPen(QPen(accent(), 1, Qt::DotLine));
        painter.drawLine(*from, *to);
        paint_ring(painter, *to, accent());
    }
    painter.restore();
    paint_words(painter, mouse, words);
}

void paint_words(QPainter& painter, const QPointF& beside, const QString& words) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font(painter));
    FixtureLabels(painter, painter.window()).paint(beside, {words}, accent());
    painter.restore();
}

void paint_handle(QPainter& painter, const QPointF& at) {
    constexpr double kArm_px = 11, kHead_px = 4;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& pen : {QPen(QColor(0, 0, 0, 180), 4), QPen(accent(), 1.6)}) {
        painter.setPen(pen);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
            const QPointF end = at + kArm_px * way, side(kHead_px * way.y(), kHead_px * way.x());
            painter.drawLine(at, end);
            painter.drawLine(end, end - kHead_px * way + side);
            painter.drawLine(end, end - kHead_px * way - side);
        }
    }
    painter.restore();
}

void paint_object(QPainter& painter, const QRectF& picture, const scene::Camera& camera, const Object& object,
                  const glm::vec3& by_m) {
    const glm::vec3 centre_m = object.centre_m + by_m;
    const auto middle = to_widget(picture, camera, centre_m);
    if (!middle) return;
    // Its radius as seen: that of a point beside its middle, across the view.
    const glm::vec3 forward = glm::normalize(centre_m - camera.position_m);
    const glm::vec3 beside = glm::abs(forward.z) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 across = glm::normalize(glm::cross(forward, beside));
    const auto edge = to_widget(picture, camera, centre_m + object.radius_m * across);
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
    FixtureLabels(painter, painter.window()).paint(*middle, {QString::fromStdString(object.name)}, accent());
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
