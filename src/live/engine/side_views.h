#pragma once
// SPDX-License-Identifier: Apache-2.0
// SideViews: pictures from other cameras than the window's, for browsers: two at most, each with a relighter
// of its own on the same device. They are drawn after the main picture, in a fifth of the time at most, and
// never while that is coarse. On a device that is a processor they are stills, and say so: drawn when the
// lamps rest, and smaller, in a twenty-fifth of the time, while they move. Seconds. Engine thread.

#include "link/link.h"
#include "live/engine/picture_probe.h"
#include "live/session/small_picture.h"

#include <array>
#include <functional>
#include <memory>

namespace ghost::app {

class SideViews {
public:
    explicit SideViews(ui::Link& link) : link_(link) {}

    struct Now {
        double now_s = 0;
        double changed_s = 0; // when the picture moved last
        double air_s = 0;
        bool rests = false;    // the lamps do, and the main picture is all that it can be
        bool is_whole = false; // it has all its pixels
    };
    // One at most. stop: something else is to be shown, where the lamps rest; where they move, the end.
    void draw(const Session& session, const scene::FrameLights& lit, const Now& now, PictureProbe& probe,
              const std::function<bool()>& stop);
    // The session is another one.
    void forget();

private:
    struct Side {
        ui::SideView view;
        bool is_wanted = false;
        std::unique_ptr<SmallPicture> small;
        ui::SidePicture drawn;    // number 0: none
        double of_changed_s = -1; // Now::changed_s then; -1: smaller than at rest, or none
    };
    void take_requests();
    SmallPicture* small_of(Side& side, const Session& session, bool is_hurried);
    ui::SideMeasure measure(const Side& side, SmallPicture& small, scene::Camera camera,
                            const Session& session, const scene::FrameLights& lit, PictureProbe& probe) const;
    void publish();

    ui::Link& link_;
    std::array<Side, ui::kMostSideViews> sides_;
    std::unique_ptr<SmallPicture> hurried_; // of all sides, while the lamps move
    std::size_t last_ = 0;                  // that was drawn
    double may_go_s_ = 0;
};

} // namespace ghost::app
