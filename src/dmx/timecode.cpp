// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;

constexpr double kLongestStep_s = 0.5; // more is a jump
constexpr auto kHeard = 1s;

double frames_per_s(TimeCode::Rate rate) {
    switch (rate) {
    case TimeCode::Rate::film_24:
        return 24.0;
    case TimeCode::Rate::ebu_25:
        return 25.0;
    case TimeCode::Rate::drop_29_97:
        return 30000.0 / 1001.0;
    case TimeCode::Rate::smpte_30:
        break;
    }
    return 30.0;
}

} // namespace

double timecode_seconds(const TimeCode& time) {
    const int whole_s = (time.hours * 60 + time.minutes) * 60 + time.seconds;
    const double per_s = frames_per_s(time.rate);
    if (time.rate != TimeCode::Rate::drop_29_97) return whole_s + time.frames / per_s;
    const int minutes = time.hours * 60 + time.minutes;
    return (30 * whole_s + time.frames - 2 * (minutes - minutes / 10)) / per_s;
}

Result<double> parse_timecode(const std::string& text) {
    int hours = 0, minutes = 0, seconds = 0, frames = 0;
    char end = 0;
    const int parts =
        std::sscanf(text.c_str(), "%2d:%2d:%2d:%2d%c", &hours, &minutes, &seconds, &frames, &end);
    const auto in = [](int value, int least, int most) { return value >= least && value <= most; };
    if ((parts == 3 || parts == 4) && in(hours, 0, 23) && in(minutes, 0, 59) && in(seconds, 0, 59) &&
        in(frames, 0, 24) && text.back() != ':')
        return (hours * 60 + minutes) * 60 + seconds + frames / 25.0;
    double plain_s = 0;
    if (std::sscanf(text.c_str(), "%lf%c", &plain_s, &end) == 1 && plain_s >= 0 && plain_s <= 86400)
        return plain_s;
    return Error{"'" + text + "', expected a time code like 10:00:00:00 (25 frames a second), or seconds",
                 ""};
}

void TimeCodeClock::feed(const TimeCode& time, std::chrono::nanoseconds arrival) {
    const double now_s = timecode_seconds(time);
    const double step_s = now_s - last_s_;
    const double frame_s = 1.0 / frames_per_s(time.rate);
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
