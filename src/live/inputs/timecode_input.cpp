// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/timecode_input.h"

#include <algorithm>
#include <chrono>

namespace ghost::app {
namespace {

std::chrono::nanoseconds now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

} // namespace

void TimeCodeInput::listen(dmx::ReceiverOptions& options) {
    if (!ltc_name_.empty()) {
        ltc_ = std::make_unique<LtcInput>(
            ltc_name_,
            [this](const dmx::TimeCode& time, std::chrono::nanoseconds at) { time_.feed(time, at); });
        return;
    }
    options.on_timecode = [this](const dmx::TimeCode& time, std::chrono::nanoseconds arrival) {
        if (time.stream == 0) time_.feed(time, arrival);
    };
}

std::optional<double> TimeCodeInput::at_s(double end_s) const {
    const auto time_s = time_.clock().at_s(now());
    if (!time_s) return std::nullopt;
    return std::clamp(*time_s - begin_s_, 0.0, end_s);
}

dmx::ChaseStatus TimeCodeInput::status() const {
    return time_.clock().status(now());
}

Result<std::unique_ptr<TimeCodeInput>> open_timecode(const TimeCodeOptions& options) {
    if (options.begin.empty()) return std::unique_ptr<TimeCodeInput>();
    const auto begin_s = dmx::parse_timecode(options.begin);
    if (!begin_s.ok()) return Error{begin_s.error().what, "--timecode"};
    return std::make_unique<TimeCodeInput>(*begin_s, options);
}

} // namespace ghost::app
