#pragma once
// SPDX-License-Identifier: Apache-2.0
// SmallPicture: what a camera of the show sees now, small, beside the live picture and without changing it.
// G-buffer and relighter of its own, of one size. Main thread; the session must outlive it.

#include "image/image.h"
#include "live/session/session.h"

#include <functional>
#include <memory>
#include <optional>

namespace ghost::app {

class SmallPicture {
public:
    // Whether the device has room for one.
    static bool fits(const Session& session);
    SmallPicture(const Session& session, int width, int height);

    // From there, all of that camera's frame, lit as lit says (Session::lit). Nothing: stop ended it.
    std::optional<image::Image8> draw(const scene::Camera& camera, const scene::FrameLights& lit,
                                      double air_s, const std::function<bool()>& stop);
    // Of the picture that was drawn last.
    image::ImageF frame() const { return relighter_->frame(); } // cd/m^2, scene-linear
    float ev100_used() const { return relighter_->ev100_used(); }

private:
    const Session& session_;
    int width_, height_;
    render::GBuffer g_buffer_;
    std::unique_ptr<render::Relighter> relighter_; // reads it; made for the first picture
};

} // namespace ghost::app
