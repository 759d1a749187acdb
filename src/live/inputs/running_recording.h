#pragma once
// SPDX-License-Identifier: Apache-2.0
// RunningRecording: a recording while it is made, of the command `record` and of the window. put() takes what
// the receiver hears, on its thread; all else is of one thread, which writes what waits every few
// milliseconds. Errors: what the disk says.

#include "base/result.h"
#include "dmx/record/changes.h"
#include "dmx/record/recorder.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace ghost::app {

class RunningRecording {
public:
    // asked: universes that always have their place among the dmx::kMaxRecordedUniverses; sorted.
    static Result<std::unique_ptr<RunningRecording>> create(const std::filesystem::path& path,
                                                            std::vector<std::uint16_t> asked);

    void put(const dmx::Universes& universes, std::chrono::nanoseconds now);
    // now: steady, as that of put.
    Result<void> write(std::chrono::nanoseconds now);
    // Everything, then the end. Error as well: nothing came.
    Result<void> finish(std::chrono::nanoseconds now);

    bool has_begun() const { return first_.has_value(); } // something was recorded
    double seconds(std::chrono::nanoseconds now) const;   // since then
    std::uint64_t lost();                                 // frames that came faster than the disk takes them
    std::size_t left_out() const { return left_out_.size(); } // universes without a place
    const dmx::Recorder& recorder() const { return recorder_; }

private:
    RunningRecording(dmx::Recorder recorder, std::filesystem::path path, std::vector<std::uint16_t> asked);
    bool has_place(std::uint16_t universe);
    Result<void> append_waiting(std::chrono::nanoseconds now);

    dmx::Recorder recorder_;
    std::filesystem::path path_;
    std::vector<std::uint16_t> asked_; // sorted
    std::size_t free_ = 0;
    std::set<std::uint16_t> others_, left_out_;
    std::optional<std::chrono::microseconds> first_; // steady
    std::chrono::microseconds last_{0}, flushed_{0}; // since first

    std::mutex mutex_; // of what follows
    dmx::Changes changes_;
    std::vector<dmx::RecordedFrame> waiting_;
    std::uint64_t lost_ = 0;
};

} // namespace ghost::app
