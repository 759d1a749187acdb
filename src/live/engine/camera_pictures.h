#pragma once
// SPDX-License-Identifier: Apache-2.0
// CameraPictures: a small picture of each camera of the show, for the window's strip and for browsers: one
// after the other while the lamps rest, and again when they rest otherwise; rarely, and round and round, while
// they move. Seconds. Engine thread.

#include "link/link.h"
#include "live/session/small_picture.h"

#include <functional>
#include <memory>
#include <vector>

namespace ghost::app {

class CameraPictures {
public:
    explicit CameraPictures(ui::Link& link) : link_(link) {}

    struct Now {
        double now_s = 0;
        double changed_s = 0; // when the picture moved last
        double air_s = 0;
        bool moves = false; // the lamps do
    };
    // One at most, a second after the one before, or five while the lamps move. stop: something else is to be shown.
    void draw(const Session& session, const scene::FrameLights& lit, const Now& now,
              const std::function<bool()>& stop);
    // The session is another one.
    void forget();

private:
    ui::Link& link_;
    std::unique_ptr<SmallPicture> small_;
    std::vector<ui::NamedPicture> pictures_;
    std::size_t next_ = 0; // of the cameras whose pictures are of an earlier state
    double of_s_ = -1;     // Now::changed_s of those before it
    double made_s_ = -1;
};

} // namespace ghost::app
