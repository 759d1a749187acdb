// SPDX-License-Identifier: Apache-2.0
// The window open for as long as wanted, with a desk at 44 Hz and a person who does the same things every
// minute: looks around, takes lights by hand and gives them back, measures, opens and closes panels. One row
// a minute. What proves it: packets go on being seen, and memory stays flat after the first minutes; the last
// row says so, and what does not hold is an error.
#include "base/interrupt.h"
#include "bench/window/private/loaded_window.h"
#include "bench/window/private/memory_growth.h"
#include "bench/window/window_tables.h"

#include "base/memory.h"
#include "base/progress.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRow_s = 60;
// At most a third of the time: caches, heaps and what is made when first used.
constexpr double kSoakWarm_s = 600;
constexpr double kBusy_s = 25; // of each row
// From half to half of what comes after the warm-up. A picture of this window is 1.6 MB; 200 bytes a picture
// that stay would be 7 MB in half an hour.
constexpr double kMostWindowGrowth_mb = 5;

// What a person does; each line that changes the look is undone.
constexpr const char* kWork = "camera 1\nwait 3\norbit 30 -5\nwait 2\nselect *\npanel-values on\nwait 3\n"
                              "intensity 0.7\nzoom 30\nwait 2\nundo\nundo\nselect-none\n"
                              "false-colour lux\nprobe 200 200\nwait 3\nprobe off\nfalse-colour off\n"
                              "panel-network on\nwait 3\npanel-network off\n"
                              "smoke 2\nwait 2\nundo\ncamera 1\nwait 2\n";

// Memory goes with the picture's size: each row is of the same one.
constexpr const char* kSameSize = "resolution 25\nwait 4\n";

std::string script_of(double seconds, const std::string& outcome) {
    std::string script = "wait opened\n";
    for (double begin_s = 0; begin_s < seconds; begin_s += kRow_s) {
        const double rest_s = std::min(kRow_s, seconds - begin_s) - kBusy_s;
        script += "reset-figures\n";
        if (rest_s > 0) script += kWork;
        script += "wait " + std::to_string(rest_s > 0 ? rest_s : rest_s + kBusy_s) + "\n" + kSameSize +
                  "state \"" + outcome + "\"\nwait 1\nresolution 0\n";
    }
    return script + "quit\n";
}

double pixels(const nlohmann::json& state) {
    const auto picture = state.value("picture", nlohmann::json::object());
    const auto camera = picture.value("camera", nlohmann::json::object());
    return camera.value("width", 0.0) * camera.value("height", 0.0);
}

} // namespace

Result<void> window_soak(const BenchOptions& options, const BenchSink& sink) {
    const std::filesystem::path outcome = bench_file(".json");
    const auto start = Clock::now();
    const auto passed_s = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    std::vector<MemoryRow> memory;
    std::size_t warm_rows = 0;
    double worst_p99_ms = 0;
    bool all_heard = true;
    Progress progress("soak", Progress::style_for_stderr(), 0.0);
    LoadedWindow window;
    window.script = script_of(options.soak_seconds, outcome.string());
    window.on_tick = [&] {
        progress.update(std::min(passed_s() / options.soak_seconds, 1.0), passed_s(), "");
        const auto state = take_state(outcome);
        if (!state.ok()) return; // not yet
        memory.push_back(
            {static_cast<double>(used_memory_bytes()) * 1e-6, state_number(*state, "picture", "device_mb")});
        if (passed_s() < std::min(kSoakWarm_s, options.soak_seconds / 3)) warm_rows = memory.size();
        const double packets = state_number(*state, "packet_to_window_ms", "count"),
                     p99_ms = state_number(*state, "packet_to_window_ms", "p99");
        all_heard = all_heard && packets > 0;
        worst_p99_ms = std::max(worst_p99_ms, p99_ms);
        BenchRow row;
        row.table = "window";
        row.name = "minute " + std::to_string(memory.size());
        row.figures = {{"pictures_per_s", state_number(*state, "picture", "pictures_per_s")},
                       {"packets", packets},
                       {"packet_p50_ms", state_number(*state, "packet_to_window_ms", "p50")},
                       {"packet_p99_ms", p99_ms},
                       {"packet_max_ms", state_number(*state, "packet_to_window_ms", "max")},
                       {"window_p50_ms", state_number(*state, "window_ms", "p50")},
                       {"window_p99_ms", state_number(*state, "window_ms", "p99")},
                       {"megapixels", pixels(*state) * 1e-6},
                       {"memory_mb", memory.back().process_mb},
                       {"device_mb", memory.back().device_mb}};
        row.note = clock_text(passed_s());
        progress.finish();
        sink(row);
    };
    TRY(const bool into_memory, run_loaded_window(options, window));
    progress.finish();
    const double ran_s = passed_s();
    if (interrupted() || ran_s < options.soak_seconds)
        return Error{"ended after " + clock_text(ran_s) + " of " + clock_text(options.soak_seconds), "soak"};
    if (memory.size() < warm_rows + 2)
        return Error{"too short to tell: two rows after the first third are the least, three minutes",
                     "soak"};
    const std::optional<double> growth_mb = memory_growth_mb(memory, warm_rows);
    if (!growth_mb)
        return Error{"no minute of the second half had pictures of the size of one of the first: the machine "
                     "was never as busy again",
                     "soak"};
    const bool flat = *growth_mb <= kMostWindowGrowth_mb;
    BenchRow row;
    row.table = "window";
    row.name = "soak of " + clock_text(ran_s);
    row.figures = {{"worst_packet_p99_ms", worst_p99_ms},
                   {"memory_mb", memory.back().process_mb},
                   {"memory_growth_mb", *growth_mb}};
    row.note =
        std::string(flat && all_heard ? "holds: packets seen every minute, memory flat" : "does not hold") +
        (into_memory ? ", drawn into memory" : ", on the display");
    sink(row);
    if (!all_heard) return Error{"there was a minute in which no packet was seen", "soak"};
    if (!flat)
        return Error{"memory grew by " + std::to_string(*growth_mb) +
                         " MB in half of the time after the first " + std::to_string(warm_rows) +
                         " minutes, expected " + std::to_string(kMostWindowGrowth_mb) + " at most",
                     "soak"};
    return {};
}

} // namespace ghost::app
