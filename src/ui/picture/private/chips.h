#pragma once
// SPDX-License-Identifier: Apache-2.0
// Chips: over the picture, in one row, what somebody who looks at it must know to believe it: where the
// levels come from, the exposure, what is set by hand, and what keeps light away or adds some. Window thread.

#include "ui/model/app_model.h"

#include <QColor>
#include <QPainter>
#include <QString>
#include <vector>

namespace ghost::ui {

struct Chip {
    QString text;
    QColor ground;        // with dark letters; invalid: light letters on a dark ground
    bool is_loud = false; // larger: the show itself is not what is seen
};

std::vector<Chip> chips_of(const AppModel& app);
// In the lower left corner, lift_px above the edge.
void paint_chips(QPainter& painter, const QSizeF& widget, const std::vector<Chip>& chips, double lift_px);

} // namespace ghost::ui
