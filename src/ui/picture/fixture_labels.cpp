// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/fixture_labels.h"

#include <QFontMetricsF>

#include <algorithm>

namespace ghost::ui {

bool FixtureLabels::paint(const QPointF& lamp, const QStringList& lines, const QColor& colour) {
    constexpr double kOff_px = 14, kAround_px = 4;
    const QFontMetricsF metrics(painter_.font());
    double width = 0;
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    const QSizeF size(width + 2 * kAround_px, metrics.height() * static_cast<double>(lines.size()) + 2);
    // Above, below, right, left of the lamp.
    const QPointF corners[] = {{lamp.x() - size.width() / 2, lamp.y() - kOff_px - size.height()},
                               {lamp.x() - size.width() / 2, lamp.y() + kOff_px},
                               {lamp.x() + kOff_px, lamp.y() - size.height() / 2},
                               {lamp.x() - kOff_px - size.width(), lamp.y() - size.height() / 2}};
    for (const QPointF& corner : corners) {
        const QRectF box(corner, size);
        if (!widget_.contains(box) || std::any_of(taken_.begin(), taken_.end(),
                                                  [&](const QRectF& other) { return other.intersects(box); }))
            continue;
        taken_.push_back(box);
        painter_.fillRect(box, QColor(0, 0, 0, 150));
        painter_.setPen(colour);
        painter_.drawText(box, Qt::AlignCenter, lines.join('\n'));
        return true;
    }
    return false;
}

} // namespace ghost::ui
