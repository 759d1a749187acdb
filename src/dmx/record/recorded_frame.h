#pragma once
// SPDX-License-Identifier: Apache-2.0
// RecordedFrame: the levels of one universe from a moment on; what recordings are made of. Times are
// microseconds since the recording began and never go back. Frames come and go one by one, so that a
// recording of days takes no more memory than one of seconds. Values only.

#include "base/byte_reader.h"
#include "base/result.h"
#include "dmx/wire/universes.h"

#include <chrono>
#include <functional>

namespace ghost::dmx {

inline constexpr std::size_t kMaxRecordedUniverses = 4096;
inline constexpr std::chrono::microseconds kLongestRecording = std::chrono::hours(24 * 366);

struct RecordedFrame {
    std::chrono::microseconds time{0};
    std::uint16_t universe = 0;           // 1 to kMaxUniverse
    std::uint16_t slot_count = 0;         // 1 to 512
    bool lost = false;                    // from now on no source, the levels are held
    std::shared_ptr<const Levels> levels; // 0 beyond slot_count; equal successive frames may share them
};

// Takes frames by time. An error ends what calls it.
using FrameSink = std::function<Result<void>(const RecordedFrame&)>;

// Writes frames in a format. The bytes go where the writer was told at its making.
class FrameWriter {
public:
    virtual ~FrameWriter() = default;
    // Wall-clock time of time zero, before the first frame; formats without a place for it forget it.
    virtual void began(std::chrono::microseconds /*unix_time*/) {}
    virtual Result<void> append(const RecordedFrame& frame) = 0;
    // Everything appended so far can be read after this. now: nothing more happened up to then.
    virtual Result<void> flush(std::chrono::microseconds now) = 0;
    virtual Result<void> finish(std::chrono::microseconds duration) = 0;
};

// Where a writer's bytes go, in order.
using ByteSink = std::function<Result<void>(Bytes)>;

} // namespace ghost::dmx
