// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/timecode_clock.h"

#include <algorithm>
#include <cmath>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

constexpr double kLongestStep_s = 0.5; // more is a jump
constexpr auto kHeard = 1s;

} // namespace

void TimeCodeClock::feed(const TimeCode& time, std::chrono::nanoseconds arrival) {
    const double now_s = timecode_seconds(time);
    const double step_s = now_s - last_s_;
    const double frame_s = frame_seconds(time.rate);
    if (!heard_ || std::abs(step_s) > kLongestStep_s)
        step_s_ = frame_s; // it may have begun to run; one frame at most is wrong
    else
        step_s_ = step_s;
    heard_ = true;
    last_s_ = now_s;
    arrival_ = arrival;
}

std::optional<double> TimeCodeClock::at_s(std::chrono::nanoseconds now) const {
    if (!heard_) return std::nullopt;
    const double age_s = std::max(0.0, std::chrono::duration<double>(now - arrival_).count());
    const double on_s = std::min(age_s, std::abs(step_s_));
    return last_s_ + (step_s_ < 0 ? -on_s : on_s);
}

bool TimeCodeClock::is_heard(std::chrono::nanoseconds now) const {
    return heard_ && now - arrival_ < kHeard;
}

} // namespace ghost::dmx
