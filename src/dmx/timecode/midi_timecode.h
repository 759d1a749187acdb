#pragma once
// SPDX-License-Identifier: Apache-2.0
// MidiTimeCode: from the bytes of a MIDI port to time code: quarter frames, forwards and backwards, and full
// frames (MIDI Time Code, RP-004 and RP-008). Eight quarter frames tell a time that is two frames old when
// they are complete; what is handed on is the time of the moment, once a frame from then on. Whatever else a
// port brings (notes, clock, other system exclusive messages) is passed over; nothing in it grows. No clock:
// calls get the time. One thread.

#include "base/byte_reader.h"
#include "dmx/wire/timecode.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace ghost::dmx {

struct MidiCounters {
    std::uint64_t bytes = 0;
    std::uint64_t quarter_frames = 0;
    std::uint64_t full_frames = 0;
    std::uint64_t malformed = 0; // times that there are none of
};

class MidiTimeCode {
public:
    using Take = std::function<void(const TimeCode&)>;
    // now: when the last of the bytes arrived.
    void feed(Bytes bytes, std::chrono::nanoseconds now, const Take& take);
    const MidiCounters& counters() const { return counters_; }

private:
    void take_quarter_frame(std::uint8_t data, std::chrono::nanoseconds now, const Take& take);
    void take_exclusive(const Take& take);
    void hand_on(const TimeCode& time, const Take& take);

    std::uint8_t status_ = 0; // that data bytes belong to: 0xF1, 0xF0, or another, which is passed over
    std::array<std::uint8_t, 8> exclusive_{}; // of a system exclusive message, behind 0xF0
    std::size_t exclusive_count_ = 0;         // may be more than fit
    std::array<std::uint8_t, 8> pieces_{};    // the nibbles of the quarter frames
    int last_piece_ = 0;
    int run_ = 0;       // pieces in a row, in one direction
    int direction_ = 0; // 1 forwards, -1 backwards, 0 not known yet
    std::chrono::nanoseconds last_{0};
    std::optional<TimeCode> known_; // when piece 0 came, of the last eight in a row
    MidiCounters counters_;
};

} // namespace ghost::dmx
