#pragma once
// SPDX-License-Identifier: Apache-2.0
// MidiInput: a MIDI port that is read for its time code: a raw device of ALSA (/dev/snd/midiC1D0), or
// whatever else brings MIDI bytes: a serial port, a pipe. It may be plugged in later; one that went away is
// opened again when it is back, looked for once a second. No clock: calls get the time. One thread, that of
// the receiver.

#include "dmx/timecode/midi_timecode.h"
#include "net/serial.h"

#include <memory>
#include <string>

namespace ghost::dmx {

// For people.
struct MidiStatus {
    std::string path; // empty: no port was asked for
    bool open = false;
    std::string problem; // why it is not open
    MidiCounters counters;
    std::optional<TimeCode> time; // the newest
    std::chrono::nanoseconds arrival{0};
    std::uint64_t openings = 0; // 1: never pulled out
};

class MidiInput {
public:
    // path: empty for none.
    explicit MidiInput(const std::string& path) { status_.path = path; }

    // Reads what has arrived, at most 64 KiB. Call when the handle has bytes, and a few times a second.
    void take(std::chrono::nanoseconds now, const MidiTimeCode::Take& take);
    std::optional<int> handle() const { return port_ ? std::optional(port_->handle()) : std::nullopt; }
    MidiStatus status() const;

private:
    MidiStatus status_;
    std::unique_ptr<SerialPort> port_; // null: not open
    MidiTimeCode decoder_;
    std::chrono::nanoseconds next_look_{0};
};

} // namespace ghost::dmx
