// SPDX-License-Identifier: Apache-2.0
// ghostlight record: what a desk sends, with time stamps, into a recording. Every change that arrives is
// written; what the disk cannot take at once waits in memory.
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "base/steady_time.h"
#include "cli/commands.h"
#include "cli/options/input_options.h"
#include "cli/options/number_option.h"
#include "dmx/receive/receiver.h"
#include "dmx/record/recording_tasks.h"
#include "live/inputs/running_recording.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace ghost::app {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr nanoseconds kLookEvery = 5ms;

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

double seconds_between(nanoseconds from, nanoseconds to) {
    return std::chrono::duration<double>(to - from).count();
}

// Until its time is over or the user says so. seconds: that it lasted.
Result<dmx::Statistics> record_into(RunningRecording& recording, const RecordOptions& options,
                                    dmx::ReceiverOptions input, double& seconds) {
    input.on_levels = [&](const dmx::Universes& universes, nanoseconds now) {
        recording.put(universes, now);
    };
    TRY(auto receiver, dmx::Receiver::start(input));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    catch_interrupts();
    log_info("recording to " + options.output + ", Ctrl-C ends it");

    dmx::Statistics statistics;
    const nanoseconds begin = steady_now();
    while (!interrupted()) {
        const nanoseconds now = steady_now();
        if (recording.has_begun() && options.seconds > 0.0 && recording.seconds(now) >= options.seconds)
            break;
        if (!recording.has_begun() && options.wait_s > 0.0 && seconds_between(begin, now) >= options.wait_s)
            return Error{"no DMX arrived within " + std::to_string(static_cast<int>(options.wait_s)) +
                             " s; ghostlight monitor shows what the network brings",
                         options.output};
        if (auto newest = receiver->take_statistics()) statistics = std::move(*newest);
        TRY_VOID(recording.write(now));
        std::this_thread::sleep_for(kLookEvery);
    }
    receiver.reset();
    const nanoseconds end = steady_now();
    TRY_VOID(recording.finish(end));
    seconds = recording.seconds(end);
    return statistics;
}

int record(const RecordOptions& options) {
    if (options.quiet) set_log_level(LogLevel::error);
    const auto input = receiver_options(options.input);
    if (!input.ok()) return failed(input.error(), 2);
    auto recording = RunningRecording::create(options.output, dmx::asked_universes(*input));
    if (!recording.ok()) return failed(recording.error(), 1);
    const dmx::Recorder& recorder = (*recording)->recorder();
    log_kept(recorder);
    double seconds = 0;
    const auto statistics = record_into(**recording, options, *input, seconds);
    if (!statistics.ok()) return failed(statistics.error(), 1);
    const std::uint64_t lost = (*recording)->lost();
    const std::size_t left_out = (*recording)->left_out();
    if (options.json) {
        const nlohmann::ordered_json report{{"file", options.output},
                                            {"seconds", seconds},
                                            {"frames", recorder.frames()},
                                            {"bytes", recorder.bytes()},
                                            {"missed", statistics->merge.missed},
                                            {"kernel_overflow", statistics->overflow},
                                            {"frames_lost", lost},
                                            {"universes_left_out", left_out}};
        print_text("%s\n", report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    }
    char text[160];
    std::snprintf(text, sizeof text, ": %.1f s, %zu frames, %.1f kB, %llu packets missed", seconds,
                  recorder.frames(), static_cast<double>(recorder.bytes()) / 1000.0,
                  static_cast<unsigned long long>(statistics->merge.missed));
    log_info(options.output + text);
    if (lost == 0) return 0;
    return failed(
        {std::to_string(lost) + " frames are lost: the disk was too slow for too long", options.output}, 1);
}

} // namespace

void add_record(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App* command =
        app.add_subcommand("record", "record DMX with time stamps (.ghostdmx, or .show: OLA show file)");
    command->footer(
        "Example: ghostlight record -o tour.ghostdmx --universes 1-2 --seconds 90\n"
        "While it runs the file is called tour.ghostdmx.part; after a crash that one is playable.");
    command
        ->add_option("-o,--output", options->output,
                     "file to write: .ghostdmx (small, days long), or .show or .txt for an OLA show file")
        ->required();
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
