#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixtureLabels: names beside lamps that do not lie on each other: who comes first has its place, who finds
// none near its lamp is left out. Pixels of the widget. Window thread.

#include <QPainter>
#include <QRectF>
#include <QStringList>

#include <vector>

namespace ghost::ui {

class FixtureLabels {
public:
    // Within widget, in the painter's font.
    FixtureLabels(QPainter& painter, const QRectF& widget) : painter_(painter), widget_(widget) {}
    // False: there was no room.
    bool paint(const QPointF& lamp, const QStringList& lines, const QColor& colour);

private:
    QPainter& painter_;
    QRectF widget_;
    std::vector<QRectF> taken_;
};

} // namespace ghost::ui
