// SPDX-License-Identifier: Apache-2.0
// ghostlight record: what a desk sends, with time stamps, into a recording. Every change that arrives is
// written; what the disk cannot take at once waits in memory.
#include "app/commands.h"
#include "app/input_options.h"
#include "app/interrupt.h"
#include "app/number_option.h"
#include "app/recordings.h"
#include "base/log.h"
#include "dmx/changes.h"
#include "dmx/receiver.h"
#include "dmx/recorder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace ghost::app {

namespace {

using namespace std::chrono_literals;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

constexpr std::size_t kMaxWaiting = 1'000'000; // frames: 0.6 GB, 45 s of 512 universes
constexpr microseconds kFlushEvery = 100ms;    // what a crash costs at most
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

nanoseconds steady_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

double seconds_between(nanoseconds from, nanoseconds to) {
    return std::chrono::duration<double>(to - from).count();
}

// Frames on their way from the receiver's thread to the one that writes.
class Waiting {
public:
    void put(const dmx::Universes& universes, nanoseconds now) {
        const std::lock_guard lock(mutex_);
        const std::size_t before = frames_.size();
        changes_.find(universes, now, frames_);
        if (frames_.size() <= kMaxWaiting) return;
        const std::size_t kept = std::max(before, kMaxWaiting);
        lost_ += frames_.size() - kept;
        frames_.resize(kept);
    }
    std::vector<dmx::RecordedFrame> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(frames_, {});
    }
    std::uint64_t lost() {
        const std::lock_guard lock(mutex_);
        return lost_;
    }

private:
    std::mutex mutex_;
    dmx::Changes changes_;
    std::vector<dmx::RecordedFrame> frames_;
    std::uint64_t lost_ = 0;
};

// A recording holds dmx::kMaxRecordedUniverses. Those that were asked for always have their place, others as
// long as there is one.
class Places {
public:
    explicit Places(std::vector<std::uint16_t> asked)
        : asked_(std::move(asked)), free_(dmx::kMaxRecordedUniverses - asked_.size()) {
        std::sort(asked_.begin(), asked_.end());
    }
    bool has(std::uint16_t universe) {
        if (std::binary_search(asked_.begin(), asked_.end(), universe) || others_.contains(universe))
            return true;
        if (others_.size() < free_) return others_.insert(universe).second;
        if (left_out_.empty())
            log_warning("more than " + std::to_string(dmx::kMaxRecordedUniverses) +
                        " universes arrive, as many as a recording holds; those that come now are left out. "
                        "--universes says which are to be recorded");
        left_out_.insert(universe);
        return false;
    }
    std::size_t left_out() const { return left_out_.size(); }

private:
    std::vector<std::uint16_t> asked_;
    std::size_t free_;
    std::set<std::uint16_t> others_, left_out_;
};

struct Recorded {
    double seconds = 0.0;
    dmx::Statistics statistics;
    std::uint64_t lost = 0;
    std::size_t universes_left_out = 0;
};

Result<Recorded> record_into(dmx::Recorder& recorder, const RecordOptions& options,
                             dmx::ReceiverOptions input) {
    Waiting waiting;
    input.on_levels = [&](const dmx::Universes& universes, nanoseconds now) { waiting.put(universes, now); };
    TRY(auto receiver, dmx::Receiver::start(input));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    catch_interrupts();
    log_info("recording to " + options.output + ", Ctrl-C ends it");

    Recorded result;
    Places places(dmx::announced_universes(input.universes));
    const nanoseconds begin = steady_now();
    std::optional<microseconds> first;
    microseconds last{0}, flushed{0}; // since first
    const auto write_waiting = [&]() -> Result<void> {
        for (dmx::RecordedFrame& frame : waiting.take()) {
            if (!places.has(frame.universe)) continue;
            if (!first) {
                first = frame.time;
                const nanoseconds ago = steady_now() - frame.time;
                recorder.began(std::chrono::floor<microseconds>(
                    std::chrono::system_clock::now().time_since_epoch() - ago));
            }
            frame.time = last = frame.time - *first;
            TRY_VOID(recorder.append(frame));
        }
        return {};
    };
    while (!interrupted()) {
        const nanoseconds now = steady_now();
        if (first && options.seconds > 0.0 && seconds_between(*first, now) >= options.seconds) break;
        if (!first && options.wait_s > 0.0 && seconds_between(begin, now) >= options.wait_s)
            return Error{"no DMX arrived within " + std::to_string(static_cast<int>(options.wait_s)) +
                             " s; ghostlight monitor shows what the network brings",
                         options.output};
        if (auto newest = receiver->take_statistics()) result.statistics = std::move(*newest);
        TRY_VOID(write_waiting());
        // Frames up to this moment may still be on their way; those of a tenth of a second ago are not.
        const microseconds safe = first ? std::chrono::floor<microseconds>(now) - *first - kFlushEvery : 0us;
        if (first && safe - flushed >= kFlushEvery) {
            TRY_VOID(recorder.flush(std::max(safe, last)));
            flushed = safe;
        }
        std::this_thread::sleep_for(kLookEvery);
    }
    receiver.reset();
    TRY_VOID(write_waiting());
    if (!first) return Error{"nothing was recorded: no DMX arrived", options.output};
    result.lost = waiting.lost();
    result.universes_left_out = places.left_out();
    const microseconds end = std::max(last, std::chrono::floor<microseconds>(steady_now()) - *first);
    TRY_VOID(recorder.finish(end));
    result.seconds = std::chrono::duration<double>(end).count();
    return result;
}

int record(const RecordOptions& options) {
    if (options.quiet) set_log_level(LogLevel::error);
    const auto input = receiver_options(options.input);
    if (!input.ok()) return failed(input.error(), 2);
    auto recorder = dmx::Recorder::create(options.output);
    if (!recorder.ok()) return failed(recorder.error(), 1);
    log_kept(*recorder);
    const auto recorded = record_into(*recorder, options, *input);
    if (!recorded.ok()) return failed(recorded.error(), 1);
    if (options.json) {
        const nlohmann::ordered_json report{{"file", options.output},
                                            {"seconds", recorded->seconds},
                                            {"frames", recorder->frames()},
                                            {"bytes", recorder->bytes()},
                                            {"missed", recorded->statistics.merge.missed},
                                            {"kernel_overflow", recorded->statistics.overflow},
                                            {"frames_lost", recorded->lost},
                                            {"universes_left_out", recorded->universes_left_out}};
        std::printf("%s\n", report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    }
    char text[160];
    std::snprintf(text, sizeof text, ": %.1f s, %zu frames, %.1f kB, %llu packets missed", recorded->seconds,
                  recorder->frames(), static_cast<double>(recorder->bytes()) / 1000.0,
                  static_cast<unsigned long long>(recorded->statistics.merge.missed));
    log_info(options.output + text);
    if (recorded->lost == 0) return 0;
    return failed({std::to_string(recorded->lost) + " frames are lost: the disk was too slow for too long",
                   options.output},
                  1);
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
