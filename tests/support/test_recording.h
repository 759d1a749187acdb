#pragma once
// SPDX-License-Identifier: Apache-2.0
// Recordings for tests: made frames, frames of text, recordings in memory.
#include "dmx/record/ghostdmx_writer.h"
#include "dmx/record/ola_show.h"
#include "dmx/record/player.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::dmx {

using ghost::TestFolder;

inline RecordedFrame make_frame(std::chrono::microseconds time, std::uint16_t universe,
                                std::initializer_list<int> levels, bool lost = false) {
    auto data = std::make_shared<Levels>();
    std::size_t i = 0;
    for (const int level : levels) (*data)[i++] = static_cast<std::uint8_t>(level);
    return {time, universe, static_cast<std::uint16_t>(std::max<std::size_t>(levels.size(), 1)), lost, data};
}

inline bool same_frame(const RecordedFrame& a, const RecordedFrame& b) {
    return a.time == b.time && a.universe == b.universe && a.slot_count == b.slot_count && a.lost == b.lost &&
           *a.levels == *b.levels;
}

inline bool same_frames(const std::vector<RecordedFrame>& a, const std::vector<RecordedFrame>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same_frame);
}

// Levels of all universes at a moment, whoever holds them.
inline bool same_look(const Universes& a, const Universes& b) {
    const auto same = [](const Universe& x, const Universe& y) {
        return x.number == y.number && x.lost == y.lost && *x.levels == *y.levels && x.arrival == y.arrival &&
               x.revision == y.revision;
    };
    return a.revision == b.revision && a.list.size() == b.list.size() &&
           std::equal(a.list.begin(), a.list.end(), b.list.begin(), same);
}

// What a rig with fades, chases, snaps, refreshes and noise sends; pauses from none to minutes.
inline std::vector<RecordedFrame> random_frames(unsigned seed, std::size_t count, unsigned universes,
                                                unsigned most_slots = 512) {
    std::mt19937 random(seed);
    const auto upto = [&](unsigned most) { return static_cast<unsigned>(random() % (most + 1)); };
    std::map<std::uint16_t, RecordedFrame> newest;
    std::vector<RecordedFrame> result;
    std::chrono::microseconds time{upto(3) == 0 ? upto(1000) : 0};
    for (std::size_t i = 0; i < count; ++i) {
        const auto universe = static_cast<std::uint16_t>(1 + upto(universes - 1) * (63998 / universes));
        const auto known = newest.find(universe);
        auto levels = std::make_shared<Levels>(known == newest.end() ? Levels{} : *known->second.levels);
        RecordedFrame frame{time, universe, static_cast<std::uint16_t>(1 + upto(most_slots - 1)),
                            upto(40) == 0, nullptr};
        if (known != newest.end() && upto(3) > 0) frame.slot_count = known->second.slot_count;
        const unsigned kind = upto(5);
        for (std::size_t slot = 0; slot < frame.slot_count; ++slot) {
            std::uint8_t& level = (*levels)[slot];
            if (kind == 0) level = static_cast<std::uint8_t>(random());
            if (kind == 1) level = static_cast<std::uint8_t>(level + 3);
            if (kind == 2 && upto(30) == 0) level = static_cast<std::uint8_t>(random());
            if (kind == 3) level = 0;
        }
        std::fill(levels->begin() + frame.slot_count, levels->end(), std::uint8_t{0});
        frame.levels = levels;
        newest[universe] = frame;
        result.push_back(frame);
        const unsigned pause = upto(20);
        time += std::chrono::microseconds(pause < 10 ? 0 : pause < 19 ? upto(50000) : upto(200) * 1'000'000u);
    }
    return result;
}

// flush_every: so many frames; 0: never.
inline std::vector<std::uint8_t> pack(const std::vector<RecordedFrame>& frames,
                                      std::chrono::microseconds duration, std::size_t flush_every = 0) {
    std::vector<std::uint8_t> bytes;
    GhostdmxWriter writer([&](Bytes more) -> Result<void> {
        bytes.insert(bytes.end(), more.begin(), more.end());
        return {};
    });
    writer.began(std::chrono::seconds(1'800'000'000));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_TRUE(writer.append(frames[i]).ok());
        const bool pause = flush_every && (i + 1) % flush_every == 0;
        EXPECT_TRUE(!pause || writer.flush(frames[i].time).ok());
    }
    EXPECT_TRUE(writer.finish(duration).ok());
    return bytes;
}

inline std::filesystem::path write_bytes(const std::filesystem::path& path, Bytes bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

struct ReadBack {
    std::vector<RecordedFrame> frames;
    FramesEnd end;
    bool ok = false;
    std::string error;
};

inline ReadBack read_back(const std::filesystem::path& path, const ReadOptions& options = {},
                          const PartOptions& part = {}) {
    ReadBack result;
    auto end = read_frames(
        path, options, part, [](std::chrono::microseconds) {},
        [&](const RecordedFrame& frame) -> Result<void> {
            result.frames.push_back(frame);
            return {};
        });
    result.ok = end.ok();
    if (end.ok()) result.end = std::move(*end);
    if (!end.ok()) result.error = end.error().text();
    return result;
}

} // namespace ghost::dmx
