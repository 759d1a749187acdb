// SPDX-License-Identifier: Apache-2.0
// The window as somebody opens it who has no desk yet: how long until the show is there, its first picture,
// and the picture with all its pixels and shadows.
#include "bench/window/private/window_opening.h"

#include "base/interrupt.h"
#include "bench/festival.h"
#include "bench/window/private/loaded_window.h"

#include <chrono>
#include <cmath>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

Result<void> measure(const BenchOptions& options, const std::string& name, const BenchSink& sink) {
    const fs::path opened = bench_file("-opened.json"), first = bench_file("-first.json"),
                   whole = bench_file("-whole.json");
    LoadedWindow window;
    window.has_desk = false;
    window.script = "wait opened\nstate \"" + opened.string() + "\"\nfreeze on\nwait picture\nstate \"" +
                    first.string() + "\"\nwait settled\nstate \"" + whole.string() + "\"\nquit\n";
    const auto begun = fs::file_time_type::clock::now();
    TRY(const bool into_memory, run_loaded_window(options, window));
    if (interrupted()) return Error{"interrupted", "window"};
    const auto after_s = [&](const fs::path& file) {
        std::error_code code;
        const auto written = fs::last_write_time(file, code);
        return code ? std::nan("") : std::chrono::duration<double>(written - begun).count();
    };
    BenchRow row;
    row.table = "window";
    row.name = "opening " + name;
    row.figures = {{"opened_s", after_s(opened)},
                   {"first_picture_s", after_s(first)},
                   {"whole_picture_s", after_s(whole)}};
    TRY_VOID(take_state(opened)); // the file goes
    TRY_VOID(take_state(first));
    TRY(const nlohmann::json end, take_state(whole));
    const auto camera = end["picture"]["camera"];
    row.figures.insert(row.figures.end(), {{"width", camera.value("width", 0.0)},
                                           {"height", camera.value("height", 0.0)},
                                           {"picture_share", picture_share(end)},
                                           {"loop_p99_ms", state_number(end, "event_loop_ms", "p99")},
                                           {"loop_max_ms", state_number(end, "event_loop_ms", "max")}});
    row.note = into_memory ? "drawn into memory" : "on the display";
    sink(row);
    return {};
}

} // namespace

Result<void> window_opening(const BenchOptions& options, const BenchSink& sink) {
    TRY_VOID(measure(options, "the show", sink));
    TRY(const Festival festival, Festival::make(400));
    BenchOptions there = options;
    there.show = festival.folder();
    TRY_VOID(measure(there, "a festival of 400", sink));
    if (options.plot.empty()) return {};
    there.show = options.plot;
    return measure(there, fs::path(options.plot).filename().string(), sink);
}

} // namespace ghost::app
