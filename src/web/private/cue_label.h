#pragma once
// SPDX-License-Identifier: Apache-2.0
// CueLabel: the cue that a show is in, as far as anybody knows: the one that was called last, until the
// recording is behind another one; without a call the one that the recording came by. A cue with a look
// counts when it is called alone, for a recording that comes by recalls no look. Seconds. The server's
// thread.

#include "show/show.h"

#include <optional>
#include <string>

namespace ghost::web {

class CueLabel {
public:
    // "": none was.
    void call(const std::string& name, double now_s);
    // recording_s: none where the lamps do not follow one.
    std::string name(const scene::Show& show, std::optional<double> recording_s, double now_s);

private:
    std::string called_;
    double called_s_ = 0; // by the clock
    std::optional<std::string>
        then_; // what the recording had come by when the cue was called; none: not looked at yet
};

} // namespace ghost::web
