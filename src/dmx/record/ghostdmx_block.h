#pragma once
// SPDX-License-Identifier: Apache-2.0
// What stands unpacked in a block of a .ghostdmx recording: the state of every universe (the key), then
// frames as differences to the frame before of the same universe. Levels are written as runs of changed
// slots, each as new minus old modulo 256, so that a fade is the same few bytes again and again. One thread.

#include "dmx/record/ghostdmx_format.h"

#include <map>

namespace ghost::dmx::ghostdmx {

// A universe after some frame.
struct State {
    microseconds time{0}; // of its last frame
    std::uint64_t revision =
        0; // 1 + number of the frame that changed its levels last, counted from the first
    std::uint16_t slot_count = 0;
    bool lost = false;
    std::shared_ptr<const Levels> levels;
};
using States = std::map<std::uint16_t, State>;

// frame_number: of the next frame, counted from the recording's first.
void encode_key(const States& states, microseconds start, std::uint64_t frame_number,
                std::vector<std::uint8_t>& out);
// The frame after one at `before`; states take it in.
void encode_frame(const RecordedFrame& frame, microseconds before, std::uint64_t frame_number, States& states,
                  std::vector<std::uint8_t>& out);

// Walks over the frames of an unpacked block, forwards. Levels that were handed out never change.
class BlockCursor {
public:
    BlockCursor() = default;
    // Reads the key.
    BlockCursor(std::vector<std::uint8_t> bytes, const BlockPlace& place);

    const States& states() const { return states_; }
    // Time of the frame that next() would read; nothing at the end.
    std::optional<microseconds> next_time() const { return next_time_; }
    // Takes the next frame in; its universe. Only where next_time() says there is one.
    std::uint16_t next();
    // What follows is no frame: damage that no checksum covers, or a hostile file.
    bool malformed() const { return malformed_; }

private:
    void read_key(const BlockPlace& place);
    void read_time();
    // The levels after the runs that come next.
    std::shared_ptr<const Levels> read_levels(const std::shared_ptr<const Levels>& before);

    std::vector<std::uint8_t> bytes_;
    std::size_t position_ = 0;
    States states_;
    microseconds time_{0};
    std::optional<microseconds> next_time_;
    std::uint64_t frame_number_ = 0;
    bool malformed_ = false;
};

} // namespace ghost::dmx::ghostdmx
