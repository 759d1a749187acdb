// SPDX-License-Identifier: Apache-2.0
#include "ui/model/look_fader.h"

#include "ui/model/look_fade.h"

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kFadeStep_ms = 33;

} // namespace

LookFader::LookFader(std::function<void()> step) {
    timer_.setInterval(kFadeStep_ms);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, std::move(step));
}

void LookFader::set_next(double seconds) {
    next_s_ = std::max(seconds, 0.0);
}

void LookFader::forget() {
    timer_.stop();
    shown_ = {};
}

void LookFader::change(const Look& before, const Look& after) {
    const double length_s = std::exchange(next_s_, 0.0);
    if (length_s > 0) {
        from_ = shown_; // an earlier fade may not be over
        length_s_ = length_s;
        clock_.start();
        timer_.start();
    } else if (is_going()) {
        keep_changes(from_, before, after);
    }
}

void LookFader::hurry(double seconds) {
    if (!is_going() || seconds >= length_s_ - static_cast<double>(clock_.elapsed()) * 1e-3) return;
    from_ = shown_;
    length_s_ = seconds;
    clock_.start();
    if (seconds <= 0) timer_.stop();
}

const Look& LookFader::on_the_way(const Look& meant, const scene::Show* show, const RigNow& now) {
    const double share = is_going() ? static_cast<double>(clock_.elapsed()) * 1e-3 / length_s_ : 1.0;
    if (share >= 1) timer_.stop();
    shown_ = share < 1 && show ? faded(from_, meant, *show, now, static_cast<float>(share)) : meant;
    return shown_;
}

} // namespace ghost::ui
