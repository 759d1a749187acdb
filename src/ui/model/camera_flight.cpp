// SPDX-License-Identifier: Apache-2.0
#include "ui/model/camera_flight.h"

#include "show/camera_moves.h"

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kFlightStep_ms = 16;

} // namespace

CameraFlight::CameraFlight(std::function<void(const FramedCamera&)> step) : step_(std::move(step)) {
    timer_.setInterval(kFlightStep_ms);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { this->step(); });
}

void CameraFlight::begin(const FramedCamera& from, const FramedCamera& to, int length_ms) {
    from_ = from;
    to_ = to;
    length_ms_ = std::max(length_ms, 1);
    clock_.start();
    timer_.start();
}

void CameraFlight::set_exposure(float ev100, bool automatic) {
    for (FramedCamera* end : {&from_, &to_}) {
        end->camera.ev100 = ev100;
        end->camera.auto_exposure = automatic;
    }
}

void CameraFlight::step() {
    const float share = std::min(static_cast<float>(clock_.elapsed()) / static_cast<float>(length_ms_), 1.0f);
    if (share >= 1) {
        timer_.stop();
        step_(to_);
        return;
    }
    step_({scene::camera_between(from_.camera, to_.camera, share),
           glm::ivec2(glm::round(glm::mix(glm::vec2(from_.frame), glm::vec2(to_.frame), share)))});
}

} // namespace ghost::ui
