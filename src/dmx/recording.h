#pragma once
// SPDX-License-Identifier: Apache-2.0
// DMX with time stamps, in the show-file format of the Open Lighting Architecture (ola_recorder): the line
// "OLA Show", then in turn "<universe> <level>,<level>,..." and the milliseconds until the next frame.
// Reading keeps what can be read and lists each line that cannot, by number. OLA universe n is our universe
// n. Any thread, one object per thread.

#include "base/result.h"
#include "dmx/universes.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uintmax_t kMaxRecordingBytes = 512u << 20;
inline constexpr std::size_t kMaxRecordingFrames = 1'000'000;

struct RecordedFrame {
    std::chrono::milliseconds time{0}; // since the first frame
    std::uint16_t universe = 0;
    std::uint16_t slot_count = 0;
    std::shared_ptr<const Levels> levels; // 0 beyond slot_count; equal successive frames share them
};

struct Recording {
    std::vector<RecordedFrame> frames;     // by time
    std::chrono::milliseconds duration{0}; // with the pause after the last frame
    std::vector<Error> problems; // lines that were left out, where = "name:line"; at most 100 and a total
};

// Error: no "OLA Show" line, no frame at all, or a limit passed. name is for messages.
Result<Recording> parse_recording(std::string_view text, const std::string& name);
Result<Recording> read_recording(const std::filesystem::path& path);

// Writes while it happens: the file grows as "<path>.part", every frame is a whole line handed to the kernel
// at once, and finish() renames it. After a crash the .part file is a valid recording up to its last line.
class Recorder {
public:
    static Result<Recorder> create(const std::filesystem::path& path);
    Recorder(Recorder&& other) noexcept;
    Recorder& operator=(Recorder&&) = delete;
    ~Recorder(); // without finish(): closes and leaves the .part file, unless it has no frame

    // Appends the universes whose levels changed. Time may start anywhere and must not go back.
    Result<void> feed(const Universes& universes, std::chrono::nanoseconds now);
    // The pause up to now, then fsync and rename.
    Result<void> finish(std::chrono::nanoseconds now);
    std::size_t frames() const { return frames_; }
    std::uintmax_t bytes() const { return bytes_; }

private:
    Recorder(std::filesystem::path path, std::FILE* file) : path_(std::move(path)), file_(file) {}
    Result<void> append(const std::string& line);

    struct Written {
        std::uint64_t revision = 0;
        std::size_t slots = 0; // never shrinks, so that a level that returns to 0 is written
    };
    std::filesystem::path path_;
    std::FILE* file_ = nullptr;
    std::map<std::uint16_t, Written> written_;
    std::chrono::milliseconds last_{0};
    std::size_t frames_ = 0;
    std::uintmax_t bytes_ = 0;
};

// Plays a recording by show time. Deterministic: the same t gives the same levels in any order of calls.
class Player {
public:
    explicit Player(Recording recording);

    // Levels at t_s seconds: of each universe its last frame at or before t (a universe before its first
    // frame is absent). Before 0 like 0, after the end the last look.
    Universes at(double t_s) const;
    double duration_s() const;
    const Recording& recording() const { return recording_; }

private:
    Recording recording_;
    struct Step {
        std::chrono::milliseconds time;
        std::size_t frame;
        std::uint64_t revision;
    };
    std::map<std::uint16_t, std::vector<Step>> by_universe_; // by time
};

} // namespace ghost::dmx
