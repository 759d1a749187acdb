// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/timecode_input.h"

#include <algorithm>
#include <chrono>

namespace ghost::app {

void TimeCodeInput::listen(dmx::ReceiverOptions& options) {
    options.on_timecode = [this](const dmx::TimeCode& time, std::chrono::nanoseconds arrival) {
        if (time.stream == 0) time_.feed(time, arrival);
    };
}

std::optional<double> TimeCodeInput::at_s(double end_s) const {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    const auto time_s = time_.clock().at_s(now);
    if (!time_s) return std::nullopt;
    return std::clamp(*time_s - begin_s_, 0.0, end_s);
}

Result<std::unique_ptr<TimeCodeInput>> open_timecode(const std::string& text) {
    if (text.empty()) return std::unique_ptr<TimeCodeInput>();
    const auto begin_s = dmx::parse_timecode(text);
    if (!begin_s.ok()) return Error{begin_s.error().what, "--timecode"};
    return std::make_unique<TimeCodeInput>(*begin_s);
}

} // namespace ghost::app
