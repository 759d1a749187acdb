// SPDX-License-Identifier: Apache-2.0
// ghostlight play: sends a recording as a desk would, sACN or Art-Net.
#include "app/commands.h"
#include "app/input_options.h"
#include "app/interrupt.h"
#include "app/number_option.h"
#include "base/log.h"
#include "dmx/recording.h"
#include "dmx/sender.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

namespace ghost::app {

namespace {

struct PlayOptions {
    std::string file;
    std::string protocol = "sacn";
    dmx::SenderOptions send;
    double rate_hz = 44.0;
    double from_s = 0.0;
    double to_s = 0.0;
    bool loop = false;
    bool json = false;
    bool quiet = false;
};

int failed(const Error& error) {
    log_error(error.text());
    return 1;
}

int play(PlayOptions options) {
    if (options.quiet) set_log_level(LogLevel::error);
    auto recording = dmx::read_recording(options.file);
    if (!recording.ok()) return failed(recording.error());
    for (const Error& problem : recording->problems) log_warning(problem.text());
    const dmx::Player player(std::move(*recording));
    const double end_s =
        options.to_s > 0.0 ? std::min(options.to_s, player.duration_s()) : player.duration_s();
    if (options.from_s > end_s)
        return failed({"--from " + std::to_string(options.from_s) + " lies behind the end at " +
                           std::to_string(end_s) + " s",
                       options.file});
    options.send.protocol = options.protocol == "sacn" ? dmx::Protocol::sacn : dmx::Protocol::artnet;
    auto sender = dmx::Sender::open(options.send);
    if (!sender.ok()) return failed(sender.error());
    catch_interrupts();

    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const double length_s = end_s - options.from_s;
    for (std::uint64_t tick = 0; !interrupted(); ++tick) {
        const double played_s = static_cast<double>(tick) / options.rate_hz;
        if (!options.loop && played_s > length_s) break;
        std::this_thread::sleep_until(
            start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(played_s)));
        const double t_s = options.from_s + (length_s > 0.0 ? std::fmod(played_s, length_s) : 0.0);
        const bool last = !options.loop && played_s + 1.0 / options.rate_hz > length_s;
        const auto sent = sender->send(player.at(last ? end_s : t_s));
        if (!sent.ok()) return failed(sent.error());
    }
    const auto ended = sender->terminate();
    if (!ended.ok()) return failed(ended.error());
    if (options.json) {
        const nlohmann::ordered_json report{
            {"file", options.file}, {"seconds", length_s}, {"packets", sender->packets()}};
        std::printf("%s\n", report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    }
    log_info(options.file + ": " + std::to_string(sender->packets()) + " packets sent");
    return 0;
}

} // namespace

void add_play(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App* command = app.add_subcommand("play", "send a recording (OLA show file) as sACN or Art-Net");
    command->footer("Example: ghostlight play assets/demo/demo.show --to 127.0.0.1 --loop");
    command->add_option("file", options->file, "recording to play")->required();
    command->add_option("--protocol", options->protocol, "sacn or artnet")
        ->check(CLI::IsMember({"sacn", "artnet"}))
        ->capture_default_str();
    command->add_option("--to", options->send.destination,
                        "IPv4 address to send to; default: sACN multicast, Art-Net broadcast");
    command->add_option("--interface", options->send.interface,
                        "network interface for multicast and broadcast");
    command->add_option("--priority", options->send.priority, "sACN priority")
        ->check(CLI::Range(0, 200))
        ->capture_default_str();
    command->add_option("--artnet-offset", options->send.artnet_offset, "Port-Address = universe - this")
        ->check(CLI::Range(kLowestArtnetOffset, kHighestArtnetOffset))
        ->capture_default_str();
    command->add_option("--rate", options->rate_hz, "refreshes per second of every universe")
        ->check(number_in(1.0, 200.0))
        ->capture_default_str();
    command->add_option("--from", options->from_s, "start at this time, seconds")
        ->check(number_in(0.0, kLongest_s));
    command->add_option("--until", options->to_s, "end at this time, seconds; 0: at its end")
        ->check(number_in(0.0, kLongest_s));
    command->add_flag("--loop", options->loop, "again and again until Ctrl-C");
    command->add_flag("--json", options->json, "print a summary as one JSON object");
    command->add_flag("--quiet", options->quiet, "errors only");
    command->callback([options, &exit_code] { exit_code = play(*options); });
}

} // namespace ghost::app
