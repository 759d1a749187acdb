// SPDX-License-Identifier: Apache-2.0
#include "ui/model/figures.h"

#include "ui/language/language.h"

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr int kCounted_ms = 1000;
constexpr double kLate = 2.5; // frames' time without a picture, after which none is on its way

} // namespace

void Figures::count_picture() {
    draws_.add(std::chrono::nanoseconds(std::llround(1e6 * app_.picture().draw_ms)));
    // What lay between a rest and this picture is no time that a picture took.
    if (!since_count_.isValid() || since_picture_.elapsed() >= rest_ms()) {
        since_count_.start();
        count_ = 0;
        rate_hz_ = 0;
    } else {
        ++count_;
    }
    since_picture_.start();
    if (count_ == 0 || since_count_.elapsed() < kCounted_ms) return;
    rate_hz_ = 1000.0 * count_ / static_cast<double>(since_count_.restart());
    count_ = 0;
}

void Figures::take_latency(std::chrono::nanoseconds latency) {
    latency_ms_ = std::chrono::duration<double, std::milli>(latency).count();
}

int Figures::rest_ms() const {
    return std::max(kCounted_ms, static_cast<int>(kLate * app_.picture().draw_ms));
}

QStringList Figures::lines() const {
    const Picture& picture = app_.picture();
    QStringList lines;
    const bool rests = since_picture_.isValid() && since_picture_.elapsed() >= rest_ms();
    const QString pace = rests          ? translated("Figures", "at rest, drawn in %1 ms")
                         : rate_hz_ > 0 ? translated("Figures", "%1 ms a frame, %2 pictures/s")
                                        : translated("Figures", "%1 ms a frame");
    QString frame = pace.arg(picture.draw_ms, 0, 'f', 1);
    if (!rests && rate_hz_ > 0) frame = frame.arg(rate_hz_, 0, 'f', 1);
    frame += QString(", %1x%2").arg(picture.camera.width).arg(picture.camera.height);
    if (picture.is_coarse) frame = translated("Figures", "%1 while it moves").arg(frame);
    lines << frame;
    if (app_.request().tone != image::Tone::agx)
        lines << translated("Figures", "tone curve %1")
                     .arg(QString::fromStdString(image::name_of(app_.request().tone)));
    const dmx::Latency &latency = app_.latency(), &cost = app_.window_cost();
    if (app_.request().frozen)
        lines << translated("Figures", "packet to window: frozen, what a desk sends waits");
    else if (latency_ms_ >= 0)
        lines << translated("Figures", "packet to window %1 ms (half within %2, 99 % within %3)")
                     .arg(latency_ms_, 0, 'f', 0)
                     .arg(latency.percentile_ms(0.5), 0, 'f', 0)
                     .arg(latency.percentile_ms(0.99), 0, 'f', 0);
    if (cost.count() > 0)
        lines << translated("Figures", "the window itself %1 ms a picture (99 % within %2)")
                     .arg(cost.percentile_ms(0.5), 0, 'f', 1)
                     .arg(cost.percentile_ms(0.99), 0, 'f', 1);
    if (!picture.supply.empty()) lines << said(picture.supply);
    return lines;
}

} // namespace ghost::ui
