#pragma once
// SPDX-License-Identifier: Apache-2.0
// CameraFlight: a camera on its way to another, by the clock. Window thread.

#include "show/camera.h"

#include <QElapsedTimer>
#include <QTimer>

#include <functional>
#include <glm/glm.hpp>

namespace ghost::ui {

// frame: that a picture of its own size has, 0: none.
struct FramedCamera {
    scene::Camera camera;
    glm::ivec2 frame{0};
};

class CameraFlight {
public:
    // step: it is here now; of whatever size.
    explicit CameraFlight(std::function<void(const FramedCamera&)> step);

    void begin(const FramedCamera& from, const FramedCamera& to, int length_ms);
    void stop() { timer_.stop(); }
    bool is_going() const { return timer_.isActive(); }
    // Of both ends.
    void set_exposure(float ev100, bool automatic);

private:
    void step();

    std::function<void(const FramedCamera&)> step_;
    QTimer timer_;
    QElapsedTimer clock_;
    int length_ms_ = 1;
    FramedCamera from_, to_;
};

} // namespace ghost::ui
