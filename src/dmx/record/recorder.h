#pragma once
// SPDX-License-Identifier: Apache-2.0
// Recorder: writes a recording while it happens, or a part of one, in the format that the file's name asks
// for: .ghostdmx, or .show and .txt for an OLA show file. The file grows as "<path>.part" and finish()
// renames it. After a crash the .part file plays: of an OLA show up to its last line, else up to the last
// flush(). One thread at a time.

#include "dmx/record/recorded_frame.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace ghost::dmx {

class Recorder {
public:
    // Error: a name of no known ending, a folder, a place that cannot be written, or one that another program
    // is recording to.
    static Result<Recorder> create(const std::filesystem::path& path);
    Recorder(Recorder&&) noexcept = default;
    Recorder& operator=(Recorder&&) = delete;
    ~Recorder(); // without finish(): closes and leaves the .part file, unless it has no frame

    // Wall-clock time of time zero, before the first frame.
    void began(std::chrono::microseconds unix_time) { writer_->began(unix_time); }
    Result<void> append(const RecordedFrame& frame);
    // Written, and every two seconds of real time on the disk: a loss of power costs no more.
    Result<void> flush(std::chrono::microseconds now);
    // The end, then fsync and rename.
    Result<void> finish(std::chrono::microseconds duration);
    // Takes the file away instead.
    void discard();

    // A recording that was not finished lay in the place of the .part file and was given this name; or empty.
    const std::filesystem::path& kept() const { return kept_; }

    std::size_t frames() const { return frames_; }
    std::uintmax_t bytes() const { return out_->bytes; }

private:
    struct Out { // stays where it is: the writer's bytes come here
        std::filesystem::path path, part;
        std::FILE* file = nullptr;
        std::uintmax_t bytes = 0, synced_bytes = 0;
        std::chrono::steady_clock::time_point synced = std::chrono::steady_clock::now();
    };
    Recorder() = default;

    std::unique_ptr<Out> out_;
    std::unique_ptr<FrameWriter> writer_;
    std::size_t frames_ = 0;
    std::filesystem::path kept_;
};

} // namespace ghost::dmx
