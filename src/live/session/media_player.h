#pragma once
// SPDX-License-Identifier: Apache-2.0
// MediaPlayer: the moving pictures of a show: a source for each [[media]], and what they show put where the
// lights and the relighter find it. Main thread; the workers of the sources end with it.

#include "base/report.h"
#include "light/gobos.h"
#include "video/source.h"

#include <memory>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::app {

class MediaPlayer {
public:
    // Opens all of them in the background; stack gets a black picture for each.
    MediaPlayer(const scene::Show& show, scene::GoboStack& stack);

    // The pictures of this moment. waits: until they are the right ones (at most some seconds each), else
    // what there is. What went wrong with a source goes to the report.
    void show(double time_s, bool waits, scene::GoboStack& stack, Report& report);

    // Of the films, the largest time since the picture that is shown was due; below a film's own time between
    // two pictures it is the newest there is.
    double behind_s(double time_s) const { return time_s - oldest_due_s_; }

private:
    double oldest_due_s_ = 0;
    std::vector<std::unique_ptr<video::Source>> sources_;
    std::vector<std::string> where_; // file:line of each
};

// Opens each film and picture that is there and says what shows from its start on would say, once. Any
// thread.
void check_media(const scene::Show& show, Report& report);

} // namespace ghost::app
