#pragma once
// SPDX-License-Identifier: Apache-2.0
// LtcDecoder: time code that is a sound (LTC, SMPTE 12M-1): one channel's samples in, the time of each moment
// out, forwards, backwards and faster or slower than it was written; libltc finds the bits. A frame that does
// not follow from those before, which noise makes, is left out; libltc, which may lock onto noise, begins
// anew after two seconds of sound without one; a jump is known by its second frame. Whether there are 24, 25
// or 30 frames a second LTC does not say: the length of a frame does, later the number of the last frame of a
// second. No clock: calls get the time. One thread.

#include "dmx/wire/packet.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace ghost::sound {

struct LtcCounters {
    std::uint64_t frames = 0;   // whose bits were found
    std::uint64_t left_out = 0; // of them: times that there are none of, or that follow from nothing
    double level_dbfs = -100;   // of the sound of the last one
    bool is_backwards = false;
};

class LtcDecoder {
public:
    // time: of the moment `at`.
    using Take = std::function<void(const dmx::TimeCode& time, std::chrono::nanoseconds at)>;
    explicit LtcDecoder(int rate_hz);
    ~LtcDecoder();
    LtcDecoder(const LtcDecoder&) = delete;
    LtcDecoder& operator=(const LtcDecoder&) = delete;

    // end: when the last of the samples was heard.
    void feed(std::span<const std::int16_t> samples, std::chrono::nanoseconds end, const Take& take);
    const LtcCounters& counters() const { return counters_; }

private:
    struct Decoder;
    void begin();
    void take_frame(std::chrono::nanoseconds begin, const Take& take);

    const int rate_hz_;
    std::unique_ptr<Decoder> decoder_;
    std::int64_t fed_ = 0;  // samples
    std::int64_t deaf_ = 0; // loud samples since a frame was taken, or since libltc began anew
    LtcCounters counters_;
};

} // namespace ghost::sound
