// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/midi_input.h"

namespace ghost::dmx {

namespace {

constexpr std::chrono::nanoseconds kLookEvery = std::chrono::seconds(1);
constexpr int kReadsPerTurn = 16;

} // namespace

void MidiInput::take(std::chrono::nanoseconds now, const MidiTimeCode::Take& take) {
    if (status_.path.empty()) return;
    if (!port_ && now >= next_look_) {
        next_look_ = now + kLookEvery;
        auto opened = SerialPort::open_midi(status_.path);
        status_.problem = opened.ok() ? "" : opened.error().what;
        if (opened.ok()) {
            port_ = std::move(*opened);
            ++status_.openings;
        }
    }
    const auto note = [&](const TimeCode& time) {
        status_.time = time;
        status_.arrival = now;
        take(time);
    };
    for (int turn = 0; port_ && turn < kReadsPerTurn; ++turn) {
        const std::optional<Bytes> bytes = port_->receive();
        if (bytes && bytes->empty()) break;
        if (bytes) {
            decoder_.feed(*bytes, now, note);
        } else {
            port_.reset();
            next_look_ = now + kLookEvery;
            status_.problem = "was pulled out";
        }
    }
}

MidiStatus MidiInput::status() const {
    MidiStatus status = status_;
    status.open = port_ != nullptr;
    status.counters = decoder_.counters();
    return status;
}

} // namespace ghost::dmx
