// SPDX-License-Identifier: Apache-2.0
#include "dmx/timecode/midi_timecode.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kExclusive = 0xF0, kQuarterFrame = 0xF1, kExclusiveEnd = 0xF7, kRealTime = 0xF8;
constexpr int kPieces = 8;
constexpr auto kPause = 500ms; // quarter frames come every 8 to 10 ms

TimeCode::Rate rate_of(unsigned bits) {
    return static_cast<TimeCode::Rate>(bits & 3);
}

} // namespace

void MidiTimeCode::hand_on(const TimeCode& time, const Take& take) {
    if (is_timecode(time))
        take(time);
    else
        ++counters_.malformed;
}

void MidiTimeCode::take_quarter_frame(std::uint8_t data, std::chrono::nanoseconds now, const Take& take) {
    ++counters_.quarter_frames;
    const int piece = data >> 4;
    const int step = (piece - last_piece_ + kPieces) % kPieces;
    const int direction = step == 1 ? 1 : step == kPieces - 1 ? -1 : 0;
    const bool goes_on =
        run_ > 0 && direction != 0 && now - last_ < kPause && (direction_ == 0 || direction == direction_);
    run_ = goes_on ? std::min(run_ + 1, kPieces) : 1;
    direction_ = goes_on ? direction : 0;
    if (!goes_on) known_.reset();
    last_piece_ = piece;
    last_ = now;
    pieces_[static_cast<std::size_t>(piece)] = data & 0x0F;

    const int last_of_eight = direction_ > 0 ? kPieces - 1 : 0;
    // Forwards the time of the last eight, which was right when their piece 0 came, is two frames old by now.
    if (known_ && direction_ > 0 && piece == 0) hand_on(plus_frames(*known_, 2), take);
    if (known_ && piece == 4) hand_on(plus_frames(*known_, direction_ > 0 ? 3 : -1), take);
    if (run_ < kPieces || piece != last_of_eight) return;
    const auto byte_of = [&](std::size_t low) {
        return static_cast<std::uint8_t>(pieces_[low] | pieces_[low + 1] << 4);
    };
    TimeCode time;
    time.frames = byte_of(0) & 0x1F;
    time.seconds = byte_of(2) & 0x3F;
    time.minutes = byte_of(4) & 0x3F;
    time.hours = byte_of(6) & 0x1F;
    time.rate = rate_of(pieces_[7] >> 1u);
    known_ = time;
    if (!is_timecode(time)) {
        ++counters_.malformed;
        known_.reset();
    } else if (direction_ < 0) {
        take(time); // backwards piece 0 comes last
    }
}

// F0 7F channel 01 01 hours minutes seconds frames F7
void MidiTimeCode::take_exclusive(const Take& take) {
    if (exclusive_count_ != exclusive_.size() || exclusive_[0] != 0x7F || exclusive_[2] != 1 ||
        exclusive_[3] != 1)
        return;
    ++counters_.full_frames;
    TimeCode time;
    time.hours = exclusive_[4] & 0x1F;
    time.minutes = exclusive_[5];
    time.seconds = exclusive_[6];
    time.frames = exclusive_[7];
    time.rate = rate_of(exclusive_[4] >> 5u);
    run_ = 0;
    hand_on(time, take);
}

void MidiTimeCode::feed(Bytes bytes, std::chrono::nanoseconds now, const Take& take) {
    counters_.bytes += bytes.size();
    for (const std::uint8_t byte : bytes) {
        if (byte >= kRealTime) continue; // may stand within any other message
        if (byte >= 0x80) {
            if (byte == kExclusiveEnd && status_ == kExclusive) take_exclusive(take);
            status_ = byte;
            exclusive_count_ = 0;
        } else if (status_ == kQuarterFrame) {
            take_quarter_frame(byte, now, take);
            status_ = 0;
        } else if (status_ == kExclusive) {
            if (exclusive_count_ < exclusive_.size()) exclusive_[exclusive_count_] = byte;
            exclusive_count_ = std::min(exclusive_count_ + 1, exclusive_.size() + 1);
        }
    }
}

} // namespace ghost::dmx
