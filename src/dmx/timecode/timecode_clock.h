#pragma once
// SPDX-License-Identifier: Apache-2.0
// Time code as a clock: where a show stands, between the packets, quarter frames or LTC that say so. Seconds;
// calls get the time of a steady clock. TimeCodeClock: one thread; SharedTimeCode: any.

#include "dmx/wire/timecode.h"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace ghost::dmx {

inline constexpr double kFreewheel_s = 1;

// What a clock does, for people.
struct ChaseStatus {
    enum class State {
        waits,       // no time code yet
        runs,        // with the time code
        stands,      // the time code stands
        freewheels,  // none comes; it goes on by itself
        dropped_out, // none came for longer than that; it stands
    };
    State state = State::waits;
    double since_s = 0; // of the last time code
};
// "time code freewheels since 0.4 s"; "" while it runs.
std::string chase_text(const ChaseStatus& status);

// Jumps with the time code, backwards too; stands where it repeats itself. Where frames follow each other it
// is locked, and goes on at their speed for a time when they stop to come, as a desk does; not locked it goes
// no further than the next frame should bring it.
class TimeCodeClock {
public:
    explicit TimeCodeClock(double freewheel_s = kFreewheel_s) : freewheel_s_(freewheel_s) {}

    void feed(const TimeCode& time, std::chrono::nanoseconds arrival);
    // Nothing before the first time code.
    std::optional<double> at_s(std::chrono::nanoseconds now) const;
    ChaseStatus status(std::chrono::nanoseconds now) const;

private:
    bool is_locked() const;
    double age_s(std::chrono::nanoseconds now) const;

    double freewheel_s_;
    bool heard_ = false;
    double last_s_ = 0; // of the newest
    double step_s_ = 0; // by which they go on, negative backwards; 0: they stand
    int in_a_row_ = 0;  // frames that follow each other in one direction
    double speed_ = 1;  // seconds of time code a second, without its direction
    double measured_from_s_ = 0;
    std::chrono::nanoseconds measured_since_{0};
    std::chrono::nanoseconds arrival_{0};
};

// Fed by the thread that brings time code, read by others.
class SharedTimeCode {
public:
    explicit SharedTimeCode(double freewheel_s = kFreewheel_s) : clock_(freewheel_s) {}

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
