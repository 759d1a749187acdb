#pragma once
// SPDX-License-Identifier: Apache-2.0
// Recordings of every format that Ghostlight reads: its own (.ghostdmx), OLA show files, and captures of the
// network (pcap, pcapng); found out by their first bytes, not by their names. docs/reference/recording.md. A
// .ghostdmx recording is read where it lies, block by block; one of another format is packed into memory in
// the same form, so everything behind this knows one format only. One thread at a time.

#include "dmx/record/capture.h"
#include "dmx/record/ghostdmx_reader.h"
#include "dmx/record/part.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace ghost::dmx {

// Packed bytes of a capture or an OLA show file, in memory. Longer ones are converted first.
inline constexpr std::size_t kMaxPackedBytes = 512u << 20;

struct ReadOptions {
    CaptureOptions capture;
    // Asked now and then with what share is read; false ends the reading with an error "interrupted".
    std::function<bool(double share)> progress;
};

class Recording {
public:
    std::vector<Error> problems; // what was left out, as far as opening shows it

    std::chrono::microseconds duration() const { return reader_.index().duration; }
    std::uint64_t frames() const { return reader_.index().frames; }
    std::chrono::microseconds unix_time() const {
        return reader_.header().unix_time;
    } // of time 0; 0: unknown
    std::size_t blocks() const { return reader_.index().blocks.size(); }
    const ghostdmx::BlockPlace& block_place(std::size_t number) const {
        return reader_.index().blocks.at(number);
    }

    // Block `number`; what is damaged in it comes out of take_damage(), once.
    ghostdmx::BlockCursor block(std::size_t number);
    std::vector<Error> take_damage();
    // To be called with a cursor of block() that went as far as it does.
    void check(const ghostdmx::BlockCursor& cursor, std::size_t number);
    // The last block that starts at or before this time; 0 before the first.
    std::size_t block_at(std::chrono::microseconds time) const;

    // Every universe with the time of its first frame. Reads only the blocks in which new ones appear, and
    // some to find these.
    std::map<std::uint16_t, std::chrono::microseconds> first_frames();
    // Reads everything, for the damage that there is.
    void check_all();

private:
    friend Result<Recording> read_recording(const std::filesystem::path&, const ReadOptions&);
    friend Result<Recording> parse_recording(std::string_view, const std::string&);
    Recording(GhostdmxReader reader, std::string name)
        : problems(reader.problems()), reader_(std::move(reader)), name_(std::move(name)) {}

    GhostdmxReader reader_;
    using FirstFrames = std::map<std::uint16_t, std::chrono::microseconds>;
    std::size_t universes_before(std::size_t block);
    void add_first_frames(std::size_t block, FirstFrames& found);
    void find_first_frames(std::size_t from, std::size_t to, std::size_t at_from, std::size_t at_to,
                           FirstFrames& found);

    std::string name_;
    std::vector<Error> damage_;
    std::set<std::size_t> damaged_; // blocks that were spoken of
};

Result<Recording> read_recording(const std::filesystem::path& path, const ReadOptions& options = {});
// The text of an OLA show file. name is for messages.
Result<Recording> parse_recording(std::string_view text, const std::string& name);

// What read_frames() says besides the frames.
struct FramesEnd {
    std::chrono::microseconds duration{0};
    std::chrono::microseconds unix_time{0}; // of time 0; 0: unknown
    std::vector<Error> problems;
};
// Hands frames to sink, by time, without holding the recording. Of a .ghostdmx recording only those that part
// needs, of other formats all. began is called before the first frame.
Result<FramesEnd> read_frames(const std::filesystem::path& path, const ReadOptions& options,
                              const PartOptions& part,
                              const std::function<void(std::chrono::microseconds unix_time)>& began,
                              const FrameSink& sink);

} // namespace ghost::dmx
