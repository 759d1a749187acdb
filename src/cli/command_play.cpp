// SPDX-License-Identifier: Apache-2.0
// ghostlight play: sends a recording as a desk would, sACN or Art-Net, or writes it, or a part of it, into a
// file of any format that is written.
#include "base/give_way.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "cli/commands.h"
#include "cli/options/input_options.h"
#include "cli/options/interface_option.h"
#include "cli/options/live_options.h"
#include "cli/options/number_option.h"
#include "dmx/receive/receiver.h"
#include "dmx/record/recording_tasks.h"
#include "dmx/send/sender.h"
#include "live/inputs/outlet.h"
#include "live/inputs/timecode_input.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace ghost::app {

namespace {

using nlohmann::ordered_json;

using Clock = std::chrono::steady_clock;

constexpr double kSlowest = 0.001, kFastest = 1000.0;

struct PlayOptions {
    std::string file;
    std::string output;
    std::string protocol = "sacn";
    dmx::SenderOptions send;
    dmx::CaptureOptions capture;
    double rate_hz = 44.0;
    double from_s = 0.0;
    double until_s = 0.0;
    double speed = 1.0;
    TimeCodeOptions timecode;
    std::string midi;
    double seconds = 0.0;
    bool loop = false;
    bool json = false;
    bool quiet = false;
};

int failed(const Error& error) {
    log_error(error.text());
    return 1;
}

void print_summary(const ordered_json& report) {
    print_text("%s\n", report.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
}

std::chrono::microseconds microseconds_of(double time_s) {
    const double longest_s = std::chrono::duration<double>(dmx::kLongestRecording).count();
    return std::chrono::microseconds(std::llround(std::min(time_s, longest_s) * 1e6));
}

// "1:02:03 long, recorded 2026-11-22 21:14:05 UTC"
std::string about(const dmx::Recording& recording) {
    std::string text = clock_text(std::chrono::duration<double>(recording.duration()).count()) + " long";
    const std::time_t begun = std::chrono::floor<std::chrono::seconds>(recording.unix_time()).count();
    char date[64];
    const std::tm* const utc = begun > 0 ? std::gmtime(&begun) : nullptr;
    if (utc && std::strftime(date, sizeof date, ", recorded %Y-%m-%d %H:%M:%S UTC", utc) > 0) text += date;
    return text;
}

int write(const PlayOptions& options) {
    dmx::PartOptions part;
    part.from = microseconds_of(options.from_s);
    if (options.until_s > 0.0) part.until = microseconds_of(options.until_s);
    part.speed = options.speed;
    const auto written = write_part(options.file, options.capture, part, options.output, options.quiet);
    if (!written.ok()) return failed(written.error());
    if (options.json)
        print_summary({{"file", options.output},
                       {"seconds", written->seconds},
                       {"frames", written->frames},
                       {"bytes", written->bytes}});
    char text[96];
    std::snprintf(text, sizeof text, ": %.3f s, %zu frames, %.1f kB", written->seconds, written->frames,
                  static_cast<double>(written->bytes) / 1000.0);
    log_info(options.output + text);
    return 0;
}

// Once when it changes.
void say(const dmx::ChaseStatus& status, dmx::ChaseStatus::State& said) {
    if (status.state == std::exchange(said, status.state)) return;
    const std::string text = dmx::chase_text(status);
    log_info(text.empty() ? "time code runs" : text);
}

// Sends what the time code wants until Ctrl-C: what it stands at, again and again.
Result<void> follow_timecode(const PlayOptions& options, dmx::Player& player, dmx::Sender& sender) {
    TRY(const std::unique_ptr<TimeCodeInput> timecode, open_timecode(options.timecode));
    dmx::ReceiverOptions listen;
    listen.interface = options.send.interface;
    listen.sacn = false;
    listen.artnet = options.midi.empty() && options.timecode.ltc.empty();
    listen.midi = options.midi;
    listen.answer_polls = false;
    // While we send Art-Net to its own port, the time code comes by that one.
    listen.artnet_port = options.capture.artnet_port;
    timecode->listen(listen);
    TRY(const auto receiver, dmx::Receiver::start(listen));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    log_info("following the time code; Ctrl-C ends it");
    const auto start = Clock::now();
    const double end_s = player.duration_s();
    Outlet outlet(sender, player, options.rate_hz);
    auto said = dmx::ChaseStatus::State::waits;
    for (auto now = start; !interrupted(); now = Clock::now()) {
        say(timecode->status(), said);
        if (options.seconds > 0.0 && now - start >= std::chrono::duration<double>(options.seconds)) break;
        const auto at_s = timecode->at_s(end_s);
        if (at_s) TRY_VOID(outlet.send(*at_s));
        outlet.wait(now, at_s.value_or(end_s), end_s);
    }
    if (!timecode->at_s(0.0)) log_warning("no time code arrived; ghostlight monitor shows what does");
    return outlet.end(options.file);
}

int send(PlayOptions options) {
    auto recording = open_recording(options.file, options.capture, options.quiet);
    if (!recording.ok()) return failed(recording.error());
    const std::string what = about(*recording);
    dmx::Player player(std::move(*recording));
    const double end_s =
        options.until_s > 0.0 ? std::min(options.until_s, player.duration_s()) : player.duration_s();
    if (options.from_s > end_s)
        return failed({"--from " + std::to_string(options.from_s) + " lies behind the end at " +
                           std::to_string(end_s) + " s",
                       options.file});
    options.send.protocol = options.protocol == "sacn" ? dmx::Protocol::sacn : dmx::Protocol::artnet;
    options.send.port = options.protocol == "sacn" ? options.capture.sacn_port : options.capture.artnet_port;
    auto sender = dmx::Sender::open(options.send);
    if (!sender.ok()) return failed(sender.error());
    catch_interrupts();
    go_first(); // a look comes late where something else has the processor
    log_info(options.file + ": " + what);
    if (!options.timecode.begin.empty()) {
        const auto followed = follow_timecode(options, player, *sender);
        if (!followed.ok()) return failed(followed.error());
        if (options.json)
            print_summary(
                {{"file", options.file}, {"packets", sender->packets()}, {"not_sent", sender->refused()}});
        return 0;
    }

    (void)player.at(options.from_s); // reading the file's first part takes longer than a look lasts
    const auto start = Clock::now();
    const double length_s = end_s - options.from_s; // of the recording; playing it takes that by the speed
    const bool bar = !options.quiet && !options.loop && Progress::style_for_stderr() == Progress::Style::bar;
    Outlet outlet(*sender, player, options.rate_hz, options.speed);
    Progress progress("playing", bar ? Progress::Style::bar : Progress::Style::silent, 0.0);
    double before_s = 0.0; // of the recording, in rounds that are over
    for (auto now = start; !interrupted(); now = Clock::now()) {
        const double passed_s = std::chrono::duration<double>(now - start).count();
        const double played_s = passed_s * options.speed - before_s;
        const double t_s = options.from_s + std::min(played_s, length_s);
        const bool over = played_s >= length_s;
        const auto sent = outlet.send(t_s);
        if (!sent.ok()) return failed(sent.error());
        progress.update(length_s > 0.0 ? (t_s - options.from_s) / length_s : 1.0, passed_s, clock_text(t_s));
        if (over && !options.loop) break;
        if (over && length_s > 0.0) {
            before_s += length_s * std::floor(played_s / length_s);
            outlet.rewind();
        } else {
            outlet.wait(now, t_s, end_s);
        }
    }
    progress.finish();
    const auto ended = outlet.end(options.file);
    if (!ended.ok()) return failed(ended.error());
    if (options.json)
        print_summary({{"file", options.file},
                       {"seconds", length_s},
                       {"packets", sender->packets()},
                       {"not_sent", sender->refused()}});
    log_info(options.file + ": " + std::to_string(sender->packets()) + " packets sent");
    return 0;
}

int play(const PlayOptions& options) {
    if (options.quiet) set_log_level(LogLevel::warning);
    if (options.until_s > 0.0 && options.until_s < options.from_s) {
        log_error("--until must be later than --from");
        return 2;
    }
    const auto ports = dmx::check_ports(options.capture.sacn_port, options.capture.artnet_port);
    const auto timecode = open_timecode(options.timecode);
    for (const Error* error :
         {ports.ok() ? nullptr : &ports.error(), timecode.ok() ? nullptr : &timecode.error()})
        if (error) {
            log_error(error->text());
            return 2;
        }
    return options.output.empty() ? send(options) : write(options);
}

} // namespace

void add_play(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App* command = app.add_subcommand(
        "play",
        "send a recording (.ghostdmx, OLA show file, pcap, pcapng) as sACN or Art-Net, or convert it");
    command->footer("Example: ghostlight play assets/demo/demo.show --to 127.0.0.1 --loop\n"
                    "         ghostlight play night.pcapng --from 3600 --until 3720 -o finale.ghostdmx");
    command->add_option("file", options->file, "recording to play")->required();
    CLI::Option* const output = command->add_option(
        "-o,--output", options->output,
        "write it here instead of sending it, as fast as it goes: .ghostdmx, or .show for an OLA show file");
    const auto sending = [&](CLI::Option* option) { return option->excludes(output); };
    sending(command->add_option("--protocol", options->protocol, "sacn or artnet")
                ->check(CLI::IsMember({"sacn", "artnet"}))
                ->capture_default_str());
    sending(command->add_option(
        "--to", options->send.destination,
        "address to send to, IPv4 or (sACN) IPv6; default: sACN multicast, Art-Net broadcast"));
    sending(add_interface_option(*command, options->send.interface,
                                 "network interface for multicast and broadcast"));
    sending(command->add_option("--priority", options->send.priority, "sACN priority")
                ->check(CLI::Range(0, 200))
                ->capture_default_str());
    sending(command
                ->add_option("--rate", options->rate_hz,
                             "a universe that rests is repeated so many times a second; every look goes out "
                             "at its own time (faster "
                             "than it was recorded: no more than so many a second)")
                ->check(number_in(1.0, 200.0))
                ->capture_default_str());
    sending(command->add_flag("--loop", options->loop, "again and again until Ctrl-C"));
    CLI::Option* const from = command->add_option("--from", options->from_s, "start at this time, seconds")
                                  ->check(number_in(0.0, kLongest_s));
    CLI::Option* const until =
        command->add_option("--until", options->until_s, "end at this time, seconds; 0: at its end")
            ->check(number_in(0.0, kLongest_s));
    CLI::Option* const speed =
        command->add_option("--speed", options->speed, "2: twice as fast, 0.5: half as fast")
            ->check(number_in(kSlowest, kFastest))
            ->capture_default_str();
    CLI::Option* const timecode = add_timecode_options(*command, options->timecode, options->midi);
    sending(timecode)->excludes(from)->excludes(until)->excludes(speed)->excludes(
        command->get_option("--loop"));
    command
        ->add_option("--seconds", options->seconds, "of --timecode: end after this time; default: at Ctrl-C")
        ->check(number_in(0.0, kLongest_s))
        ->needs(timecode);
    command
        ->add_option("--artnet-offset", options->send.artnet_offset,
                     "Port-Address = universe - this, in what is sent and in captures")
        ->check(CLI::Range(kLowestArtnetOffset, kHighestArtnetOffset))
        ->capture_default_str();
    add_port_options(*command, options->capture.sacn_port, options->capture.artnet_port);
    command->add_flag("--json", options->json, "print a summary as one JSON object");
    command->add_flag("--quiet", options->quiet, "warnings and errors only");
    command->callback([options, &exit_code] {
        options->capture.artnet_offset = options->send.artnet_offset;
        exit_code = play(*options);
    });
}

} // namespace ghost::app
