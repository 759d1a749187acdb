// SPDX-License-Identifier: Apache-2.0
// ghostlight record: what a desk sends, with time stamps, into an OLA show file.
#include "app/commands.h"
#include "app/input_options.h"
#include "app/interrupt.h"
#include "app/number_option.h"
#include "base/log.h"
#include "dmx/receiver.h"
#include "dmx/recording.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

namespace ghost::app {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

struct RecordOptions {
    InputOptions input;
    std::string output;
    double seconds = 0.0;
    double wait_s = 60.0;
    bool json = false;
    bool quiet = false;
};

int failed(const Error& error, int code) {
    log_error(error.text());
    return code;
}

nanoseconds newest_arrival(const dmx::Universes& universes) {
    nanoseconds newest{0};
    for (const dmx::Universe& universe : universes.list) newest = std::max(newest, universe.arrival);
    return newest;
}

int record(const RecordOptions& options) {
    if (options.quiet) set_log_level(LogLevel::error);
    const auto input = receiver_options(options.input);
    if (!input.ok()) return failed(input.error(), 2);
    auto recorder = dmx::Recorder::create(options.output);
    if (!recorder.ok()) return failed(recorder.error(), 1);
    const auto receiver = dmx::Receiver::start(*input);
    if (!receiver.ok()) return failed(receiver.error(), 1);
    for (const std::string& warning : (*receiver)->warnings()) log_warning(warning);
    catch_interrupts();
    log_info("recording to " + options.output + ", Ctrl-C ends it");

    const auto steady = [] { return nanoseconds(std::chrono::steady_clock::now().time_since_epoch()); };
    const auto passed_s = [](nanoseconds from, nanoseconds to) {
        return std::chrono::duration<double>(to - from).count();
    };
    const nanoseconds begin = steady();
    std::optional<nanoseconds> first;
    nanoseconds last = begin;
    dmx::Statistics statistics;
    while (!interrupted()) {
        const nanoseconds now = steady();
        if (first && options.seconds > 0.0 && passed_s(*first, now) >= options.seconds) break;
        if (!first && options.wait_s > 0.0 && passed_s(begin, now) >= options.wait_s)
            return failed({"no DMX arrived within " + std::to_string(static_cast<int>(options.wait_s)) +
                               " s; ghostlight monitor shows what the network brings",
                           options.output},
                          1);
        if (auto newest = (*receiver)->take_statistics()) statistics = std::move(*newest);
        if (const auto universes = (*receiver)->take()) {
            last = std::max(last, newest_arrival(*universes));
            if (!first) first = last;
            const auto written = recorder->feed(*universes, last);
            if (!written.ok()) return failed(written.error(), 1);
        }
        std::this_thread::sleep_for(1ms);
    }
    if (!first) return failed({"nothing was recorded: no DMX arrived", options.output}, 1);
    const nanoseconds end = std::max(last, steady());
    const auto finished = recorder->finish(end);
    if (!finished.ok()) return failed(finished.error(), 1);
    const double duration_s = passed_s(*first, end);
    if (options.json) {
        const nlohmann::ordered_json report{{"file", options.output},
                                            {"seconds", duration_s},
                                            {"frames", recorder->frames()},
                                            {"bytes", recorder->bytes()},
                                            {"missed", statistics.merge.missed},
                                            {"kernel_overflow", statistics.overflow}};
        std::printf("%s\n", report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    }
    char text[160];
    std::snprintf(text, sizeof text, ": %.1f s, %zu frames, %.1f kB, %llu packets missed", duration_s,
                  recorder->frames(), static_cast<double>(recorder->bytes()) / 1000.0,
                  static_cast<unsigned long long>(statistics.merge.missed));
    log_info(options.output + text);
    return 0;
}

} // namespace

void add_record(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App* command = app.add_subcommand("record", "record DMX with time stamps (OLA show file)");
    command->footer("Example: ghostlight record -o tour.show --universes 1-2 --seconds 90\n"
                    "While it runs the file is called tour.show.part; after a crash that one is playable.");
    command->add_option("-o,--output", options->output, "file to write")->required();
    add_input_options(*command, options->input);
    command->add_option("--seconds", options->seconds, "length, from the first packet; default: until Ctrl-C")
        ->check(number_in(0.0, kLongest_s));
    command->add_option("--wait", options->wait_s, "give up when nothing arrives for this long, 0: never")
        ->check(number_in(0.0, kLongest_s))
        ->capture_default_str();
    command->add_flag("--json", options->json, "print a summary as one JSON object");
    command->add_flag("--quiet", options->quiet, "errors only");
    command->callback([options, &exit_code] { exit_code = record(*options); });
}

} // namespace ghost::app
