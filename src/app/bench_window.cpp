// SPDX-License-Identifier: Apache-2.0
// The window under the load of a desk: it draws as fast as it wants, and its own counters say how late a
// packet is seen and what the window itself costs.
#include "app/bench.h"
#include "app/interrupt.h"
#include "app/loaded_window.h"

namespace ghost::app {
namespace {

constexpr double kWarm_s = 4;
constexpr double kSeconds = 15;

} // namespace

Result<void> bench_window(const BenchOptions& options, const BenchSink& sink) {
    if (options.soak_seconds > 0) return window_soak(options, sink);
    const std::filesystem::path outcome = loaded_window_file(".json");
    LoadedWindow window;
    window.script = "wait opened\nfigures\nwait " + std::to_string(kWarm_s) + "\nreset-figures\nwait " +
                    std::to_string(kSeconds) + "\nstate \"" + outcome.string() + "\"\nquit\n";
    TRY(const bool into_memory, run_loaded_window(options, window));
    if (interrupted()) return Error{"interrupted", "window"};
    TRY(const nlohmann::json state, take_state(outcome));
    const char* const kPackets = "packet_to_window_ms";
    BenchRow row;
    row.table = "window";
    row.name = std::to_string(LoadedWindow::kWidth) + "x" + std::to_string(LoadedWindow::kHeight) + ", 44 Hz";
    row.figures = {{"pictures_per_s", state_number(state, "picture", "pictures_per_s")},
                   {"packets", state_number(state, kPackets, "count")},
                   {"packet_p50_ms", state_number(state, kPackets, "p50")},
                   {"packet_p99_ms", state_number(state, kPackets, "p99")},
                   {"packet_max_ms", state_number(state, kPackets, "max")},
                   {"window_p50_ms", state_number(state, "window_ms", "p50")},
                   {"window_p99_ms", state_number(state, "window_ms", "p99")},
                   {"draw_ms", state_number(state, "picture", "draw_ms")}};
    row.note = std::string(into_memory ? "drawn into memory" : "on the display") +
               ", picture of the last frame " +
               state["picture"]["camera"].value("width", nlohmann::json()).dump() + "x" +
               state["picture"]["camera"].value("height", nlohmann::json()).dump();
    sink(row);
    return {};
}

} // namespace ghost::app
