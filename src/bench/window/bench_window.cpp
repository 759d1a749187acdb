// SPDX-License-Identifier: Apache-2.0
// The window under the load of a desk, a row for each kind of work: it draws as fast as it wants, and its own
// counters say how late a change is seen and how long its event loop was busy at a stretch.
#include "base/interrupt.h"
#include "bench/bench.h"
#include "bench/festival.h"
#include "bench/window/private/loaded_window.h"
#include "bench/window/private/window_opening.h"
#include "bench/window/window_tables.h"

#include "base/memory.h"

#include <cmath>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr double kWarm_s = 4;
constexpr double kMeasured_s = 15;

Result<void> bake_first_camera(const BenchOptions& options) {
    SessionOptions session;
    session.show = options.show;
    session.device = options.device;
    session.quiet = true;
    TRY_VOID(open_session(session));
    return {};
}

// Links of bounced light, which the window would make beside its pictures.
Result<void> make_links(const BenchOptions& options, scene::BounceDetail bounce) {
    SessionOptions opening;
    opening.show = options.show;
    opening.device = options.device;
    opening.quiet = true;
    opening.live = true;
    opening.bounce = bounce;
    TRY(const std::unique_ptr<Session> session, open_session(opening));
    session->bounce->wait_for_links(true);
    if (std::optional<Error> failure = session->bounce->take_failure()) return *failure;
    return {};
}

// Between the show's cameras, without a rest.
std::string flight() {
    constexpr double kTravel_s = 0.9;
    std::string lines;
    for (int way = 0; way * kTravel_s < kMeasured_s; ++way)
        lines += "camera " + std::to_string(1 + (way + 1) % 3) + "\nwait " + std::to_string(kTravel_s) + "\n";
    return lines;
}

struct Work {
    std::string name;
    std::string before;                          // lines of a script, once the show is open
    std::string lines;                           // while it is measured; empty: nothing but the desk
    std::optional<scene::BounceDetail> bounce{}; // instead of the show's
};

Result<void> measure(const BenchOptions& options, const Work& work, const BenchSink& sink) {
    const fs::path outcome = bench_file(".json"), begun = bench_file("-begun.json");
    LoadedWindow window;
    window.bounce = work.bounce;
    window.script = "wait opened\nstate \"" + begun.string() + "\"\n" + work.before + "wait " +
                    std::to_string(kWarm_s) + "\nreset-figures\n" +
                    (work.lines.empty() ? "wait " + std::to_string(kMeasured_s) + "\n" : work.lines) +
                    "state \"" + outcome.string() + "\"\nquit\n";
    TRY(const bool into_memory, run_loaded_window(options, window));
    if (interrupted()) return Error{"interrupted", "window"};
    TRY(const nlohmann::json opened, take_state(begun));
    TRY(const nlohmann::json state, take_state(outcome));
    const char *const kPackets = "packet_to_window_ms", *const kLoop = "event_loop_ms";
    const auto camera = state["picture"]["camera"];
    const auto side = [&](const char* name) { return camera.value(name, 0.0); };
    BenchRow row;
    row.table = "window";
    row.name = work.name;
    row.figures = {{"pictures_per_s", state_number(state, "window_ms", "count") / kMeasured_s},
                   {"width", side("width")},
                   {"height", side("height")},
                   {"packets", state_number(state, kPackets, "count")},
                   {"packet_p50_ms", state_number(state, kPackets, "p50")},
                   {"packet_p99_ms", state_number(state, kPackets, "p99")},
                   {"packet_max_ms", state_number(state, kPackets, "max")},
                   {"window_p50_ms", state_number(state, "window_ms", "p50")},
                   {"window_p99_ms", state_number(state, "window_ms", "p99")},
                   {"picture_share", picture_share(state)},
                   {"loop_p99_ms", state_number(state, kLoop, "p99")},
                   {"loop_max_ms", state_number(state, kLoop, "max")},
                   {"loop_max_opening_ms", state_number(opened, kLoop, "max")},
                   {"draw_p50_ms", state_number(state, "draws_ms", "p50")},
                   {"draw_p99_ms", state_number(state, "draws_ms", "p99")},
                   {"memory_mb", static_cast<double>(used_memory_bytes()) * 1e-6}};
    row.note = std::string(into_memory ? "drawn into memory" : "on the display") + ", " +
               state["picture"].value("supply", "");
    sink(row);
    return {};
}

} // namespace

Result<void> bench_window(const BenchOptions& options, const BenchSink& sink) {
    if (options.soak_seconds > 0) return window_soak(options, sink);
    TRY_VOID(window_opening(options, sink));
    TRY_VOID(measure(options, {"free camera", "camera 1\nbaked off\n", ""}, sink));
    constexpr scene::BounceDetail kBounce = scene::BounceDetail::normal;
    TRY_VOID(make_links(options, kBounce));
    TRY_VOID(measure(options, {"free camera, light bounces", "camera 1\nbaked off\n", "", kBounce}, sink));
    TRY_VOID(bake_first_camera(options));
    TRY_VOID(measure(options, {"baked camera", "camera 1\nbaked on\npanel-fixtures on\n", ""}, sink));
    TRY_VOID(measure(options, {"camera that flies", "baked off\n", flight()}, sink));
    for (const int fixtures : {60, 400}) {
        TRY(const Festival festival, Festival::make(fixtures));
        BenchOptions there = options;
        there.show = festival.folder();
        TRY_VOID(measure(there, {"festival of " + std::to_string(fixtures), "", ""}, sink));
    }
    return {};
}

} // namespace ghost::app
