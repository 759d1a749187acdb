#pragma once
// SPDX-License-Identifier: Apache-2.0
// TimeCodeInput: where a recording stands by the time code of the network (ArtTimeCode, stream 0, the
// master), of a MIDI port or of a sound (LTC). Fed by a receiver's thread or one of its own, asked by any.

#include "base/result.h"
#include "dmx/receive/receiver_options.h"
#include "dmx/timecode/timecode_clock.h"
#include "dmx/wire/timecode.h"
#include "live/inputs/ltc_input.h"

#include <memory>
#include <optional>
#include <string>

namespace ghost::app {

struct TimeCodeOptions {
    std::string begin; // time code at which the recording begins; empty: it follows none
    std::string ltc;   // file or input of ALSA whose sound is LTC, instead of the network's; empty: none
    double freewheel_s = dmx::kFreewheel_s;
};

class TimeCodeInput {
public:
    TimeCodeInput(double begin_s, const TimeCodeOptions& options)
        : begin_s_(begin_s), ltc_name_(options.ltc), time_(options.freewheel_s) {}

    // To be called once, before the receiver starts; this must outlive it.
    void listen(dmx::ReceiverOptions& options);
    // Second of the recording, at least 0 and at most end_s; nothing before the first time code.
    std::optional<double> at_s(double end_s) const;
    dmx::ChaseStatus status() const;

private:
    double begin_s_;
    std::string ltc_name_;
    dmx::SharedTimeCode time_;
    std::unique_ptr<LtcInput> ltc_; // feeds the one above
};

// Null: it follows none.
Result<std::unique_ptr<TimeCodeInput>> open_timecode(const TimeCodeOptions& options);

} // namespace ghost::app
