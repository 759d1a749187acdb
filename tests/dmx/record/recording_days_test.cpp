// SPDX-License-Identifier: Apache-2.0
// A recording of three days, written with a clock of its own: size, time to seek and memory are printed; that
// memory stays flat is a gate, the times are none.
#include "dmx/record/recorder.h"
#include "sanitize/kept_freed.h"
#include "support/test_recording.h"

#include <cmath>
#include <cstdio>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

// Resident memory of this process, MB.
double memory_mb() {
    std::ifstream status("/proc/self/statm");
    long total = 0, resident = 0;
    status >> total >> resident;
    return static_cast<double>(resident) * 4096e-6;
}

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Every minute a fade of three seconds on four universes of 200 slots in use, 44 looks a second; else still.
struct Days {
    std::chrono::microseconds length = 72h;
    int universes = 4;

    static std::uint8_t level(std::int64_t cue, std::size_t slot) {
        return static_cast<std::uint8_t>(
            static_cast<std::uint64_t>(cue * 2654435761 + static_cast<int>(slot) * 40503) >> 9);
    }
    std::shared_ptr<const Levels> look(std::int64_t cue, double share) const {
        auto levels = std::make_shared<Levels>();
        for (std::size_t slot = 0; slot < 200; ++slot) {
            const int from = level(cue - 1, slot), to = level(cue, slot);
            (*levels)[slot] = static_cast<std::uint8_t>(from + static_cast<int>((to - from) * share));
        }
        return levels;
    }
    template <class Append>
    std::uint64_t play(const Append& append) const {
        std::uint64_t frames = 0;
        for (std::int64_t cue = 0; cue * 60s < length; ++cue)
            for (int step = 1; step <= 132; ++step)
                for (int universe = 1; universe <= universes; ++universe) {
                    append(cue * 60s + step * 22727us + universe * 11us, universe,
                           look(cue + universe, step / 132.0));
                    ++frames;
                }
        return frames;
    }
};

TEST(RecordingOfDays, is_small_seeks_fast_and_needs_little_memory) {
    const TestFolder folder;
    const Days days;
    const std::filesystem::path path = folder.path / "days.ghostdmx";
    const double memory_before_mb = memory_mb();
    double most_mb = memory_before_mb;
    std::uint64_t frames = 0;
    const double write_start_s = now_s();
    {
        auto recorder = Recorder::create(path);
        ASSERT_TRUE(recorder.ok());
        std::chrono::microseconds flushed{0};
        std::size_t flushes = 0;
        frames = days.play([&](std::chrono::microseconds time, int universe,
                               std::shared_ptr<const Levels> levels) {
            if (time - flushed >= 100ms) { // as record does
                EXPECT_TRUE(recorder->flush(time - 1us).ok());
                flushed = time;
                if (++flushes % 1000 == 0) most_mb = std::max(most_mb, memory_mb());
            }
            EXPECT_TRUE(
                recorder->append({time, static_cast<std::uint16_t>(universe), 200, false, std::move(levels)})
                    .ok());
        });
        ASSERT_TRUE(recorder->finish(days.length).ok());
    }
    const double write_s = now_s() - write_start_s;
    const double size_mb = static_cast<double>(std::filesystem::file_size(path)) * 1e-6;

    double start_s = now_s();
    auto recording = read_recording(path);
    ASSERT_TRUE(recording.ok()) << recording.error().text();
    const double open_s = now_s() - start_s;
    EXPECT_EQ(recording->frames(), frames);
    EXPECT_EQ(recording->duration(), days.length);
    const std::size_t blocks = recording->blocks();
    Player player(std::move(*recording));
    std::mt19937 random(1);
    double slowest_s = 0.0, sum_s = 0.0;
    constexpr int kSeeks = 500;
    for (int i = 0; i < kSeeks; ++i) {
        const double t_s = 60.0 + static_cast<double>(random() % 259'100'000) * 1e-3;
        start_s = now_s();
        const Universes look = player.at(t_s);
        const double took_s = now_s() - start_s;
        slowest_s = std::max(slowest_s, took_s);
        sum_s += took_s;
        if (i % 50 == 0) most_mb = std::max(most_mb, memory_mb());
        ASSERT_EQ(look.list.size(), 4u);
        const auto cue = static_cast<std::int64_t>(t_s / 60.0);
        const double in_cue_s = t_s - static_cast<double>(cue) * 60.0;
        if (in_cue_s < 3.1) continue; // fading
        for (const Universe& universe : look.list)
            ASSERT_EQ(*universe.levels, *days.look(cue + universe.number, 1.0)) << t_s;
    }
    start_s = now_s();
    for (double t_s = 0.0; t_s < player.duration_s(); t_s += 0.5) {
        (void)player.at(t_s);
        if (std::fmod(t_s, 1000.0) < 0.5) most_mb = std::max(most_mb, memory_mb());
    }
    const double walk_s = now_s() - start_s;
    // Without its index, as after a crash.
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1000);
    start_s = now_s();
    auto crashed = read_recording(path);
    const double scan_s = now_s() - start_s;
    ASSERT_TRUE(crashed.ok());
    EXPECT_EQ(crashed->problems.size(), 1u);
    EXPECT_GT(crashed->duration(), days.length - 10min);

    std::printf("three days, %llu frames: %.1f MB (%.1f bytes a frame), %zu blocks; written in %.1f s; "
                "opened in %.1f ms, "
                "without its index in %.0f ms; a seek takes %.2f ms, at most %.2f ms; played at 2 Hz in %.1f "
                "s; memory "
                "%.1f MB over the %.1f MB before\n",
                static_cast<unsigned long long>(frames), size_mb, size_mb * 1e6 / static_cast<double>(frames),
                blocks, write_s, open_s * 1e3, scan_s * 1e3, sum_s / kSeeks * 1e3, slowest_s * 1e3, walk_s,
                most_mb - memory_before_mb, memory_before_mb);
    EXPECT_LT(most_mb - memory_before_mb, 48.0 + kKeptFreed_mb); // the frames are 1.2 GB
    EXPECT_LT(size_mb, 200.0);
}

} // namespace
} // namespace ghost::dmx
