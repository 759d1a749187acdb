// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/waveform.h"

#include "ui/language/language.h"
#include "ui/widgets/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr int kHeight_px = 30;
constexpr double kShortestLoop_s = 0.2;

} // namespace

Waveform::Waveform(AppModel& app, QWidget* parent) : QWidget(parent), app_(app) {
    setMinimumSize(80, kHeight_px);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(
        translated("Transport", "The recording: how much changes when, and where it is played"));
    setToolTip(translated(
        "Transport", "Click: go there. Shift+drag: play this part again and again, Shift+click: the whole."));
    for (const auto signal : {&AppModel::rig_came, &AppModel::request_changed, &AppModel::waveform_came})
        connect(&app_, signal, this, qOverload<>(&QWidget::update));
}

QSize Waveform::sizeHint() const {
    return {400, kHeight_px};
}

double Waveform::second_at(double x) const {
    return std::clamp(x / std::max(width(), 1), 0.0, 1.0) * app_.rig().recording_s;
}

double Waveform::x_of(double second) const {
    return second / std::max(app_.rig().recording_s, 1e-3) * width();
}

void Waveform::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(18, 18, 20));
    if (app_.rig().recording_s <= 0) return;
    const Transport& transport = app_.request().transport;
    const bool loops = transport.loop_to_s > transport.loop_from_s;
    const double from = loops ? x_of(transport.loop_from_s) : 0,
                 to = loops ? x_of(transport.loop_to_s) : width();
    if (loops) painter.fillRect(QRectF(from, 0, to - from, height()), QColor(255, 179, 71, 40));
    const std::vector<float>& activity = app_.waveform();
    const double at = x_of(app_.moment_s());
    const bool is_shown = !app_.rig().from_desk;
    for (int x = 0; x < width() && !activity.empty(); ++x) {
        // The most of all parts that this pixel stands for.
        const auto count = static_cast<double>(activity.size());
        const auto first = static_cast<std::size_t>(x * count / width());
        const auto last = std::min(static_cast<std::size_t>((x + 1) * count / width()), activity.size() - 1);
        const float most = *std::max_element(activity.begin() + static_cast<std::ptrdiff_t>(first),
                                             activity.begin() + static_cast<std::ptrdiff_t>(last) + 1);
        // Small changes are seen beside large ones.
        const double part = 0.5 * (height() - 4) * std::sqrt(static_cast<double>(most));
        const bool inside = x >= from && x <= to;
        painter.setPen(!is_shown || !inside ? QColor(70, 70, 74)
                       : x <= at            ? accent()
                                            : QColor(140, 140, 146));
        painter.drawLine(QPointF(x, 0.5 * height() - part), QPointF(x, 0.5 * height() + part));
    }
    painter.setPen(is_shown ? QColor(Qt::white) : faint());
    painter.drawLine(QPointF(at, 0), QPointF(at, height()));
}

void Waveform::seek(double second) {
    app_.change_request([&](ViewRequest& request) {
        ++request.transport.seeks;
        request.transport.at_s = second;
    });
}

void Waveform::loop_to(double second) {
    const double from_s = std::min(mark_from_s_, second), to_s = std::max(mark_from_s_, second);
    const bool is_part = to_s - from_s >= kShortestLoop_s;
    app_.change_request([&](ViewRequest& request) {
        request.transport.loop_from_s = is_part ? from_s : 0;
        request.transport.loop_to_s = is_part ? to_s : 0;
    });
}

void Waveform::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    marks_ = event->modifiers() & Qt::ShiftModifier;
    mark_from_s_ = second_at(event->position().x());
    if (!marks_) seek(mark_from_s_);
}

void Waveform::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton)) return;
    if (marks_)
        loop_to(second_at(event->position().x()));
    else
        seek(second_at(event->position().x()));
}

void Waveform::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if (marks_) loop_to(second_at(event->position().x()));
    marks_ = false;
}

} // namespace ghost::ui
