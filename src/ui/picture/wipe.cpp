// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/wipe.h"

#include "ui/language/language.h"
#include "ui/picture/overlays.h"
#include "ui/widgets/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr double kWipeReach_px = 6;

void paint_side(QPainter& painter, const QString& word, double from_x, double room) {
    const QFontMetricsF metrics(painter.font());
    const double width = metrics.horizontalAdvance(word) + 12;
    if (room < width + 8) return;
    const QRectF box(from_x, 8, width, metrics.height() + 4);
    painter.fillRect(box, QColor(0, 0, 0, 150));
    painter.setPen(QColor(225, 225, 225));
    painter.drawText(box, Qt::AlignCenter, word);
}

} // namespace

void Wipe::set_share(double share) {
    share_ = std::clamp(share, 0.0, 1.0);
}

bool Wipe::is_near(const QSizeF& widget, double x) const {
    return before_ && std::abs(x - share_ * widget.width()) <= kWipeReach_px;
}

void Wipe::paint(QPainter& painter, const QSizeF& widget) const {
    if (!before_) return;
    const double x = std::round(share_ * widget.width());
    painter.save();
    painter.setClipRect(QRectF(0, 0, x, widget.height()));
    const QRectF place = picture_rect(widget, before_->camera, before_->framed);
    if (!place.adjusted(-1, -1, 1, 1).contains(QRectF(QPointF(0, 0), widget)))
        painter.fillRect(QRectF(QPointF(0, 0), widget), Qt::black);
    paint_picture(painter, place, *before_->image);
    painter.restore();
    painter.save();
    painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
    painter.drawLine(QPointF(x, 0), QPointF(x, widget.height()));
    painter.setPen(QPen(accent(), 2));
    painter.drawLine(QPointF(x, 0), QPointF(x, widget.height()));
    paint_side(painter, translated("Picture", "before"), 8, x);
    paint_side(painter, translated("Picture", "now"), x + 8, widget.width() - x);
    painter.restore();
}

} // namespace ghost::ui
