// SPDX-License-Identifier: Apache-2.0
// What a recording takes on disk, and how long it takes to be somewhere in it, with a clock of its own: an
// hour is written as fast as it goes, flushed ten times a second as record does. Four rigs; in the last row a
// day, with the memory that its index needs.
#include "base/interrupt.h"
#include "bench/bench.h"

#include "dmx/record/player.h"
#include "dmx/record/recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
using std::chrono::microseconds;
using Clock = std::chrono::steady_clock;

constexpr int kSeeks = 400;

enum class Moves { noise, effects, cues };
struct BenchRig {
    const char* name;
    const char* note;
    int universes;
    microseconds length;
    int slots; // in use
    Moves moves;
    microseconds cue; // from one to the next
};
constexpr microseconds kFade = 3s;
constexpr microseconds kFrame{22'727}; // 44 Hz
const BenchRig kRigs[] = {
    {"noise", "512 slots, any value in every frame: the most there can be", 4, 5min, 512, Moves::noise, 30s},
    {"busy", "200 slots, each on a wave of its own, without a rest", 8, 20min, 200, Moves::effects, 30s},
    {"cues", "fades of 3 s on 200 slots, twice a minute", 8, 1h, 200, Moves::cues, 30s},
    {"still", "a look that stands, sent at 44 Hz", 8, 1h, 200, Moves::cues, 1h},
    {"a day of cues", "fades of 3 s on 200 slots, once a minute", 4, 24h, 200, Moves::cues, 60s},
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Any number from any two, the same each time (splitmix64).
std::uint64_t mixed(std::int64_t a, std::int64_t b) {
    std::uint64_t x = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(b);
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

std::uint8_t level(const BenchRig& rig, int slot, std::int64_t cue, double share, std::int64_t frame) {
    const auto look = [&](std::int64_t of) { return static_cast<double>(mixed(of, slot) & 255); };
    switch (rig.moves) {
    case Moves::noise:
        return static_cast<std::uint8_t>(mixed(frame, slot));
    case Moves::effects: {
        const double hz = 0.1 + static_cast<double>(mixed(slot, 1) & 255) / 255.0;
        const double turn = static_cast<double>(frame) / 44.0 * hz + look(2) / 255.0;
        return static_cast<std::uint8_t>(127.5 + 127.5 * std::sin(turn * 6.283185307));
    }
    case Moves::cues:
        break;
    }
    return static_cast<std::uint8_t>(look(cue - 1) + (look(cue) - look(cue - 1)) * share);
}

Result<std::uint64_t> write(const BenchRig& rig, dmx::Recorder& recorder) {
    const bool rests = rig.moves == Moves::cues;
    const std::int64_t steps = (rests ? kFade : rig.cue) / kFrame;
    microseconds flushed{0};
    std::uint64_t frames = 0;
    for (std::int64_t cue = 0; cue * rig.cue < rig.length && !interrupted(); ++cue)
        for (std::int64_t step = 1; step <= steps; ++step) {
            const microseconds time = cue * rig.cue + step * kFrame;
            if (time - flushed >= 100ms) {
                TRY_VOID(recorder.flush(time - 1us));
                flushed = time;
            }
            for (int universe = 1; universe <= rig.universes; ++universe, ++frames) {
                auto levels = std::make_shared<dmx::Levels>();
                for (int slot = 0; slot < rig.slots; ++slot)
                    (*levels)[static_cast<std::size_t>(slot)] =
                        level(rig, slot + 512 * universe, cue,
                              static_cast<double>(step) / static_cast<double>(steps), cue * steps + step);
                TRY_VOID(recorder.append({time, static_cast<std::uint16_t>(universe), 512, false, levels}));
            }
        }
    return frames;
}

Result<BenchRow> measure(const BenchRig& rig, const std::filesystem::path& path) {
    const auto start = Clock::now();
    std::uint64_t frames = 0;
    {
        TRY(dmx::Recorder recorder, dmx::Recorder::create(path));
        TRY(frames, write(rig, recorder));
        TRY_VOID(recorder.finish(rig.length));
    }
    const double write_s = seconds_since(start);
    const auto open_start = Clock::now();
    TRY(dmx::Recording recording, dmx::read_recording(path));
    const double open_s = seconds_since(open_start);
    const std::size_t blocks = recording.blocks();
    dmx::Player player(std::move(recording));
    std::vector<double> seeks_s;
    std::uint64_t place = 88172645463325252ull; // xorshift
    for (int i = 0; i < kSeeks && !interrupted(); ++i) {
        place ^= place << 13;
        place ^= place >> 7;
        place ^= place << 17;
        const double t_s = static_cast<double>(place % 1'000'000) * 1e-6 * player.duration_s();
        const auto seek = Clock::now();
        (void)player.at(t_s);
        seeks_s.push_back(seconds_since(seek));
    }
    std::sort(seeks_s.begin(), seeks_s.end());
    const double hours = std::chrono::duration<double, std::ratio<3600>>(rig.length).count();
    const double bytes = static_cast<double>(std::filesystem::file_size(path));
    BenchRow row;
    row.table = "recording";
    row.name = rig.name;
    row.figures = {{"hours", hours},
                   {"universes", rig.universes},
                   {"frames", static_cast<double>(frames)},
                   {"mb", bytes * 1e-6},
                   {"mb_per_universe_hour", bytes * 1e-6 / hours / rig.universes},
                   {"bytes_per_frame", bytes / static_cast<double>(std::max<std::uint64_t>(frames, 1))},
                   {"write_s", write_s},
                   {"open_ms", 1e3 * open_s},
                   {"seek_p50_ms", 1e3 * seeks_s[seeks_s.size() / 2]},
                   {"seek_p99_ms", 1e3 * seeks_s[seeks_s.size() * 99 / 100]},
                   {"blocks", static_cast<double>(blocks)},
                   {"index_kb", static_cast<double>(blocks * sizeof(dmx::ghostdmx::BlockPlace)) * 1e-3}};
    row.note = rig.note;
    return row;
}

} // namespace

Result<void> bench_recording(const BenchOptions&, const BenchSink& sink) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() /
                            ("ghostlight_bench_" + std::to_string(Clock::now().time_since_epoch().count()));
    fs::create_directories(folder);
    Result<void> done;
    for (const BenchRig& rig : kRigs) {
        if (interrupted()) break;
        const auto row = measure(rig, folder / "bench.ghostdmx");
        if (!row.ok()) done = row.error();
        if (!row.ok()) break;
        sink(*row);
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return done;
}

} // namespace ghost::app
