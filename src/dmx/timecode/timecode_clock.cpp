// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/timecode_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::dmx {
namespace {

constexpr double kLongestStep_s = 0.5; // more is a jump
constexpr int kLockFrames = 3;
constexpr double kTwice = 0.9;       // times a frame: the same again so soon says nothing new
constexpr double kLate = 2.5;        // times a frame: then none comes any more
constexpr double kLeastLate_s = 0.1; // a busy network is no drop-out
constexpr double kHeard_s = 1;       // where they do not follow each other
constexpr double kMeasured_s = 1;    // over which the speed is measured
constexpr double kNominal = 0.02;    // so near to 1 what differs is the network's
constexpr double kSlowest = 0.05, kFastest = 4;

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

std::string chase_text(const ChaseStatus& status) {
    char text[96] = "";
    switch (status.state) {
    case ChaseStatus::State::waits:
        return "no time code yet";
    case ChaseStatus::State::runs:
        return {};
    case ChaseStatus::State::stands:
        return "time code stands";
    case ChaseStatus::State::freewheels:
        std::snprintf(text, sizeof text, "time code freewheels since %.1f s", status.since_s);
        break;
    case ChaseStatus::State::dropped_out:
        std::snprintf(text, sizeof text, "time code dropped out %.0f s ago", std::floor(status.since_s));
        break;
    }
    return text;
}

bool TimeCodeClock::is_locked() const {
    return in_a_row_ >= kLockFrames;
}

double TimeCodeClock::age_s(std::chrono::nanoseconds now) const {
    return std::max(0.0, seconds(now - arrival_));
}

void TimeCodeClock::feed(const TimeCode& time, std::chrono::nanoseconds arrival) {
    const double now_s = timecode_seconds(time), frame_s = frame_seconds(time.rate);
    const double step_s = now_s - last_s_;
    if (heard_ && step_s == 0 && age_s(arrival) < kTwice * frame_s) return; // sent more than once
    const bool follows = heard_ && std::abs(step_s) <= kLongestStep_s;
    const bool goes_on = follows && step_s * step_s_ > 0;
    step_s_ = follows ? step_s : frame_s; // it may have begun to run; one frame at most is wrong
    in_a_row_ = goes_on ? std::min(in_a_row_ + 1, kLockFrames) : (step_s_ != 0 ? 1 : 0);
    const double measured_s = seconds(arrival - measured_since_);
    if (!is_locked()) speed_ = 1;
    if (is_locked() && measured_s >= kMeasured_s) {
        const double speed = std::abs(now_s - measured_from_s_) / measured_s;
        speed_ = std::abs(speed - 1) < kNominal ? 1 : std::clamp(speed, kSlowest, kFastest);
    }
    if (!is_locked() || measured_s >= kMeasured_s) {
        measured_from_s_ = now_s;
        measured_since_ = arrival;
    }
    heard_ = true;
    last_s_ = now_s;
    arrival_ = arrival;
}

std::optional<double> TimeCodeClock::at_s(std::chrono::nanoseconds now) const {
    if (!heard_) return std::nullopt;
    const double most_s =
        is_locked() ? std::max(speed_ * freewheel_s_, std::abs(step_s_)) : std::abs(step_s_);
    const double on_s = std::min(speed_ * age_s(now), most_s);
    return last_s_ + (step_s_ < 0 ? -on_s : on_s);
}

ChaseStatus TimeCodeClock::status(std::chrono::nanoseconds now) const {
    using State = ChaseStatus::State;
    if (!heard_) return {};
    const double age = age_s(now);
    if (!is_locked()) return {age <= kHeard_s ? State::stands : State::dropped_out, age};
    if (age <= std::max(kLate * std::abs(step_s_) / speed_, kLeastLate_s)) return {State::runs, age};
    return {age <= freewheel_s_ ? State::freewheels : State::dropped_out, age};
}

} // namespace ghost::dmx
