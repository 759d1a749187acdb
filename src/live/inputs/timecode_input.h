#pragma once
// SPDX-License-Identifier: Apache-2.0
// TimeCodeInput: where a recording stands by the time code of the network (ArtTimeCode, stream 0, the
// master) or of a MIDI port. Fed by a receiver's thread, asked by any.

#include "base/result.h"
#include "dmx/receive/receiver_options.h"
#include "dmx/timecode/timecode_clock.h"
#include "dmx/wire/timecode.h"

#include <memory>
#include <optional>
#include <string>

namespace ghost::app {

class TimeCodeInput {
public:
    // begin_s: time code at which the recording begins.
    explicit TimeCodeInput(double begin_s) : begin_s_(begin_s) {}

    // To be called before the receiver starts; this must outlive it.
    void listen(dmx::ReceiverOptions& options);
    // Second of the recording, at least 0 and at most end_s; nothing before the first time code.
    std::optional<double> at_s(double end_s) const;

private:
    double begin_s_;
    dmx::SharedTimeCode time_;
};

// Null: text is empty.
Result<std::unique_ptr<TimeCodeInput>> open_timecode(const std::string& text);

} // namespace ghost::app
