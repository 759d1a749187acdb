#pragma once
// SPDX-License-Identifier: Apache-2.0
// Part: takes the frames of a whole recording and hands on those of a part of it: first the levels that stand
// when it begins, at time 0, then every frame up to its end, at the speed asked for. One thread.

#include "dmx/record/recorded_frame.h"

#include <map>

namespace ghost::dmx {

struct PartOptions {
    std::chrono::microseconds from{0};
    std::chrono::microseconds until = kLongestRecording; // with frames of that very time
    double speed = 1.0;                                  // 2: half as long
};

class Part {
public:
    Part(const PartOptions& options, FrameSink sink) : options_(options), sink_(std::move(sink)) {}

    // Error: the sink's.
    Result<void> take(const RecordedFrame& frame);
    // No later frame belongs to it.
    bool over() const { return over_; }
    // The levels that stand, where no frame came after; then its length. whole: duration of the recording.
    Result<std::chrono::microseconds> finish(std::chrono::microseconds whole);

private:
    std::chrono::microseconds scaled(std::chrono::microseconds time) const;
    Result<void> hand_on_standing();

    PartOptions options_;
    FrameSink sink_;
    std::map<std::uint16_t, RecordedFrame> standing_; // of before it begins, until it does
    bool over_ = false;
};

} // namespace ghost::dmx
