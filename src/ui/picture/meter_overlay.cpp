// SPDX-License-Identifier: Apache-2.0
// The overlays that show figures of light: the legend of false colours, and the probe.
#include "ui/language/language.h"
#include "ui/picture/overlays.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr double kBar_px = 14; // its width; the height is in lines of text
constexpr int kBarLines = 12;

const QColor kGround(0, 0, 0, 190);

} // namespace

QString meter_text(float value) {
    const double shown = static_cast<double>(value);
    if (!(shown > 0)) return "0";
    const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(shown))), 0, 4);
    return QString::number(shown, 'f', digits);
}

void paint_legend(QPainter& painter, const QSizeF& widget, const FalseColour& colours) {
    const QFontMetricsF metrics(painter.font());
    const double line = metrics.height();
    const QString title = colours.measure == Measure::lux ? "lux" : "cd/m²";
    const image::Scale& scale = colours.scale;
    QStringList texts;
    std::vector<double> places;
    // 1, 2 and 5 of each decade; where that is too many, 1 alone.
    const double decades = std::log10(static_cast<double>(scale.high / scale.low));
    for (int power = static_cast<int>(std::floor(std::log10(static_cast<double>(scale.low))));
         power <= static_cast<int>(std::ceil(std::log10(static_cast<double>(scale.high)))); ++power)
        for (const double step : {1.0, 2.0, 5.0}) {
            if (step > 1 && 3 * decades > kBarLines - 1) continue;
            const double value = step * std::pow(10.0, power);
            const double place = static_cast<double>(image::place_on(scale, static_cast<float>(value)));
            if (place < -1e-3 || place > 1 + 1e-3) continue;
            texts << QString::number(value);
            places.push_back(place);
        }
    double text_width = metrics.horizontalAdvance(title);
    for (const QString& text : texts) text_width = std::max(text_width, metrics.horizontalAdvance(text));
    const double height = kBarLines * line, pad = 8;
    const QRectF box(widget.width() - text_width - kBar_px - 4 * pad,
                     widget.height() - height - 2.6 * line - pad, text_width + kBar_px + 3 * pad,
                     height + 2.6 * line);
    painter.fillRect(box, kGround);
    painter.setPen(Qt::white);
    painter.drawText(QPointF(box.left() + pad, box.top() + line), title);
    const QRectF bar(box.left() + pad, box.top() + 1.8 * line, kBar_px, height);
    const int rows = static_cast<int>(height);
    for (int row = 0; row < rows; ++row) {
        const float share = 1.0f - (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
        const image::Rgb8 colour =
            image::false_colour(scale, scale.low * std::pow(scale.high / scale.low, share));
        painter.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1),
                         QColor(colour[0], colour[1], colour[2]));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double y = bar.bottom() - places[i] * bar.height();
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3, y));
        painter.drawText(QPointF(bar.right() + pad, y + 0.35 * line), texts[static_cast<int>(i)]);
    }
}

void paint_probe(QPainter& painter, const QRectF& picture, const QSizeF& widget, const Probed& probed) {
    const QPointF at(picture.left() + static_cast<double>(probed.place.x) * picture.width(),
                     picture.top() + static_cast<double>(probed.place.y) * picture.height());
    painter.setPen(QPen(Qt::black, 3));
    for (const QColor& colour : {QColor(Qt::black), QColor(Qt::white)}) {
        painter.setPen(QPen(colour, colour == QColor(Qt::black) ? 3 : 1));
        painter.drawLine(at - QPointF(8, 0), at + QPointF(8, 0));
        painter.drawLine(at - QPointF(0, 8), at + QPointF(0, 8));
    }
    QStringList lines{meter_text(probed.cd_m2) + " cd/m²"};
    if (probed.hit)
        lines << (probed.bounced_lux ? translated("Picture", "%1 lx, of which %2 bounced")
                                           .arg(meter_text(probed.lux), meter_text(*probed.bounced_lux))
                                     : meter_text(probed.lux) + " lx")
              << translated("Picture", "%1, %2 m away")
                     .arg(QString::fromStdString(probed.object))
                     .arg(static_cast<double>(probed.distance_m), 0, 'f', 1);
    else
        lines << translated("Picture", "no surface");
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(at + QPointF(14, 14),
               QSizeF(width + 12, metrics.height() * static_cast<double>(lines.size()) + 8));
    // Beside the mouse, but inside.
    if (box.right() > widget.width()) box.moveRight(at.x() - 14);
    if (box.bottom() > widget.height()) box.moveBottom(at.y() - 14);
    painter.fillRect(box, kGround);
    painter.setPen(Qt::white);
    for (int i = 0; i < lines.size(); ++i)
        painter.drawText(QPointF(box.left() + 6, box.top() + 4 + metrics.height() * i + metrics.ascent()),
                         lines[i]);
}

} // namespace ghost::ui
