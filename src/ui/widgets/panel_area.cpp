// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/panel_area.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>

#include <algorithm>

namespace ghost::ui {
namespace {

int least_height(const QWidget& panel, int width_px) {
    const QLayout* const layout = panel.layout();
    const int needs = layout && layout->hasHeightForWidth() ? layout->minimumHeightForWidth(width_px)
                                                            : panel.minimumSizeHint().height();
    return std::max(needs, panel.minimumHeight());
}

} // namespace

PanelArea::PanelArea(QWidget* panel, QWidget* parent) : QScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(panel);
}

QSize PanelArea::sizeHint() const {
    const int line_px = fontMetrics().height();
    return widget()->sizeHint().boundedTo(QSize(36 * line_px, 24 * line_px)); // as QScrollArea has it
}

bool PanelArea::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) fit();
    return QScrollArea::event(event);
}

void PanelArea::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    fit();
}

void PanelArea::fit() {
    QWidget& panel = *widget();
    const QSize room = maximumViewportSize();
    const int least_width = std::max(panel.minimumSizeHint().width(), panel.minimumWidth());
    int width = std::max(room.width(), least_width);
    int height = room.height() - (width > room.width() ? horizontalScrollBar()->sizeHint().height() : 0);
    if (least_height(panel, width) > height) {
        width = std::max(room.width() - verticalScrollBar()->sizeHint().width(), least_width);
        height = least_height(panel, width);
    }
    panel.resize(width, height);
}

} // namespace ghost::ui
