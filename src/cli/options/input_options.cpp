// SPDX-License-Identifier: Apache-2.0
#include "cli/options/input_options.h"

#include "base/interrupt.h"
#include "cli/options/interface_option.h"
#include "dmx/record/recording_tasks.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>

namespace ghost::app {

namespace {

constexpr std::size_t kMaxListed = 4096;

bool read_number(std::string_view text, int& value) {
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && end == text.data() + text.size() && value >= 1 &&
           value <= dmx::kMaxUniverse;
}

// One that nobody's Art-Net could ever reach the universes with.
Result<void> check_offset(const InputOptions& options, const dmx::ReceiverOptions& wanted) {
    const int offset = options.artnet_offset;
    if (!wanted.artnet || offset == InputOptions().artnet_offset || wanted.universes.empty()) return {};
    for (const std::uint16_t universe : wanted.universes)
        if (universe >= offset && universe - offset <= dmx::kMaxPortAddress) return {};
    return Error{std::to_string(offset) + " puts all of --universes " + options.universes +
                     " outside of the Port-Addresses 0 to 32767 (universe minus offset)",
                 "--artnet-offset"};
}

} // namespace

void add_port_options(CLI::App& command, std::uint16_t& sacn_port, std::uint16_t& artnet_port) {
    command.add_option("--sacn-port", sacn_port, "UDP port of sACN, on the network and in captures")
        ->check(CLI::Range(1, 65535))
        ->capture_default_str();
    command.add_option("--artnet-port", artnet_port, "UDP port of Art-Net, on the network and in captures")
        ->check(CLI::Range(1, 65535))
        ->capture_default_str();
}

CLI::Option* add_midi_option(CLI::App& command, std::string& port) {
    return command
        .add_option(
            "--midi", port,
            "MIDI port whose time code is followed instead of Art-Net's, like /dev/snd/midiC1D0 (amidi -l "
            "lists them); may be plugged in later")
        ->type_name("PORT");
}

void add_input_options(CLI::App& command, InputOptions& options) {
    add_interface_option(command, options.interface);
    command
        .add_option("--protocols", options.protocols,
                    "what to listen for: sacn, artnet, both or none (--usb)")
        ->check(CLI::IsMember({"sacn", "artnet", "both", "none"}))
        ->capture_default_str();
    command.add_option(
        "--universes", options.universes,
        "universes to join and accept, like 1-4,7, beside those that the show patches; without a show: these "
        "only, default: join 1-64, accept whatever arrives");
    command
        .add_option("--artnet-offset", options.artnet_offset,
                    "universe = Art-Net Port-Address + this (Port-Address 0 is universe 1)")
        ->check(CLI::Range(kLowestArtnetOffset, kHighestArtnetOffset))
        ->capture_default_str();
    command
        .add_option(
            "--artnet-merge", options.artnet_merge,
            "two Art-Net sources on a universe: htp, the highest level, or ltp, the one that changed last")
        ->check(CLI::IsMember({"htp", "ltp"}))
        ->capture_default_str();
    command
        .add_option(
            "--on-loss", options.on_loss,
            "when the last source of a universe is gone: hold its last look, black, or hold it for so "
            "many seconds")
        ->type_name("hold|black|SECONDS")
        ->capture_default_str();
    add_port_options(command, options.sacn_port, options.artnet_port);
    command.add_flag(
        "--show-preview", options.show_preview,
        "where a desk sends packets marked as preview (blind), show these instead of the live ones");
    command.add_option("--preview-universes", options.preview_universes,
                       "like --show-preview, of these universes only, like 1-4,7");
    command.add_flag("--no-poll-reply", options.no_poll_reply, "stay silent: do not answer ArtPoll");
    command
        .add_option(
            "--usb", options.usb,
            "DMX USB Pro at this serial port, like /dev/ttyUSB0=3 for universe 3, or auto; may be plugged in "
            "later, and be given more than once")
        ->type_name("PORT[=UNIVERSE]")
        ->allow_extra_args(false);
}

Result<std::vector<std::uint16_t>> parse_universes(std::string_view text, const std::string& option) {
    std::vector<std::uint16_t> result;
    const Error expected{"universes '" + std::string(text) +
                             "', expected numbers and ranges of 1 to 63999, at most 4096 "
                             "in all, like 1-4,7",
                         option};
    if (text.empty()) return result;
    for (std::string_view left = text;;) {
        const std::size_t comma = left.find(',');
        const std::string_view part = left.substr(0, comma);
        const std::size_t dash = part.find('-');
        int first = 0, last = 0;
        if (!read_number(part.substr(0, dash), first)) return expected;
        last = first;
        if (dash != std::string_view::npos && !read_number(part.substr(dash + 1), last)) return expected;
        if (last < first || result.size() + static_cast<std::size_t>(last - first) >= kMaxListed)
            return expected;
        for (int number = first; number <= last; ++number)
            result.push_back(static_cast<std::uint16_t>(number));
        if (comma == std::string_view::npos) break;
        left.remove_prefix(comma + 1);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

Result<dmx::LossPolicy> parse_loss_policy(const std::string& text) {
    dmx::LossPolicy result;
    if (text == "hold") return result;
    double seconds = 0.0;
    if (text != "black") {
        const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), seconds);
        if (failed != std::errc() || end != text.data() + text.size() ||
            !(seconds >= 0.0 && seconds <= 86400.0))
            return Error{"'" + text + "', expected hold, black or a number of seconds from 0 to 86400",
                         "--on-loss"};
    }
    result.black_after =
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
    return result;
}

Result<std::vector<dmx::UsbPortOptions>> parse_usb_ports(const std::vector<std::string>& texts) {
    std::vector<dmx::UsbPortOptions> result;
    int next = 1;
    for (const std::string& text : texts) {
        const std::size_t equals = text.rfind('=');
        const std::string path = text.substr(0, equals);
        int universe = next;
        const bool numbered =
            equals == std::string::npos || read_number(std::string_view(text).substr(equals + 1), universe);
        if (!numbered || universe > dmx::kMaxUniverse || (path != "auto" && !path.starts_with('/')))
            return Error{"'" + text + "', expected a port and its universe, like /dev/ttyUSB0=1, or auto",
                         "--usb"};
        const auto same = [&](const dmx::UsbPortOptions& other) { return other.path == path; };
        if (std::any_of(result.begin(), result.end(), same))
            return Error{"'" + path + "' is named twice", "--usb"};
        if (result.size() == dmx::kMostUsbPorts)
            return Error{"more than " + std::to_string(dmx::kMostUsbPorts) + " ports", "--usb"};
        result.push_back({path, static_cast<std::uint16_t>(universe)});
        next = universe + 1;
    }
    return result;
}

Result<dmx::ReceiverOptions> receiver_options(const InputOptions& options) {
    dmx::ReceiverOptions result;
    TRY(result.loss, parse_loss_policy(options.on_loss));
    result.artnet_ltp = options.artnet_merge == "ltp";
    result.interface = options.interface;
    result.sacn = options.protocols == "sacn" || options.protocols == "both";
    result.artnet = options.protocols == "artnet" || options.protocols == "both";
    TRY(result.usb, parse_usb_ports(options.usb));
    result.midi = options.midi;
    if (options.protocols == "none" && result.usb.empty() && result.midi.empty() && options.ltc.empty())
        return Error{"nothing to listen to; name a port with --usb", "--protocols none"};
    if (options.protocols == "both") TRY_VOID(dmx::check_ports(options.sacn_port, options.artnet_port));
    TRY(result.universes, parse_universes(options.universes));
    TRY_VOID(check_offset(options, result));
    result.artnet_offset = options.artnet_offset;
    result.sacn_port = options.sacn_port;
    result.artnet_port = options.artnet_port;
    TRY(result.preview_universes, parse_universes(options.preview_universes, "--preview-universes"));
    result.show_preview = options.show_preview || !result.preview_universes.empty();
    if (options.show_preview) result.preview_universes.clear();
    result.answer_polls = !options.no_poll_reply;
    return result;
}

void wait_for_sources(const dmx::Receiver& receiver) {
    while (receiver.sampling() && !interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

dmx::CaptureOptions capture_options(const InputOptions& options) {
    dmx::CaptureOptions result;
    result.sacn_port = options.sacn_port;
    result.artnet_port = options.artnet_port;
    result.artnet_offset = options.artnet_offset;
    result.show_preview = options.show_preview;
    return result;
}

} // namespace ghost::app
