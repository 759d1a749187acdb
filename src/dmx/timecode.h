#pragma once
// SPDX-License-Identifier: Apache-2.0
// Time code as a clock: where a show stands, between the packets that say so. Seconds; calls get the time of
// a steady clock. TimeCodeClock: one thread; SharedTimeCode: any.

#include "base/result.h"
#include "dmx/packet.h"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace ghost::dmx {

// Since 00:00:00:00; drop frame (SMPTE 12M) counts 30000/1001 frames a second and leaves two numbers out in
// every minute but each tenth.
double timecode_seconds(const TimeCode& time);

// Its fields are those of a time of day.
bool is_timecode(const TimeCode& time);
// So many frames later, or earlier; round midnight.
TimeCode plus_frames(const TimeCode& time, int frames);

// "10:00:00:00", "10:00:00" or plain seconds; frames are 25 a second.
Result<double> parse_timecode(const std::string& text);

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
