// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/timecode.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace ghost::dmx {

namespace {

constexpr int kNumbers[] = {24, 25, 30, 30}; // of frames in a second, by rate
constexpr int kTenMinutes = 17982;           // frames of drop frame

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

int frame_of_day(const TimeCode& time) {
    const int minutes = time.hours * 60 + time.minutes;
    const int all =
        (minutes * 60 + time.seconds) * kNumbers[static_cast<std::size_t>(time.rate)] + time.frames;
    return time.rate == TimeCode::Rate::drop_29_97 ? all - 2 * (minutes - minutes / 10) : all;
}

} // namespace

double frame_seconds(TimeCode::Rate rate) {
    return 1.0 / frames_per_s(rate);
}

bool is_timecode(const TimeCode& time) {
    const auto rate = static_cast<std::size_t>(time.rate);
    return rate < std::size(kNumbers) && time.frames < kNumbers[rate] && time.seconds < 60 &&
           time.minutes < 60 && time.hours < 24;
}

double timecode_seconds(const TimeCode& time) {
    return frame_of_day(time) / frames_per_s(time.rate);
}

TimeCode plus_frames(const TimeCode& time, int frames) {
    const int numbers = kNumbers[static_cast<std::size_t>(time.rate)];
    const bool drop = time.rate == TimeCode::Rate::drop_29_97;
    const int day = drop ? 144 * kTenMinutes : 86400 * numbers;
    int frame = (frame_of_day(time) + frames % day + day) % day;
    if (drop) { // the numbers that were left out come back in
        const int in_ten = frame % kTenMinutes;
        frame += 18 * (frame / kTenMinutes) + (in_ten >= 1800 ? 2 * ((in_ten - 1800) / 1798 + 1) : 0);
    }
    TimeCode result = time;
    const auto part = [](int value, int limit) { return static_cast<std::uint8_t>(value % limit); };
    result.frames = part(frame, numbers);
    result.seconds = part(frame / numbers, 60);
    result.minutes = part(frame / numbers / 60, 60);
    result.hours = part(frame / numbers / 3600, 24);
    return result;
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

} // namespace ghost::dmx
