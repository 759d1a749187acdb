#pragma once
// SPDX-License-Identifier: Apache-2.0
// Time code as a clock: where a show stands, between the packets that say so. Seconds; calls get the time of
// a steady clock. TimeCodeClock: one thread; SharedTimeCode: any.

#include "dmx/wire/timecode.h"

#include <chrono>
#include <mutex>
#include <optional>

namespace ghost::dmx {

// Runs on from the last packet, but not further than the next one should bring it: when the packets stop or
// repeat themselves, it stands; when they jump, it jumps.
class TimeCodeClock {
public:
    void feed(const TimeCode& time, std::chrono::nanoseconds arrival);
    // Nothing before the first packet.
    std::optional<double> at_s(std::chrono::nanoseconds now) const;
    // A packet came in the last second.
    bool is_heard(std::chrono::nanoseconds now) const;

private:
    bool heard_ = false;
    double last_s_ = 0; // of the newest packet
    double step_s_ = 0; // by which packets go on, negative backwards; 0: it stands
    std::chrono::nanoseconds arrival_{0};
};

// Fed by the receiver's thread, read by others.
class SharedTimeCode {
public:
    void feed(const TimeCode& time, std::chrono::nanoseconds arrival) {
        const std::lock_guard lock(mutex_);
        clock_.feed(time, arrival);
    }
    TimeCodeClock clock() const {
        const std::lock_guard lock(mutex_);
        return clock_;
    }

private:
    mutable std::mutex mutex_;
    TimeCodeClock clock_;
};

} // namespace ghost::dmx
