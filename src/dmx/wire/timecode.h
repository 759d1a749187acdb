#pragma once
// SPDX-License-Identifier: Apache-2.0
// Time code: fields and seconds. Pure.

#include "base/result.h"
#include "dmx/wire/packet.h"

#include <string>

namespace ghost::dmx {

// Since 00:00:00:00; drop frame (SMPTE 12M) counts 30000/1001 frames a second and leaves two numbers out in
// every minute but each tenth.
double timecode_seconds(const TimeCode& time);

double frame_seconds(TimeCode::Rate rate);

// Its fields are those of a time of day.
bool is_timecode(const TimeCode& time);
// So many frames later, or earlier; round midnight.
TimeCode plus_frames(const TimeCode& time, int frames);

// "10:00:00:00", "10:00:00" or plain seconds; frames are 25 a second.
Result<double> parse_timecode(const std::string& text);

} // namespace ghost::dmx
