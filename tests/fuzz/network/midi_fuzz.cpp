// SPDX-License-Identifier: Apache-2.0
// Bytes of a MIDI port in pieces of any size: whatever comes, what is handed on is a time of day.
#include "dmx/timecode/midi_timecode.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    dmx::MidiTimeCode decoder;
    std::chrono::nanoseconds now{0};
    ByteReader reader(Bytes(data, size));
    while (reader.left() > 0) {
        const std::uint8_t head = reader.u8();
        now += std::chrono::milliseconds(head & 0x80 ? 600 : 10);
        const Bytes piece = reader.take(std::min<std::size_t>(head & 0x7F, reader.left()));
        decoder.feed(piece, now, [](const dmx::TimeCode& time) {
            if (!dmx::is_timecode(time) || !dmx::is_timecode(dmx::plus_frames(time, 1))) std::abort();
        });
    }
    return 0;
}
