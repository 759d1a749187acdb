// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/part.h"

#include <algorithm>
#include <cmath>

namespace ghost::dmx {

using std::chrono::microseconds;

microseconds Part::scaled(microseconds time) const {
    const microseconds since = std::max(time - options_.from, microseconds(0));
    if (options_.speed == 1.0) return since;
    return microseconds(std::llround(std::min(static_cast<double>(since.count()) / options_.speed,
                                              static_cast<double>(kLongestRecording.count()))));
}

Result<void> Part::hand_on_standing() {
    for (auto& [universe, frame] : standing_) {
        frame.time = microseconds(0);
        TRY_VOID(sink_(frame));
    }
    standing_.clear();
    return {};
}

Result<void> Part::take(const RecordedFrame& frame) {
    if (frame.time < options_.from) {
        standing_[frame.universe] = frame;
        return {};
    }
    over_ = over_ || frame.time > options_.until;
    if (over_) return {};
    TRY_VOID(hand_on_standing());
    RecordedFrame moved = frame;
    moved.time = scaled(frame.time);
    return sink_(moved);
}

Result<microseconds> Part::finish(microseconds whole) {
    TRY_VOID(hand_on_standing());
    return scaled(std::min(options_.until, whole));
}

} // namespace ghost::dmx
