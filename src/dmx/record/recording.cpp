// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/recording.h"

#include "disk/files.h"
#include "dmx/record/ghostdmx_writer.h"
#include "dmx/record/ola_show.h"

#include <algorithm>

namespace ghost::dmx {

namespace fs = std::filesystem;
using std::chrono::microseconds;

namespace {

enum class Format { ghostdmx, ola_show, capture };

Result<Format> find_format(ByteSource& source, const std::string& name) {
    std::array<std::uint8_t, 16> first{};
    const Bytes bytes(first.data(), source.read(0, first));
    if (is_capture(bytes)) return Format::capture;
    if (source.is_gzip())
        return Error{"is packed with gzip and no capture of the network; unpack it first (gunzip)", name};
    if (GhostdmxReader::recognises(bytes)) return Format::ghostdmx;
    if (is_ola_show(bytes)) return Format::ola_show;
    return Error{
        "is no recording: expected one of Ghostlight (.ghostdmx), an OLA show file (its first line is "
        "\"OLA Show\"), or a capture (pcap, pcapng)",
        name};
}

// Bytes of a recording that is packed into memory.
struct Packed {
    std::vector<std::uint8_t> bytes;

    ByteSink sink(const std::string& name) {
        return [this, name](Bytes more) -> Result<void> {
            if (more.size() > kMaxPackedBytes - bytes.size())
                return Error{"is too long to be played as it is; ghostlight play " + name +
                                 " -o NAME.ghostdmx makes it a recording of any length",
                             name};
            bytes.insert(bytes.end(), more.begin(), more.end());
            return {};
        };
    }
};

Result<FramesEnd> read_ola_frames(std::string_view text, const std::string& name, const FrameSink& sink) {
    TRY(OlaShowEnd end, read_ola_show(text, name, sink));
    return FramesEnd{end.duration, microseconds(0), std::move(end.problems)};
}

Result<FramesEnd> read_ghostdmx_frames(Recording recording, const ReadOptions& options,
                                       const PartOptions& part,
                                       const std::function<void(microseconds)>& began,
                                       const FrameSink& sink) {
    FramesEnd end{recording.duration(), recording.unix_time(), std::move(recording.problems)};
    began(end.unix_time);
    const std::size_t first = recording.block_at(part.from), last = recording.block_at(part.until);
    microseconds time{0};
    bool key_matters = true; // the frames before are not known
    for (std::size_t number = first; number <= last; ++number) {
        ghostdmx::BlockCursor cursor = recording.block(number);
        const auto hand_on = [&](std::uint16_t universe, const ghostdmx::State& state) {
            time = std::max(time, state.time);
            return sink({time, universe, state.slot_count, state.lost, state.levels});
        };
        if (key_matters) {
            std::vector<std::pair<microseconds, std::uint16_t>> by_time;
            for (const auto& [universe, state] : cursor.states()) by_time.emplace_back(state.time, universe);
            std::sort(by_time.begin(), by_time.end());
            for (const auto& [when, universe] : by_time)
                TRY_VOID(hand_on(universe, cursor.states().at(universe)));
        }
        while (cursor.next_time()) {
            const std::uint16_t universe = cursor.next();
            if (universe != 0) TRY_VOID(hand_on(universe, cursor.states().at(universe)));
        }
        recording.check(cursor, number);
        std::vector<Error> damage = recording.take_damage();
        key_matters = !damage.empty();
        end.problems.insert(end.problems.end(), damage.begin(), damage.end());
        const double share = static_cast<double>(number - first + 1) / static_cast<double>(last - first + 1);
        if (options.progress && !options.progress(share)) return Error{"interrupted", ""};
    }
    return end;
}

} // namespace

ghostdmx::BlockCursor Recording::block(std::size_t number) {
    GhostdmxReader::Block block = reader_.block(number);
    if (block.damage && damaged_.insert(number).second) damage_.push_back(*block.damage);
    return std::move(block.cursor);
}

void Recording::check(const ghostdmx::BlockCursor& cursor, std::size_t number) {
    if (!cursor.malformed() || !damaged_.insert(number).second) return;
    damage_.push_back({"holds what is no frame, though its checksum is right; the levels stand still there",
                       name_ + ", byte " + std::to_string(block_place(number).offset)});
}

std::vector<Error> Recording::take_damage() {
    return std::exchange(damage_, {});
}

std::size_t Recording::block_at(microseconds time) const {
    const auto& blocks = reader_.index().blocks;
    const auto after = std::upper_bound(blocks.begin(), blocks.end(), time,
                                        [](microseconds t, const auto& block) { return t < block.start; });
    return after == blocks.begin() ? 0 : static_cast<std::size_t>(after - blocks.begin() - 1);
}

void Recording::check_all() {
    for (std::size_t number = 0; number < blocks(); ++number) {
        ghostdmx::BlockCursor cursor = block(number);
        while (cursor.next_time()) cursor.next();
        check(cursor, number);
    }
}

void Recording::add_first_frames(std::size_t number, FirstFrames& found) {
    ghostdmx::BlockCursor cursor = block(number);
    for (const auto& [universe, state] : cursor.states()) found.try_emplace(universe, state.time);
    while (const auto time = cursor.next_time())
        if (const std::uint16_t universe = cursor.next(); universe != 0) found.try_emplace(universe, *time);
    check(cursor, number);
}

std::size_t Recording::universes_before(std::size_t number) {
    return block(number).states().size();
}

// Once there, a universe is in the key of every later block: where two keys hold as many, none came between.
// A damaged key holds none, so what lies beside it is read.
void Recording::find_first_frames(std::size_t from, std::size_t to, std::size_t at_from, std::size_t at_to,
                                  FirstFrames& found) {
    if (at_from == at_to && at_from > 0) return;
    if (to == from + 1) return add_first_frames(from, found);
    const std::size_t middle = from + (to - from) / 2, at_middle = universes_before(middle);
    find_first_frames(from, middle, at_from, at_middle, found);
    find_first_frames(middle, to, at_middle, at_to, found);
}

std::map<std::uint16_t, microseconds> Recording::first_frames() {
    FirstFrames found;
    if (blocks() == 0) return found;
    add_first_frames(0, found);
    const std::size_t last = blocks() - 1;
    if (last > 1) find_first_frames(1, last, universes_before(1), universes_before(last), found);
    if (last > 0) add_first_frames(last, found);
    return found;
}

Result<Recording> parse_recording(std::string_view text, const std::string& name) {
    Packed packed;
    GhostdmxWriter writer(packed.sink(name));
    TRY(FramesEnd end, read_ola_frames(text, name, [&](const RecordedFrame& f) { return writer.append(f); }));
    TRY_VOID(writer.finish(end.duration));
    TRY(GhostdmxReader reader, GhostdmxReader::open(ByteSource(std::move(packed.bytes)), name));
    Recording recording(std::move(reader), name);
    recording.problems = std::move(end.problems);
    return recording;
}

Result<Recording> read_recording(const fs::path& path, const ReadOptions& options) {
    const std::string name = path.string();
    TRY(ByteSource source, ByteSource::open(path));
    TRY(const Format format, find_format(source, name));
    if (format == Format::ghostdmx) {
        TRY(GhostdmxReader reader, GhostdmxReader::open(std::move(source), name));
        return Recording(std::move(reader), name);
    }
    Packed packed;
    GhostdmxWriter writer(packed.sink(name));
    TRY(FramesEnd end,
        read_frames(
            path, options, PartOptions{}, [&](microseconds unix_time) { writer.began(unix_time); },
            [&](const RecordedFrame& frame) { return writer.append(frame); }));
    TRY_VOID(writer.finish(end.duration));
    TRY(GhostdmxReader reader, GhostdmxReader::open(ByteSource(std::move(packed.bytes)), name));
    Recording recording(std::move(reader), name);
    recording.problems = std::move(end.problems);
    return recording;
}

Result<FramesEnd> read_frames(const fs::path& path, const ReadOptions& options, const PartOptions& part,
                              const std::function<void(microseconds)>& began, const FrameSink& sink) {
    const std::string name = path.string();
    TRY(ByteSource source, ByteSource::open(path));
    TRY(const Format format, find_format(source, name));
    if (format == Format::ghostdmx) {
        TRY(Recording recording, read_recording(path, options));
        return read_ghostdmx_frames(std::move(recording), options, part, began, sink);
    }
    if (format == Format::ola_show) {
        TRY(const std::string text, read_text_file(path, kMaxOlaShowBytes));
        began(microseconds(0));
        return read_ola_frames(text, name, sink);
    }
    TRY(CaptureEnd end, read_capture(source, name, options.capture, options.progress, began, sink));
    return FramesEnd{end.duration, end.unix_time, std::move(end.problems)};
}

} // namespace ghost::dmx
